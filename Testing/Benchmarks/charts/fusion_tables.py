# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The second table of chart G: Open3D's maps of the first poses, beside ours."""

from tables import read, to_markdown, to_number

NAME = "G-fusion"
FILE = f"{NAME}-peers.csv"
COLUMNS = {"pose ms": "ms a pose", "mesh ms": "ms for the mesh", "triangles": "triangles",
           "to scene mean mm": "map to scene, mm", "to scene 95% mm": "95 %, mm",
           "complete %": "complete %", "free space m2": "in free space, m2",
           "kB a pose": "kB to a client for the last pose"}


def make_sections(folder):
    """Return the heading and the table of a folder, nothing if they were not measured."""
    if not (folder / FILE).exists():
        return []
    return [("Beside Open3D", to_markdown(
        ["map", "threads", "poses", *COLUMNS.values()],
        [[row["map"], row["threads"], row["poses"],
          *(to_number(row[key], 3) for key in COLUMNS)]
         for row in read(folder / FILE)]))]
