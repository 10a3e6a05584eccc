# SPDX-License-Identifier: BSD-3-Clause
"""The README lists all errors, warnings and notes of the filters and the helper program.

Environment variables name the folder of the sources (ROOT), the one with the messages that the tests of the filters
have provoked (MESSAGES), and the command-line program (CARVE).
"""
import glob
import os
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = os.environ["ROOT"]
CARVE = os.environ["CARVE"]

# Quotes in the table that no test here can provoke, and the reason.
NOT_PROVOKED = {
    "The input has more points or cells than a 32-bit integer can count": "would need a mesh of 100 GB",
    "Error parsing XML in stream at line N": "a message of ParaView",
    "not well-formed": "a message of ParaView",
    "junk after document element": "a message of ParaView",
    "The carving was stopped": "the plugin's tests press ParaView's button",
    "N object(s) were spread over several processes": "the plugin's tests run several processes under MPI",
}
# Parts of messages that depend on TetGen's success with a mesh, or on the system.
ENDS_OF_ATTEMPTS = ("TetGen ", "recovery lacks ", "crashed", "of processor time", "was killed", "could not be started")
if os.environ["PORTABLE"] == "ON":  # memory is not limited
    NOT_PROVOKED["carving-helper ran out of memory"] = "needs a limit"
    ENDS_OF_ATTEMPTS += ("ran out of memory",)

# Literals that begin like a sentence but are names in field data.
NAMES = {
    "TetGen -pcY", "TetGen -pcY, order ", "TetGen -pcY, without interior", "TetGen -pcY, snapped", "TetGen -pc",
    "TetGen -pc, snapped", "Delaunay, enclosing", "Delaunay, recovery", "CGAL constrained Delaunay", "LOD "}


def read(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read()


def quoted():
    """The table's quotes: beginnings of messages in the first column, parts of messages in the second."""
    table = read("README.md").split("## Messages and their meaning")[1].split("\n## ")[0]
    columns = [[], []]
    for row in re.findall(r"^\| (.*) \|$", table, re.M):
        for column, cell in zip(columns, row.split(" | ")):
            column += re.findall(r"\*([^*\n]+)\*", cell)
    return columns


def pattern(quote):
    """The regular expression of a quote up to its first variable text, with N for a number and X for a name."""
    text = re.escape(re.split(r"…|(?<=\()", quote)[0])
    return re.sub(r"\bvtkX\b|\bX\b", r"\\S*", re.sub(r"\bN\b", r"[-+.\\de]+", text)).rstrip("\\ ")


def is_listed(message):
    """Whether a message begins with a quote, or contains a quote that starts with a lower-case letter."""
    return any(re.search(pattern(quote) if quote[0].islower() else r"\A" + pattern(quote), message)
               for quote in quoted()[0])


def messages_of_tests():
    """The errors, warnings and notes that the tests of the filters have provoked."""
    messages = set()
    for name in glob.glob(os.path.join(os.environ["MESSAGES"], "*")):
        with open(name, encoding="utf-8") as file:
            # VTK writes the place in the source and the address of the filter before an error.
            messages |= {re.sub(r"\A(ERROR|Warning): .*?\(0x\w+\): ", "", text, flags=re.S).strip()
                         for text in file.read().split("\0")[:-1]}
    return messages


def message_of_carve(*arguments, **environment):
    run = subprocess.run([CARVE, *arguments], capture_output=True, text=True, env={**os.environ, **environment})
    return run.stderr.removeprefix("carve: ").strip()


def message_without_helper(folder, mesh):
    """The message of a library that is neither where it was built nor where it was installed."""
    for library in glob.glob(os.path.join(os.path.dirname(CARVE), "..", "lib", "libvtkTopologyCarving.so*")):
        shutil.copy(library, folder)
    return message_of_carve(mesh, LD_LIBRARY_PATH=folder)


class TestProvokedMessages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        bones = os.path.join(os.environ["MESHES"], "bones.off")
        with tempfile.TemporaryDirectory() as folder:
            cls.messages = messages_of_tests()
            cls.messages.add(message_without_helper(folder, bones))
            cls.messages.add(message_of_carve(bones, "--profile", os.path.join(folder, "a.png"), DISPLAY=":7654"))

    def test_are_listed(self):
        """Every message of a filter in a test is in the table."""
        for message in self.messages:
            self.assertTrue(is_listed(message), message)

    def test_are_all_that_is_listed(self):
        """Every quote in the table occurs in a message of a test, except those that no test can provoke."""
        beginnings, parts = quoted()
        for quote in beginnings + parts:
            said = any(re.search(pattern(quote), message) for message in self.messages)
            with self.subTest(quote=quote):
                if quote in NOT_PROVOKED:
                    self.assertFalse(said, "it can be provoked")
                elif not quote.startswith(ENDS_OF_ATTEMPTS):
                    self.assertTrue(said)
        self.assertLessEqual(set(NOT_PROVOKED), set(beginnings))


def beginnings_in(source):
    """The literals that begin a sentence of several words. Adjacent literals are joined."""
    source = re.sub(r"//[^\n]*|#include[^\n]*|/\*.*?\*/", "", source, flags=re.S)
    source = re.sub(r'"\s*"', "", source)
    literals = re.findall(r'"((?:[^"\\]|\\.)*)"', source)
    # PrintSelf writes a name, a colon and a value.
    return {text for text in literals if re.match(r"[A-Z].* ", text) and not re.fullmatch(r"\w+: ", text)} - NAMES


class TestMessagesInTheSource(unittest.TestCase):
    """Covers messages that no test provokes."""

    def test_are_listed(self):
        """Every sentence in the code's literals is in the table."""
        known = [re.split(r"\bN\b|\bX\b|vtkX|…|\(", quote)[0] for column in quoted() for quote in column]
        names = set(glob.glob(os.path.join(ROOT, "Filters", "**", "*.cxx"), recursive=True))
        # The help texts of the properties are no messages.
        for name in sorted(names - {os.path.join(ROOT, "Filters", "vtkCarverProperty.cxx")}):
            for message in beginnings_in(read(name)):
                with self.subTest(file=os.path.relpath(name, ROOT), message=message):
                    self.assertTrue(
                        any(begin.startswith(message.strip()) or (message.startswith(begin) and begin.count(" ") > 2)
                            for begin in known),
                        'list it under "Messages and their meaning"')


if __name__ == "__main__":
    unittest.main()
