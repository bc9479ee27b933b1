# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The pieces of a scene file, read as its generator writes them, without the package lms3d.

The scenes are in the folder LMS3D_DATA_DIR, by default in ../../Data.
"""

import os
import re
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

import numpy as np

DATA = Path(os.environ.get("LMS3D_DATA_DIR") or Path(__file__).resolve().parents[2] / "Data")

# One piece in the layout of the generators; the translation is optional.
PIECE = re.compile(
    r"(?:Transform \{\s+translation (?P<translation>[^\n]+)\n\s+children \[\s+)?"
    r"DEF (?P<name>\w+) Shape \{.*?"
    r"diffuseColor (?P<colour>[^}]+) \}.*?"
    r"solid (?P<solid>TRUE|FALSE)\s.*?"
    r"point \[(?P<points>[^\]]*)\].*?"
    r"coordIndex \[(?P<faces>[^\]]*)\]",
    re.DOTALL,
)


class Mesh:
    """One Shape of a scene, in world coordinates."""

    def __init__(self, match):
        self.name = match["name"]
        self.solid = match["solid"] == "TRUE"
        self.colour = [float(word) for word in match["colour"].split()]
        translation = [float(word) for word in (match["translation"] or "0 0 0").split()]
        self.points = translation + np.array([p.split() for p in match["points"].split(",")], float)
        *faces, self.rest = re.split(r"-1,?", match["faces"])
        self.faces = [[int(index) for index in face.split(",") if index.strip()] for face in faces]
        fans = [(f[0], f[i], f[i + 1]) for f in self.faces for i in range(1, len(f) - 1)]
        self.triangles = np.array(fans)

    def corners(self):
        """The triangles' corners, an array (triangle, corner, axis)."""
        return self.points[self.triangles]

    def areas(self):
        """The area of each triangle."""
        a, b, c = np.moveaxis(self.corners(), 1, 0)
        return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2

    def bodies(self):
        """The separate bodies of the piece, each as its triangles' corners."""
        labels, before = np.arange(len(self.points)), None
        while not np.array_equal(labels, before):
            before = labels.copy()
            lowest = before[self.triangles].min(axis=1)
            np.minimum.at(labels, self.triangles, lowest[:, None])
        of_triangle = labels[self.triangles[:, 0]]
        return [self.corners()[of_triangle == label] for label in np.unique(labels)]

    def volumes(self):
        """The volume of each body, negative if the faces turn inwards. A cone from the centre
        to the border closes an open body."""
        centred = [corners - corners.mean(axis=(0, 1)) for corners in self.bodies()]
        return [np.linalg.det(corners).sum() / 6 for corners in centred]

    def directed_edges(self):
        """The number of times that each edge is used in each direction."""
        return Counter((f[i - 1], f[i]) for f in self.faces for i in range(len(f)))


def read(path):
    """The pieces of a scene file by name, in file order."""
    text = path.read_text(encoding="utf-8")
    pieces = {match["name"]: Mesh(match) for match in PIECE.finditer(text)}
    if len(pieces) != text.count("IndexedFaceSet"):
        raise ValueError(f"{path}: a piece was not understood or has another's name")
    return pieces


def generated(script, *options):
    """The bytes that a generator writes."""
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "scene.wrl"
        command = [sys.executable, "-B", str(DATA / script), str(output), *options]
        subprocess.run(command, check=True)
        return output.read_bytes()


def distances_to_segments(point, a, b):
    """Distances from a point to segments a-b."""
    along = b - a
    t = np.clip(np.einsum("ij,ij->i", point - a, along) / np.einsum("ij,ij->i", along, along), 0, 1)
    return np.linalg.norm(point - a - t[:, None] * along, axis=1)


def distances(point, corners):
    """Distances from a point to triangles."""
    a, b, c = np.moveaxis(corners, 1, 0)
    sides = ((a, b), (b, c), (c, a))
    normal = np.cross(b - a, c - a)
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    height = np.einsum("ij,ij->i", point - a, normal)
    foot = point - height[:, None] * normal
    turns = [np.sum(np.cross(q - p, foot - p) * normal, axis=1) for p, q in sides]
    inside = np.min(turns, axis=0) >= 0
    border = np.min([distances_to_segments(point, p, q) for p, q in sides], axis=0)
    return np.where(inside, np.abs(height), border)
