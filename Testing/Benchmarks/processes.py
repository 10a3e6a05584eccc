# SPDX-License-Identifier: BSD-3-Clause
"""Running a program and measuring it."""
import dataclasses
import os
import resource
import subprocess
import threading
import time

INTERVAL = 0.01  # seconds between looks at the memory of the processes


@dataclasses.dataclass
class Run:
    output: str
    seconds: float
    processor_seconds: float  # of the program and of all processes that it started
    own_peak: int  # bytes
    helper_peak: int  # bytes: the largest of the processes that the program started


def peak_of(pid):
    """The most memory that a process has had so far, in bytes."""
    try:
        with open(f"/proc/{pid}/status", encoding="ascii") as file:
            return next((1024 * int(line.split()[1]) for line in file if line.startswith("VmHWM")), 0)
    except OSError:
        return 0  # it has ended


def descendants(pid):
    found = []
    try:
        for thread in os.listdir(f"/proc/{pid}/task"):
            with open(f"/proc/{pid}/task/{thread}/children", encoding="ascii") as file:
                for child in file.read().split():
                    found += [child, *descendants(child)]
    except OSError:
        pass
    return found


class MemoryWatch(threading.Thread):
    """Looks at a process and its descendants until they end. A peak is that of the last look."""

    def __init__(self, process):
        super().__init__()
        self.process = process
        self.own = self.helper = 0
        self.start()

    def run(self):
        while self.process.returncode is None:
            self.own = max(self.own, peak_of(self.process.pid))
            self.helper = max([self.helper, *map(peak_of, descendants(self.process.pid))])
            time.sleep(INTERVAL)


def run(command, patience):
    """Runs a program. Raises an error if it fails, or takes more seconds than `patience`."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.perf_counter()
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
        watch = MemoryWatch(process)
        try:
            output = process.communicate(timeout=patience)[0]
            seconds = time.perf_counter() - start
        finally:
            process.kill()
            process.wait()
            watch.join()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if process.returncode != 0:
        raise subprocess.CalledProcessError(process.returncode, command, output)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return Run(output, seconds, used, watch.own, watch.helper)
