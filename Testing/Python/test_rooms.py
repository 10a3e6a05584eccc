# SPDX-License-Identifier: BSD-3-Clause
"""The includes of the sources, against the table of which room (folder) may use which.

ROOT is the folder of the sources."""
import glob
import os
import re
import unittest

ROOT = os.environ["ROOT"]

# Each room and the rooms that it may include from, which all stand above it in this table.
ROOMS = {
    "Core/Mesh": "",
    "Core/Solid": "Core/Mesh",
    "Core/Budget": "Core/Mesh",
    "Core/Carving": "Core/Mesh Core/Solid Core/Budget",
    "Core/Stream": "Core/Mesh Core/Solid Core/Carving",
    "Core/Surface": "Core/Mesh Core/Stream",
    "Core/Measure": "Core/Mesh Core/Solid Core/Carving Core/Stream",
    "Core/Protocol": "Core/Mesh Core/Solid Core/Stream",
    "Helper/Base": "Core/Mesh",
    "Helper/Resolve": "Core/Mesh Core/Solid Helper/Base",
    "Helper/Exact": "Core/Mesh Helper/Base Helper/Resolve",
    "Helper/Enclosing": "Core/Mesh Helper/Base",
    "Helper/Cutting": "Core/Mesh Helper/Enclosing",
    "Helper/Recovery": "Core/Mesh Helper/Base Helper/Resolve Helper/Enclosing Helper/Cutting",
    "Helper/Decimation": "Core/Mesh Core/Stream Core/Protocol Helper/Base Helper/Resolve Helper/Enclosing",
    "Helper/Plane": "Core/Mesh Core/Protocol Helper/Base",
    "Helper/Attempts": "Core/Mesh Core/Protocol Helper/Base Helper/Resolve Helper/Exact Helper/Recovery",
    "Helper": "Core/Mesh Core/Solid Core/Protocol Helper/Resolve Helper/Exact Helper/Decimation Helper/Plane Helper/Attempts",
    "System": "",
    "Process": "Core/Protocol System",
    "Convert": "Core/Mesh Core/Stream Core/Surface Core/Measure",
    "Objects": "Convert",
    "Session": "Core/Mesh Core/Carving Core/Stream Core/Surface Core/Measure Core/Protocol Process Convert Objects",
    "": "Core/Measure Process Convert Objects Session",
}
# Programs and plugins see the public headers alone, besides their own and those of the room System.
OUTSIDE = ("Examples/Cxx", "Plugin", "Plugin/Classes")


def sources(folder):
    return sorted(glob.glob(os.path.join(ROOT, folder, "*.h")) + glob.glob(os.path.join(ROOT, folder, "*.cxx")))


def includes(path):
    """The project's headers that a file includes: all in quotes except VTK's and ParaView's."""
    with open(path, encoding="utf-8") as file:
        headers = re.findall(r'#include "([^"]+)"', file.read())
    return [header for header in headers
            if os.path.exists(os.path.join(ROOT, "Filters", header)) or not re.match(r"vtk|pq", header)]


class Rooms(unittest.TestCase):
    def test_includes_follow_the_table(self):
        """No include points upward or sideways, and the table has no arrow that nothing follows."""
        followed = {room: set() for room in ROOMS}
        for room, allowed in ROOMS.items():
            for path in sources(os.path.join("Filters", room)):
                for header in includes(path):
                    target = os.path.dirname(header)
                    self.assertTrue(os.path.exists(os.path.join(ROOT, "Filters", header)), f"{path}: {header}")
                    if target != room:
                        self.assertIn(target, allowed.split(), f"{path} includes {header}")
                        followed[room].add(target)
        self.assertEqual(followed, {room: set(allowed.split()) for room, allowed in ROOMS.items()})

    def test_arrows_point_up_the_table(self):
        """A room includes from rooms above it only, so that there are no cycles."""
        above = set()
        for room, allowed in ROOMS.items():
            self.assertLessEqual(set(allowed.split()), above, room)
            above.add(room)

    def test_every_folder_is_a_room(self):
        """No source of the module lies outside of the rooms of the table."""
        folders = {os.path.relpath(folder, os.path.join(ROOT, "Filters"))
                   for folder, _, files in os.walk(os.path.join(ROOT, "Filters"))
                   if any(name.endswith((".h", ".cxx")) for name in files)}
        self.assertEqual({folder.replace(".", "") for folder in folders}, set(ROOMS))

    def test_programs_see_public_headers_only(self):
        """The program and the plugin include no header of a room other than System."""
        for folder in OUTSIDE:
            for path in sources(folder):
                for header in includes(path):
                    self.assertTrue(any(os.path.exists(os.path.join(ROOT, own, header))
                                        for own in OUTSIDE + ("Filters",) if "/" not in header) or
                                    header.startswith("System/"),
                                    f"{path} includes {header}")


if __name__ == "__main__":
    unittest.main()
