# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The second table of chart B: maps of the room from scans with the errors of a device."""

from tables import read, to_markdown, to_number

NAME = "B-mapping"
FILE = f"{NAME}-damage.csv"
COLUMNS = {"open triangles": "triangles, gaps open", "open ms": "ms, gaps open",
           "triangles": "triangles", "ms": "ms", "x ideal": "x ideal",
           "to scene mean mm": "map to scene, mm", "to map mean mm": "scene to map, mm",
           "free space m2": "in free space, m2"}


def make_sections(folder):
    """Return the heading and the table of a folder, nothing if they were not measured."""
    if not (folder / FILE).exists():
        return []
    return [("Room, errors of a device", to_markdown(
        ["errors", "bound, mm", *COLUMNS.values()],
        [[row["errors"], row["bound mm"], *(to_number(row[key]) for key in COLUMNS)]
         for row in read(folder / FILE)]))]
