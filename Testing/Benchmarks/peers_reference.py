# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""What beams truly hit, in rational numbers, for the beams of a sample."""

from fractions import Fraction

import numpy

# Triangles whose edge functions are above this share of their terms' size, to the wrong side, are
# missed whatever double rounds; its rounding is 1,000 times smaller.
MARGIN = 1e-12


def cast(points, triangles, sensor, directions):
    """Return the ranges, infinite where nothing is hit.

    A triangle is closed, two-sided, and not hit within its plane.
    """
    corners = points[triangles] - sensor
    balls = _make_balls(corners)
    return numpy.array([_cast_one(points, triangles, sensor, direction, corners, balls)
                        for direction in directions])


def _make_balls(corners):
    centres = corners.mean(axis=1)
    radii = numpy.sqrt(((corners - centres[:, None]) ** 2).sum(axis=2).max(axis=1))
    return centres, (radii + 1e-9 * numpy.linalg.norm(centres, axis=1)) ** 2


def _cast_one(points, triangles, sensor, direction, corners, balls):
    ranges = [_intersect(points[triangles[i]], sensor, direction)
              for i in _find_candidates(direction, corners, balls)]
    return float(min((x for x in ranges if x is not None), default=float("inf")))


def _find_candidates(direction, corners, balls):
    centres, squares = balls
    along = centres @ direction
    distance = (centres ** 2).sum(axis=1) - along ** 2
    in_front = (along >= 0) | (along ** 2 <= squares)
    near = numpy.flatnonzero(in_front & (distance <= squares + 1e-9 * along ** 2))
    a, b, c = (corners[near, i] for i in range(3))
    edges = []
    sizes = []
    for p, q in ((b, c), (c, a), (a, b)):
        edges.append(numpy.cross(p, q) @ direction)
        sizes.append(MARGIN * numpy.linalg.norm(p, axis=1) * numpy.linalg.norm(q, axis=1))
    edges, sizes = numpy.array(edges), numpy.array(sizes)
    left = (edges >= -sizes).all(axis=0)
    right = (edges <= sizes).all(axis=0)
    return near[left | right]


def _cross(p, q):
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


def _dot(p, q):
    return sum(x * y for x, y in zip(p, q))


def _intersect(triangle, sensor, direction):
    direction = [Fraction(float(x)) for x in direction]
    a, b, c = ([Fraction(float(x)) - Fraction(float(o)) for x, o in zip(corner, sensor)]
               for corner in triangle)
    edges = [_dot(_cross(p, q), direction) for p, q in ((b, c), (c, a), (a, b))]
    if min(edges) < 0 < max(edges):
        return None
    normal = _cross([x - y for x, y in zip(b, a)], [x - y for x, y in zip(c, a)])
    slope = _dot(normal, direction)
    if slope == 0:
        return None
    range_ = _dot(normal, a) / slope
    return range_ if range_ > 0 else None
