#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the C++ sources against the table of rooms in Documentation/architecture.md.

Each folder with C++ sources in Filters, Readers, Plugins and Testing/Cxx is a room and has a row in
the table. A row names the rooms whose headers the room may include, and the libraries that it may
use. The rooms have no cycle.

Usage: check_rooms.py [ROOT]     Prints each violation and exits with 1 if there is one.
"""

import re
import sys
from fnmatch import fnmatchcase
from pathlib import Path

FOLDERS = ("Filters", "Readers", "Plugins", "Testing/Cxx")
ROW = re.compile(r"^\| `([\w/]+)` \|([^|]*)\|([^|]*)\|[^|]*\|$", re.MULTILINE)
INCLUDE = re.compile(r'^#include [<"]([^>"]+)[>"]', re.MULTILINE)
# By the beginning of the header's name.
LIBRARIES = {"ParaView": r"pq|vtkSM|vtkPV", "VTK": r"vtk", "TBB": r"tbb/", "Embree": r"embree\d/",
             "omniORB": r"omni", "Qt": r"Q[A-Z]", "Random123": r"Random123/"}


class Room:
    """A folder, the rooms that it may include, and the libraries that it may use."""

    def __init__(self, name, arrows, libraries):
        self.name = name
        self.arrows = re.findall(r"`([\w/*]+)`", arrows)
        self.libraries = set(re.findall(r"\w+", libraries))

    def may_include(self, other):
        """In an arrow, * stands for any subfolders."""
        return other == self.name or any(fnmatchcase(other, arrow) for arrow in self.arrows)


def read_rooms(text):
    return {name: Room(name, arrows, libraries) for name, arrows, libraries in ROW.findall(text)}


def list_sources(root):
    """All C++ files, relative to the root."""
    return sorted(path.relative_to(root) for folder in FOLDERS for path in (root / folder).rglob("*")
                  if path.suffix in (".h", ".cxx", ".inl"))


def get_library(include):
    return next((name for name, start in LIBRARIES.items() if re.match(start, include)), None)


def names_room(include, target, source):
    """Headers of the same room, and of a room without a parent, may be written without a room."""
    is_near = target.parent == source.parent or len(target.parts) == 2
    return f"/{target.as_posix()}".endswith(f"/{include}") and ("/" in include or is_near)


def check_file(path, text, room, headers):
    """Yields the violations of one file."""
    for include in INCLUDE.findall(text):
        target = headers.get(Path(include).name)
        if target is not None:
            if not names_room(include, target, path):
                yield f'{path}: "{include}" is at {target}; write the room'
            if not room.may_include(target.parent.as_posix()):
                yield f"{path}: {room.name} may not include {target}"
            continue
        library = get_library(include)
        if library and library not in room.libraries:
            yield f"{path}: {room.name} may not use {library} ({include})"


def find_cycle(rooms):
    """A room that reaches itself by its arrows, or None."""
    for start in rooms:
        seen, todo = set(), [start]
        while todo:
            room = rooms[todo.pop()]
            for other in rooms:
                if other != room.name and room.may_include(other) and other not in seen:
                    seen.add(other)
                    todo.append(other)
        if start in seen:
            return start
    return None


def find_violations(root):
    rooms = read_rooms((root / "Documentation/architecture.md").read_text(encoding="utf-8"))
    sources = list_sources(root)
    headers = {path.name: path for path in sources if path.suffix != ".cxx"}
    for path in sources:
        if headers.get(path.name, path) != path:
            yield f"{path}: {headers[path.name]} has the same name"
    cycle = find_cycle(rooms)
    if cycle:
        yield f"{cycle}: its arrows lead back to itself"
    for name in sorted(rooms.keys() - {path.parent.as_posix() for path in sources}):
        yield f"{name}: a row of the table, and no such room"
    for path in sources:
        room = rooms.get(path.parent.as_posix())
        if room is None:
            yield f"{path}: its folder has no row in the table of rooms"
            continue
        yield from check_file(path, (root / path).read_text(encoding="utf-8"), room, headers)


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2]).resolve()
    violations = list(find_violations(root))
    print("\n".join(violations) or "Every include follows the table of rooms.")
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
