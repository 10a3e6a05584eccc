# SPDX-License-Identifier: BSD-3-Clause
"""The machine on which something is measured, and the versions of the programs."""
import os
import re
import subprocess

PACKAGES = ("libvtk9-dev", "libcgal-dev", "libtet1.5-dev", "tetgen", "g++")


def first_match(path, pattern):
    with open(path, encoding="utf-8") as file:
        found = re.search(pattern, file.read(), re.MULTILINE)
    return found[1] if found else "unknown"


def output_of(*command):
    return subprocess.run(command, check=False, capture_output=True, text=True).stdout.strip()


def load():
    """The mean number of processes that wanted to run in the last minute."""
    return os.getloadavg()[0]


def describe(root):
    """Lines about the machine and the versions. `root` is the folder of the sources."""
    memory = int(first_match("/proc/meminfo", r"^MemTotal:\s+(\d+)")) / 2**20
    packages = [f"{name} {output_of('dpkg-query', '-W', '-f', '${Version}', name)}" for name in PACKAGES]
    return [
        f"processor: {first_match('/proc/cpuinfo', r'^model name.*: (.*)$')}, "
        f"{len(os.sched_getaffinity(0))} cores, {memory:.0f} GiB of memory",
        f"system: {first_match('/etc/os-release', '^PRETTY_NAME=.(.*).$')}, Linux {os.uname().release}",
        f"packages: {', '.join(packages)}",
        f"commit: {output_of('git', '-C', root, 'describe', '--always', '--dirty')}"]
