# SPDX-License-Identifier: BSD-3-Clause
"""A click on the button beside ParaView's progress bar stops a carving, and the session continues."""
import os
import signal
import stat
import subprocess
import sys
import tempfile
import time
import unittest

import numpy
from Xlib import X, display
from Xlib.ext import xtest

PARAVIEW_COMMAND = sys.argv[1:]
PATIENCE = float(os.environ["PATIENCE"])  # seconds

# On its first run, this helper program reports progress and never ends. Later runs start the real one.
HELPER = """#!/bin/sh
[ -e "{folder}/pid" ] && exec "{helper}"
echo $$ > "{folder}/new" && mv "{folder}/new" "{folder}/pid"
echo '@progress 3 1000' >&2
exec sleep 100000
"""


def is_running(pid):
    try:
        with open("/proc/%s/stat" % pid) as status:
            return status.read().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


def stop_button(screen):
    """The center of the only red area in the status bar of the main window."""
    windows = [w.get_geometry() for w in screen.root.query_tree().children
               if w.get_attributes().map_state == X.IsViewable]
    window = max(windows, key=lambda w: w.width * w.height)
    height = 35
    top = window.y + window.height - height
    image = screen.root.get_image(window.x, top, window.width, height, X.ZPixmap, 0xFFFFFFFF)
    blue, green, red = numpy.frombuffer(image.data, "u1").reshape(height, -1, 4)[..., :3].astype(int).transpose(2, 0, 1)
    y, x = numpy.nonzero(red - numpy.maximum(green, blue) > 100)
    return (window.x + int(x.mean()), top + int(y.mean())) if len(x) else None


def click(server, x, y):
    xtest.fake_input(server, X.MotionNotify, x=x, y=y)
    for event in (X.ButtonPress, X.ButtonRelease):
        xtest.fake_input(server, event, 1)
    server.sync()


class TestStop(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.helper = os.path.join(folder.name, "helper")
        with open(self.helper, "w") as script:
            script.write(HELPER.format(folder=folder.name, helper=os.environ["TOPOLOGYCARVING_HELPER"]))
        os.chmod(self.helper, stat.S_IRWXU)
        self.log = os.path.join(folder.name, "log")
        self.pid_file = os.path.join(folder.name, "pid")
        self.addCleanup(self.end_helper)
        with open(self.log, "w") as log:
            self.paraview = subprocess.Popen(
                PARAVIEW_COMMAND, env=dict(os.environ, TOPOLOGYCARVING_HELPER=self.helper),
                stdout=log, stderr=subprocess.STDOUT)
        self.addCleanup(self.paraview.wait)
        self.addCleanup(self.paraview.kill)

    def output(self):
        with open(self.log) as log:
            return log.read()

    def helper_pid(self):
        try:
            with open(self.pid_file) as pid_file:
                return int(pid_file.read())
        except FileNotFoundError:
            return None

    def end_helper(self):
        pid = self.helper_pid()
        if pid and is_running(pid):
            os.kill(pid, signal.SIGKILL)

    def wait_for(self, what, look):
        """Calls `look` until its result is true, and returns it. Fails if time is up or ParaView has ended."""
        end = time.monotonic() + PATIENCE
        while True:
            over = self.paraview.poll() is not None or time.monotonic() > end
            seen = look()
            if seen:
                return seen
            if over:
                self.fail(f"waited in vain for {what}; ParaView's exit code is {self.paraview.poll()}\n{self.output()}")
            time.sleep(0.05)

    def test_stop(self):
        """The click terminates the helper program, with a warning, and the session continues to its end."""
        pid = self.wait_for("the helper program to be started", self.helper_pid)
        server = display.Display()
        self.addCleanup(server.close)
        button = self.wait_for("the button to become red", lambda: stop_button(server.screen()))
        click(server, *button)
        self.wait_for("the helper program to end", lambda: not is_running(pid))
        self.wait_for("ParaView to end", lambda: self.paraview.poll() is not None)
        self.assertEqual(self.paraview.returncode, 0, self.output())
        self.assertIn("The carving was stopped.", self.output())


if __name__ == "__main__":
    unittest.main(argv=["test"], verbosity=2)
