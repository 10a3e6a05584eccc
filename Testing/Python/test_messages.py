# SPDX-License-Identifier: BSD-3-Clause
"""What the filters and the helper program say, against the README's table. ROOT is the folder of the sources."""
import glob
import os
import re
import unittest

ROOT = os.environ["ROOT"]

# Names of rungs, which field data holds.
NO_MESSAGES = {"TetGen -pcY", "TetGen -pcY, order ", "TetGen -pcM", "TetGen -pcY, snapped", "TetGen -pcY, without interior", "Delaunay, enclosing", "CGAL constrained Delaunay", "LOD "}


def read(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read()


def beginnings(source):
    """The literals that begin a sentence of several words; literals side by side are one."""
    source = re.sub(r"//[^\n]*|#include[^\n]*|/\*.*?\*/", "", source, flags=re.S)
    source = re.sub(r'"\s*"', "", source)
    literals = re.findall(r'"((?:[^"\\]|\\.)*)"', source)
    # PrintSelf writes a name, a colon and a value.
    return {text for text in literals if re.match(r"[A-Z].* ", text) and not re.fullmatch(r"\w+: ", text)} - NO_MESSAGES


def listed():
    """How the messages of the table begin, up to what varies."""
    table = read("README.md").split("## Errors and their meaning")[1].split("\n## ")[0]
    quotes = re.findall(r"\*([^*\n]+)\*", table)
    return [re.split(r"\bN\b|\bX\b|vtkX|…|\(", quote)[0] for quote in quotes]


def is_listed(message, known):
    """Either begins with the other; a few words in common are not enough."""
    message = message.strip()
    return any(begin.startswith(message) or (message.startswith(begin) and begin.count(" ") > 2) for begin in known)


class TestMessages(unittest.TestCase):
    def test_every_message_is_in_the_readme(self):
        """Whatever begins a sentence in the code begins a message in the table."""
        known = listed()
        found = 0
        for name in sorted(glob.glob(os.path.join(ROOT, "Filters", "**", "*.cxx"), recursive=True)):
            for message in beginnings(read(name)):
                found += 1
                with self.subTest(file=os.path.relpath(name, ROOT), message=message):
                    self.assertTrue(is_listed(message, known), "list it under \"Errors and their meaning\"")
        self.assertGreater(found, 25)

    def test_a_new_message_would_be_found(self):
        """Neither a sentence that nobody lists nor one that begins like a listed one gets by."""
        known = listed()
        for source in ('return "The dog ate the mesh.";', 'error << "A " << name << "x"; s = "A mesh " "is gone"'):
            self.assertFalse(all(is_listed(message, known) for message in beginnings(source)), source)


if __name__ == "__main__":
    unittest.main()
