# SPDX-License-Identifier: BSD-3-Clause
"""What the filters and the helper program say, against the README's table of errors, warnings and notes.

ROOT is the folder of the sources, FILTER_TESTS the program with the tests of the filters, CARVE the command-line program."""
import glob
import os
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = os.environ["ROOT"]
CARVE = os.environ["CARVE"]

# What the table quotes, but no test here can provoke, and why.
NOT_PROVOKED = {
    "The input has more points or cells than a 32-bit integer can count": "a mesh of 100 GB would be needed",
    "Error parsing XML in stream at line N": "ParaView's own",
    "not well-formed": "ParaView's own",
    "junk after document element": "ParaView's own",
    "The carving was stopped": "by ParaView's button: the plugin's tests press it",
    "N object(s) were spread over several processes": "under MPI: the plugin's tests run several processes",
}
# Parts of messages that depend on how TetGen fares with a mesh, or the system with a process.
ENDS_OF_ATTEMPTS = ("TetGen ", "crashed", "of processor time", "was killed", "could not be started")

# Literals that begin like a sentence, but are names in field data.
NAMES = {"TetGen -pcY", "TetGen -pcY, order ", "TetGen -pcM", "TetGen -pcY, snapped", "TetGen -pcY, without interior", "Delaunay, enclosing", "CGAL constrained Delaunay", "LOD "}


def read(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read()


def quoted():
    """What the table quotes: of its first column, with which messages begin, and of the second, parts of them."""
    table = read("README.md").split("## Messages and their meaning")[1].split("\n## ")[0]
    columns = [[], []]
    for row in re.findall(r"^\| (.*) \|$", table, re.M):
        for column, cell in zip(columns, row.split(" | ")):
            column += re.findall(r"\*([^*\n]+)\*", cell)
    return columns


def pattern(quote):
    """Of a quote up to what varies altogether, N for a number and X for a name."""
    text = re.escape(re.split(r"…|(?<=\()", quote)[0])
    return re.sub(r"\bvtkX\b|\bX\b", r"\\S*", re.sub(r"\bN\b", r"[-+.\\de]+", text)).rstrip("\\ ")


def is_listed(message):
    """A quote that begins in the middle of a sentence is looked for in the message, any other at its beginning."""
    return any(re.search(pattern(quote) if quote[0].islower() else r"\A" + pattern(quote), message)
               for quote in quoted()[0])


def messages_of_tests(folder):
    """All errors, warnings and notes that the tests of the filters provoke."""
    log = os.path.join(folder, "log")
    run = subprocess.run([os.environ["FILTER_TESTS"], "--gtest_filter=-Image.*"], capture_output=True, text=True,
                         env={**os.environ, "TOPOLOGYCARVING_MESSAGE_LOG": log})
    if run.returncode != 0:
        raise AssertionError("tests failed:\n" + "\n".join(re.findall(r"^\[  FAILED.*", run.stdout, re.M)))
    with open(log, encoding="utf-8") as file:
        # VTK puts the place in the source and the filter's address before an error.
        return {re.sub(r"\A(ERROR|Warning): .*?\(0x\w+\): ", "", text, flags=re.S).strip()
                for text in file.read().split("\0")[:-1]}


def message_of_carve(*arguments, **environment):
    run = subprocess.run([CARVE, *arguments], capture_output=True, text=True, env={**os.environ, **environment})
    return run.stderr.removeprefix("carve: ").strip()


def message_without_helper(folder, mesh):
    """That of a library in another place than it was built or installed."""
    for library in glob.glob(os.path.join(os.path.dirname(CARVE), "..", "lib", "libvtkTopologyCarving.so*")):
        shutil.copy(library, folder)
    return message_of_carve(mesh, LD_LIBRARY_PATH=folder)


class TestProvokedMessages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        bones = os.path.join(os.environ["MESHES"], "bones.off")
        with tempfile.TemporaryDirectory() as folder:
            cls.messages = messages_of_tests(folder)
            cls.messages.add(message_without_helper(folder, bones))
            cls.messages.add(message_of_carve(bones, "--profile", os.path.join(folder, "a.png"), DISPLAY=":7654"))

    def test_are_listed(self):
        """Whatever a filter says in a test begins like a message of the table."""
        for message in self.messages:
            self.assertTrue(is_listed(message), message)

    def test_are_all_that_is_listed(self):
        """Whatever the table quotes has been said, but for what cannot be provoked."""
        beginnings, parts = quoted()
        for quote in beginnings + parts:
            said = any(re.search(pattern(quote), message) for message in self.messages)
            with self.subTest(quote=quote):
                if quote in NOT_PROVOKED:
                    self.assertFalse(said, "it can be provoked")
                elif not (quote.startswith(ENDS_OF_ATTEMPTS)):
                    self.assertTrue(said)
        self.assertLessEqual(set(NOT_PROVOKED), set(beginnings))


def beginnings_in(source):
    """The literals that begin a sentence of several words; literals side by side are one."""
    source = re.sub(r"//[^\n]*|#include[^\n]*|/\*.*?\*/", "", source, flags=re.S)
    source = re.sub(r'"\s*"', "", source)
    literals = re.findall(r'"((?:[^"\\]|\\.)*)"', source)
    # PrintSelf writes a name, a colon and a value.
    return {text for text in literals if re.match(r"[A-Z].* ", text) and not re.fullmatch(r"\w+: ", text)} - NAMES


class TestMessagesInTheSource(unittest.TestCase):
    """A second net, for messages that no test provokes."""

    def test_are_listed(self):
        """Whatever begins a sentence in the code begins a message in the table."""
        known = [re.split(r"\bN\b|\bX\b|vtkX|…|\(", quote)[0] for column in quoted() for quote in column]
        for name in sorted(glob.glob(os.path.join(ROOT, "Filters", "**", "*.cxx"), recursive=True)):
            for message in beginnings_in(read(name)):
                with self.subTest(file=os.path.relpath(name, ROOT), message=message):
                    self.assertTrue(
                        any(begin.startswith(message.strip()) or (message.startswith(begin) and begin.count(" ") > 2)
                            for begin in known),
                        'list it under "Messages and their meaning"')


if __name__ == "__main__":
    unittest.main()
