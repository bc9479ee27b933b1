# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Formats of points that keep the grid of the beams: PCD and PTX. Each yields bytes in pieces."""

import numpy as np

from .grid import Grid
from .pieces import BEAMS, convert_rows


def encode_pcd(scan, _failure):
    """An organised cloud in single precision: a row for each turn, NaN without a return.

    The coordinates are the scene's. VIEWPOINT is the pose from which they were recorded.
    """
    grid = Grid(scan)
    pose = " ".join(f"{number:.17g}" for number in (*grid.position, *grid.quaternion))
    yield ("# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\n"
           f"TYPE F F F\nCOUNT 1 1 1\nWIDTH {len(grid.alpha)}\nHEIGHT {len(grid.beta)}\n"
           f"VIEWPOINT {pose}\nPOINTS {grid.beams}\nDATA binary\n").encode("ascii")
    yield from convert_rows(
        grid.beams,
        lambda beams: grid.points_of_beams(beams, np.nan, False).astype("<f4").tobytes(), BEAMS)


def encode_ptx(scan, _failure):
    """Text with all beams, a column for each turn; 0 0 0 without a return.

    The coordinates are the sensor's. The header has the pose: the position, the sensor's axes, and
    the matrix from the sensor's frame to the scene, for row vectors. The intensity is 0.5, the
    format's value for a scanner that does not measure it.
    """
    grid = Grid(scan)
    axes = grid.rotation.T
    lines = [[len(grid.beta)], [len(grid.alpha)], grid.position, *axes,
             *((*axis, 0) for axis in axes), (*grid.position, 1)]
    yield "".join(" ".join(f"{number + 0.0:.17g}" for number in line) + "\n"
                  for line in lines).encode("ascii")

    def convert(beams):
        points = grid.points_of_beams(beams, 0.0, True)
        lines = "%.9g %.9g %.9g 0.5\n" * len(points)
        return (lines % tuple(points.ravel().tolist())).encode("ascii")

    yield from convert_rows(grid.beams, convert)
