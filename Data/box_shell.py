# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The walls, floors and ceilings around the union of boxes, as one closed mesh.

A box is (x0, x1, y0, y1, z0, z1) in metres: a room, a doorway, or the niche of a window. Boxes that
touch or overlap become one space. The mesh faces into this space.
"""

from itertools import product


def shell(boxes):
    """The mesh (points, faces) around the boxes: every edge has a face on each of its two sides."""
    levels = [sorted({value for box in boxes for value in box[2 * k : 2 * k + 2]}) for k in range(3)]
    free = _free_cells(boxes, levels)
    rectangles = [r for axis in range(3) for r in _rectangles(free, levels, axis)]
    corners = {corner for _, _, low, high in rectangles for corner in _corners(low, high)}
    points, faces = [], []
    numbers = {}
    for axis, turns_round, low, high in rectangles:
        ring = _ring(axis, low, high, corners)
        if turns_round:
            ring.reverse()
        faces += _faces(ring, low, high, levels, points, numbers)
    return points, faces


def _free_cells(boxes, levels):
    """The cells (i, j, k) between neighbouring levels that lie in a box."""
    free = set()
    for box in boxes:
        spans = [range(levels[k].index(box[2 * k]), levels[k].index(box[2 * k + 1]))
                 for k in range(3)]
        free.update(product(*spans))
    return free


def _rectangles(free, levels, axis):
    """Rectangles between free and solid cells, across an axis: (axis, turns round, low, high)."""
    for level, step in product(range(len(levels[axis])), (0, -1)):
        left = set()
        for cell in free:
            beyond = list(cell)
            beyond[axis] += 1 if step else -1
            if cell[axis] == level + step and tuple(beyond) not in free:
                left.add(cell)
        while left:
            low, high = _largest_from(min(left), left, axis)
            left -= set(product(*(range(a, b) for a, b in zip(low, high))))
            low[axis] = high[axis] = level
            yield axis, bool(step), tuple(low), tuple(high)


def _largest_from(cell, cells, axis):
    """A rectangle of cells that begins with a cell: as long as possible, then as wide."""
    low, high = list(cell), [i + 1 for i in cell]
    for k in (k for k in range(3) if k != axis):
        while True:
            row = [range(a, b) for a, b in zip(low, high)]
            row[k] = (high[k],)
            if not cells.issuperset(product(*row)):
                break
            high[k] += 1
    return low, high


def _corners(low, high):
    return product(*({a, b} for a, b in zip(low, high)))


def _ring(axis, low, high, corners):
    """The corners of all rectangles on the border of this one, counterclockwise about the axis."""
    u, v = (axis + 1) % 3, (axis + 2) % 3
    on_plane = [c for c in corners if c[axis] == low[axis]
                and low[u] <= c[u] <= high[u] and low[v] <= c[v] <= high[v]]
    return (sorted(c for c in on_plane if c[v] == low[v] and c[u] < high[u])
            + sorted(c for c in on_plane if c[u] == high[u] and c[v] < high[v])
            + sorted((c for c in on_plane if c[v] == high[v] and c[u] > low[u]), reverse=True)
            + sorted((c for c in on_plane if c[u] == low[u] and c[v] > low[v]), reverse=True))


def _faces(ring, low, high, levels, points, numbers):
    """The rectangle as one face, or as triangles about its centre if others meet it at an edge."""
    for corner in ring:
        if corner not in numbers:
            numbers[corner] = len(points)
            points.append(tuple(levels[k][corner[k]] for k in range(3)))
    around = [numbers[corner] for corner in ring]
    if len(around) == 4:
        return [tuple(around)]
    centre = len(points)
    points.append(tuple((levels[k][low[k]] + levels[k][high[k]]) / 2 for k in range(3)))
    return [(centre, a, b) for a, b in zip(around, around[1:] + around[:1])]
