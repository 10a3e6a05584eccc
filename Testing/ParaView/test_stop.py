# SPDX-License-Identifier: BSD-3-Clause
"""A click on the button beside ParaView's progress bar stops a carving at once, and the session goes on."""
import os
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
PATIENCE = 60.0  # seconds; none of what is waited for should take more than a few

# The helper program that the first carving meets reports progress and never ends.
HELPER = """#!/bin/sh
[ -e "{folder}/pid" ] && exec "{helper}"
echo $$ > "{folder}/new" && mv "{folder}/new" "{folder}/pid"
echo '@progress 2 0.1' >&2
exec sleep 1000
"""


def wait_for(condition):
    """The condition's value, once it is true."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(0.05)
    raise TimeoutError(condition.__doc__)


def is_running(pid):
    try:
        with open("/proc/%s/stat" % pid) as status:
            return status.read().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


def stop_button(screen):
    """The middle of the one red thing in the main window's status bar."""
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
    def test_stop(self):
        with tempfile.TemporaryDirectory() as folder:
            helper = os.path.join(folder, "helper")
            with open(helper, "w") as script:
                script.write(HELPER.format(folder=folder, helper=os.environ["TOPOLOGYCARVING_HELPER"]))
            os.chmod(helper, stat.S_IRWXU)
            with subprocess.Popen(
                PARAVIEW_COMMAND, env=dict(os.environ, TOPOLOGYCARVING_HELPER=helper),
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as paraview:
                self.addCleanup(paraview.kill)
                wait_for(lambda: os.path.exists(os.path.join(folder, "pid")))
                with open(os.path.join(folder, "pid")) as pid_file:
                    pid = pid_file.read().strip()
                server = display.Display()
                click(server, *wait_for(lambda: stop_button(server.screen())))
                wait_for(lambda: not is_running(pid))
                output, _ = paraview.communicate(timeout=PATIENCE)
        self.assertEqual(paraview.returncode, 0, output)
        self.assertIn("The carving was stopped.", output)


if __name__ == "__main__":
    unittest.main(argv=["test"], verbosity=2)
