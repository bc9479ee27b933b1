#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Tessellate Newell's teapot from its bicubic Bezier patches.

M. Newell measured the control points in 1975 (M. Newell, "The Utilization of
Procedure Models in Digital Image Synthesis", University of Utah, 1975). They
are listed by F. Crow, "The Origins of the Teapot", IEEE Computer
Graphics and Applications 7(1), 1987. Newell's pot has 28 patches and no
bottom; the four patches of the bottom are the addition in common use.

Body, lid and bottom are round, so radius and height define a row of control
points. Handle and spout are mirrored tubes, so two points of the plane y = 0
and half the width define a row. Each part is an open surface,
faces turned outwards. One unit of the patches is 5 cm; the pot stands on
z = 0, spout towards +x.
"""

from itertools import product
from math import fsum

from vrml_writer import Piece, output_parser, save, scene, triangle_count

UNIT = 0.05
DECIMALS = 5
SUBDIVISIONS = 7

# Control points of a quarter of a circle of radius 1 lie at (1, 0), (1, K), (K, 1), (0, 1).
# The knob of the lid is the one exception.
K = 0.56
KNOB_K = 0.5625

# Profiles (radius, height[, K]) from the top of the pot to its foot. Every
# third row is shared by two patches.
BODY = (
    (1.4, 2.4), (1.3375, 2.53125), (1.4375, 2.53125),  # rim
    (1.5, 2.4), (1.75, 1.875), (2.0, 1.35),
    (2.0, 0.9), (2.0, 0.45), (1.5, 0.225), (1.5, 0.15),
)
LID = (
    (0.0, 3.15), (0.8, 3.15, KNOB_K), (0.0, 2.85),
    (0.2, 2.7), (0.4, 2.55), (1.3, 2.55), (1.3, 2.4),
)
BOTTOM = ((1.5, 0.15), (1.5, 0.075), (1.425, 0.0), (0.0, 0.0))

# Tubes: ((x, z) of one side, (x, z) of the other, half of the width) of each row.
HANDLE = (
    ((-1.6, 2.025), (-1.5, 2.25), 0.3),
    ((-2.3, 2.025), (-2.5, 2.25), 0.3),
    ((-2.7, 2.025), (-3.0, 2.25), 0.3),
    ((-2.7, 1.8), (-3.0, 1.8), 0.3),
    ((-2.7, 1.575), (-3.0, 1.35), 0.3),
    ((-2.5, 1.125), (-2.65, 0.9375), 0.3),
    ((-2.0, 0.9), (-1.9, 0.6), 0.3),
)
SPOUT = (
    ((1.7, 1.425), (1.7, 0.6), 0.66),
    ((2.6, 1.425), (3.1, 0.825), 0.66),
    ((2.3, 2.1), (2.4, 2.025), 0.25),
    ((2.7, 2.4), (3.3, 2.4), 0.25),
    ((2.8, 2.475), (3.525, 2.49375), 0.25),
    ((2.9, 2.475), (3.45, 2.5125), 0.15),
    ((2.8, 2.4), (3.2, 2.4), 0.15),
)


def ring(radius, height, k=K):
    """Control points of a full circle, counterclockwise, as four quarters."""
    near, far = radius, k * radius
    turns = ((1, 0, 0, 1), (0, -1, 1, 0), (-1, 0, 0, -1), (0, 1, -1, 0))
    quarter = ((near, 0.0), (near, far), (far, near), (0.0, near))
    return [[(a * x + b * y, c * x + d * y, height) for x, y in quarter] for a, b, c, d in turns]


def loop(first, second, width):
    """Control points around a tube, as two halves."""
    (x0, z0), (x1, z1) = first, second
    there = [(x0, 0.0, z0), (x0, width, z0), (x1, width, z1), (x1, 0.0, z1)]
    return [there, [(x, -y, z) for x, y, z in reversed(there)]]


def patches(rows):
    """The 4 x 4 control nets of a part, from its rows of control points."""
    nets = []
    for start in range(0, len(rows) - 1, 3):
        nets.extend(zip(*rows[start : start + 4]))
    return nets


def bernstein(t):
    """The four cubic Bernstein polynomials at t."""
    s = 1.0 - t
    return s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t


def surface_point(net, u, v):
    """The point of a patch at u (from row to row) and v (along a row), in rounded metres."""
    along, around = bernstein(u), bernstein(v)
    terms = [(a * b, p) for a, row in zip(along, net) for b, p in zip(around, row)]
    sums = [fsum(weight * p[axis] for weight, p in terms) for axis in range(3)]
    return tuple(round(UNIT * value, DECIMALS) + 0.0 for value in sums)


def cells(n):
    """The two triangles of each cell of an n x n grid, as grid points (i, j)."""
    for i, j in product(range(n), repeat=2):
        a, b, c, d = (i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)
        yield a, b, c
        yield a, c, d


def tessellate(rows, n):
    """Points and triangles of a part: patches are joined, degenerate triangles are skipped."""
    index, faces = {}, []
    for net in patches(rows):
        places = product(range(n + 1), repeat=2)
        grid = {(i, j): surface_point(net, i / n, j / n) for i, j in places}
        for triangle in cells(n):
            corners = [grid[place] for place in triangle]
            if len(set(corners)) == 3:
                faces.append([index.setdefault(corner, len(index)) for corner in corners])
    return list(index), faces


def teapot(n=SUBDIVISIONS):
    """The five parts of the pot, each patch cut into n x n cells."""
    parts = (
        ("Body", (0.78, 0.80, 0.84), [ring(*row) for row in BODY]),
        ("Lid", (0.62, 0.70, 0.82), [ring(*row) for row in LID]),
        ("Handle", (0.80, 0.62, 0.36), [loop(*row) for row in HANDLE]),
        ("Spout", (0.70, 0.76, 0.70), [loop(*row) for row in SPOUT]),
        ("Bottom", (0.55, 0.52, 0.50), [ring(*row) for row in BOTTOM]),
    )
    return [Piece(name, colour, *tessellate(rows, n), solid=False) for name, colour, rows in parts]


def main():
    """Write the teapot to the file named on the command line."""
    parser = output_parser("Write Newell's teapot as VRML97.", "teapot.wrl")
    parser.add_argument("--subdivisions", type=int, default=SUBDIVISIONS, metavar="N",
                        help="cells along each side of a patch (default: %(default)s)")
    arguments = parser.parse_args()
    if arguments.subdivisions < 1:
        parser.error("N must be 1 or more")
    pieces = teapot(arguments.subdivisions)
    notes = (
        "Units: metres. Z is up; the pot stands on z = 0 with its spout towards +x.",
        f"{triangle_count(pieces)} triangles from 32 bicubic patches; 1 patch unit is 5 cm.",
        f"Made by: python3 Data/make_teapot.py --subdivisions {arguments.subdivisions}",
    )
    save(arguments.output, scene("Newell's teapot", notes, pieces, DECIMALS))


if __name__ == "__main__":
    main()
