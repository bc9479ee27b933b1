#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Build the room of the paper's Figure 5: an indoor scene of 804 triangles.

The main room, 8 x 6 x 3 m, is centred on the origin with its floor at z = 0.
A window niche is let into its north wall (+y), and a doorway in its east wall
(+x) leads to a smaller room. Both rooms are one closed surface that faces
inwards, so every beam from inside returns. The furniture is not aligned with
the walls, as in a real room; each piece is closed and faces outwards. The
sensor's position is near (0.3, -0.2, 1.0), where the floor is free.
"""

from math import atan, cos, pi, radians, sin, sqrt

from vrml_writer import Piece, output_parser, save, scene, triangle_count

DECIMALS = 3

WHITE = (0.93, 0.91, 0.86)
OAK = (0.72, 0.52, 0.32)
BEECH = (0.82, 0.66, 0.44)
WALNUT = (0.50, 0.34, 0.23)
CARDBOARD = (0.76, 0.62, 0.42)
PINE = (0.86, 0.74, 0.50)
STONE = (0.66, 0.66, 0.64)
STEEL = (0.45, 0.47, 0.50)
LINEN = (0.95, 0.87, 0.68)
RED = (0.78, 0.22, 0.18)
GREEN = (0.32, 0.56, 0.42)
BLUE = (0.33, 0.50, 0.70)


# --- Meshes: a mesh is (points, faces), closed and facing outwards ----------------------------

def cap(ring):
    """Corner numbers of a flat convex end as a face; more than four corners become triangles."""
    if len(ring) == 4:
        return [tuple(ring)]
    return [(ring[0], ring[i], ring[i + 1]) for i in range(1, len(ring) - 1)]


def loft(rings):
    """Closed mesh through rings of corners, each counterclockwise from above, bottom to top."""
    n = len(rings[0])
    points = [point for ring in rings for point in ring]
    faces = cap(range(n - 1, -1, -1)) + cap(range(len(points) - n, len(points)))
    for start in range(0, len(points) - n, n):
        upper = points[start + n : start + 2 * n]
        upright = all(p[:2] == q[:2] for p, q in zip(points[start:], upper))
        for i in range(n):
            a, b = start + i, start + (i + 1) % n
            c, d = b + n, a + n
            faces += [(a, b, c, d)] if upright else [(a, b, c), (a, c, d)]
    return points, faces


def box(width, depth, height, at=(0, 0, 0), lean=0):
    """A box whose base is centred at a point; its top lies `lean` metres farther along +y."""
    x, y, z = at
    w, d = width / 2, depth / 2
    corners = [(-w, -d), (w, -d), (w, d), (-w, d)]
    return loft([[(x + u, y + v + s * lean, z + s * height) for u, v in corners] for s in (0, 1)])


def turned_profile(sides, profile):
    """A round body of `sides` sides, through (radius, height) pairs from bottom to top."""
    angles = [2 * pi * i / sides for i in range(sides)]
    return loft([[(r * cos(a), r * sin(a), z) for a in angles] for r, z in profile])


def ball(radius):
    """A sphere of 80 triangles on the floor: an icosahedron with each face cut in four."""
    low = radians(90) - atan(2)
    belts = [(36 * (i % 2) + 72 * (i // 2), low if i % 2 else -low) for i in range(10)]
    points = [(0, 0, -1), (0, 0, 1)]
    points += [(cos(b) * cos(radians(a)), cos(b) * sin(radians(a)), sin(b)) for a, b in belts]
    faces = []
    for i in range(0, 10, 2):
        a, b, c, d = (2 + (i + k) % 10 for k in range(4))
        faces += [(0, c, a), (a, c, b), (b, c, d), (1, b, d)]
    points, faces = cut_in_four(points, faces)
    return [(radius * x, radius * y, radius * (z + 1)) for x, y, z in points], faces


def cut_in_four(points, faces):
    """Each triangle of a unit sphere cut in four at the middles of its edges."""
    points, middles = list(points), {}

    def middle(a, b):
        key = frozenset((a, b))
        if key not in middles:
            total = [p + q for p, q in zip(points[a], points[b])]
            size = sqrt(sum(x * x for x in total))
            middles[key] = len(points)
            points.append(tuple(x / size for x in total))
        return middles[key]

    smaller = []
    for a, b, c in faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        smaller += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return points, smaller


def joined(*meshes):
    """Several meshes as one."""
    points, faces = [], []
    for more_points, more_faces in meshes:
        faces += [tuple(len(points) + i for i in face) for face in more_faces]
        points += more_points
    return points, faces


def turned(mesh, degrees):
    """The mesh turned counterclockwise about the z axis."""
    c, s = cos(radians(degrees)), sin(radians(degrees))
    points, faces = mesh
    return [(c * x - s * y, s * x + c * y, z) for x, y, z in points], faces


# --- The two rooms ----------------------------------------------------------------------------

def rooms():
    """Both rooms with doorway and window niche: one closed surface that faces inwards."""
    sill, head = 0.92, 2.1
    points = [
        # Main room, floor (0-5, the doorway is 2-3) and ceiling (6-9).
        (-4, -3, 0), (4, -3, 0), (4, 0.48, 0), (4, 1.4, 0), (4, 3, 0), (-4, 3, 0),
        (-4, -3, 3), (4, -3, 3), (4, 3, 3), (-4, 3, 3),
        # Lintel of the doorway on this side (10-11); threshold and lintel on the far side (12-15).
        (4, 0.48, 2.06), (4, 1.4, 2.06),
        (4.16, 0.48, 0), (4.16, 1.4, 0), (4.16, 0.48, 2.06), (4.16, 1.4, 2.06),
        # Window: opening in the wall (16-19) and pane (20-23).
        (-3.05, 3, sill), (-1.25, 3, sill), (-1.25, 3, head), (-3.05, 3, head),
        (-3.05, 3.14, sill), (-1.25, 3.14, sill), (-1.25, 3.14, head), (-3.05, 3.14, head),
        # Smaller room, floor (24-27) and ceiling (28-31); its far wall is not square.
        (4.16, -0.7, 0), (6.7, -0.7, 0), (6.95, 2.85, 0), (4.16, 2.85, 0),
        (4.16, -0.7, 2.6), (6.7, -0.7, 2.6), (6.95, 2.85, 2.6), (4.16, 2.85, 2.6),
    ]
    main_room = [
        (0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5),  # floor
        (6, 9, 8, 7),  # ceiling
        (0, 6, 7, 1), (0, 5, 9, 6),  # south wall, west wall
        (1, 7, 10, 2), (10, 7, 8, 11), (3, 11, 8, 4),  # east wall, doorway
        (5, 4, 17, 16), (4, 8, 18, 17), (8, 9, 19, 18), (9, 5, 16, 19),  # north wall, window
        (16, 17, 21, 20), (17, 18, 22, 21), (18, 19, 23, 22), (19, 16, 20, 23),  # niche
        (20, 21, 22, 23),  # pane
    ]
    doorway = [(2, 12, 13, 3), (10, 11, 15, 14), (2, 10, 14, 12), (3, 13, 15, 11)]
    small_room = [
        (24, 25, 12), (12, 25, 13), (13, 25, 26), (13, 26, 27),  # floor
        (28, 31, 30, 29),  # ceiling
        (24, 28, 29, 25), (25, 29, 30, 26), (26, 30, 31, 27),  # south, east, north wall
        (24, 12, 14, 28), (28, 14, 15, 31), (15, 13, 27, 31),  # west wall, doorway
    ]
    return points, main_room + doorway + small_room


# --- The furniture, each piece about its own origin -------------------------------------------

def table():
    """A table, 1.6 x 0.85 m and 0.75 m high."""
    legs = [box(0.06, 0.06, 0.715, (x, y, 0)) for x in (-0.74, 0.74) for y in (-0.365, 0.365)]
    return joined(box(1.6, 0.85, 0.035, (0, 0, 0.715)), *legs)


def chair():
    """A chair that faces -y, with an inclined back."""
    legs = [box(0.04, 0.04, 0.43, (x, y, 0)) for x in (-0.19, 0.19) for y in (-0.18, 0.18)]
    back = box(0.42, 0.03, 0.46, (0, 0.185, 0.47), lean=0.08)
    return joined(box(0.44, 0.42, 0.04, (0, 0, 0.43)), back, *legs)


def shelf():
    """A bookcase 1.3 m wide, open to +y, with boards at irregular heights."""
    sides = [box(0.03, 0.34, 1.95, (x, 0, 0)) for x in (-0.635, 0.635)]
    boards = [box(1.24, 0.32, 0.03, (0, 0.01, z)) for z in (0.06, 0.47, 0.83, 1.24, 1.88)]
    return joined(box(1.24, 0.02, 1.95, (0, -0.16, 0)), *sides, *boards)


def books():
    """The contents of the bookcase: two rows of books and a pile."""
    return joined(
        box(0.56, 0.21, 0.27, (-0.32, -0.03, 1.27)),
        box(0.38, 0.19, 0.24, (0.41, -0.04, 0.86)),
        box(0.3, 0.22, 0.16, (-0.2, 0.0, 0.5)),
    )


def cupboard():
    """A sideboard 1.3 m long with two doors, its front towards +y."""
    doors = [box(0.61, 0.02, 0.7, (x, 0.23, 0.1)) for x in (-0.315, 0.315)]
    return joined(box(1.3, 0.44, 0.86), *doors)


def door_leaf():
    """A door leaf with its hinge on the z axis and its free edge towards -y."""
    leaf = box(0.04, 0.88, 2.03, (0, -0.45, 0.01))
    return joined(leaf, box(0.14, 0.12, 0.02, (0, -0.79, 1.04)))


def barrel():
    """A barrel, widest in its middle third."""
    return turned_profile(10, [(0.25, 0), (0.315, 0.28), (0.315, 0.6), (0.25, 0.88)])


def lamp_stand():
    """A heavy foot and a pole 2 cm thick."""
    foot = turned_profile(6, [(0.15, 0), (0.15, 0.03)])
    pole = turned_profile(6, [(0.01, 0.03), (0.01, 1.5)])
    return joined(foot, pole)


def lamp_shade():
    """The shade on top of the pole."""
    return turned_profile(8, [(0.2, 1.5), (0.11, 1.74)])


def furnish():
    """The pieces of the scene, made from name, colour, mesh, turn in degrees and position."""
    pieces = (
        ("Room", WHITE, rooms(), 0, (0, 0, 0)),
        ("Table", OAK, table(), 6, (-2.3, 1.55, 0)),
        ("ChairAtTable", BEECH, chair(), 171, (-2.16, 0.97, 0)),
        ("ChairPulledOut", BEECH, chair(), -117, (-1.02, 1.21, 0)),
        ("Shelf", WALNUT, shelf(), 0, (-1.95, -2.8, 0)),
        ("Books", GREEN, books(), 0, (-1.95, -2.8, 0)),
        ("Sideboard", OAK, cupboard(), 90, (3.74, -0.75, 0)),
        ("Picture", BLUE, box(0.03, 1.1, 0.75), 0, (-3.985, -0.65, 1.3)),
        ("DoorLeaf", PINE, door_leaf(), -58, (3.965, 1.36, 0)),
        ("Column", STONE, turned_profile(8, [(0.21, 0), (0.21, 3)]), 10, (2.15, -1.7, 0)),
        ("Barrel", WALNUT, barrel(), 7, (3.42, -2.38, 0)),
        ("Ball", RED, ball(0.26), 21, (0.95, 1.62, 0)),
        # The pole is thinner than the gap between two turns. It lies in the turn beta = 245.
        ("LampStand", STEEL, lamp_stand(), 0, (-0.883, 2.338, 0)),
        ("LampShade", LINEN, lamp_shade(), 11, (-0.883, 2.338, 0)),
        ("BoxLarge", CARDBOARD, box(0.8, 0.6, 0.55), 4, (2.55, 2.45, 0)),
        ("BoxOnTop", CARDBOARD, box(0.5, 0.42, 0.36), -17, (2.45, 2.42, 0.55)),
        ("BoxAtTheTop", PINE, box(0.3, 0.22, 0.2), 31, (2.42, 2.44, 0.91)),
        ("BoxBeside", CARDBOARD, box(0.45, 0.4, 0.3), -24, (1.72, 2.38, 0)),
        ("BoxAlone", PINE, box(0.55, 0.38, 0.42), 38, (-0.35, -2.05, 0)),
        ("Crate", PINE, box(0.75, 0.7, 0.8), -12, (6.1, 1.75, 0)),
        ("CrateOnTop", CARDBOARD, box(0.42, 0.36, 0.34), 15, (6.05, 1.8, 0.8)),
    )
    return [Piece(name, colour, *turned(mesh, turn), at) for name, colour, mesh, turn, at in pieces]


def main():
    """Write the room to the file named on the command line."""
    arguments = output_parser("Write the room of Figure 5 as VRML97.", "room.wrl").parse_args()
    pieces = furnish()
    notes = (
        "Units: metres. Z is up; the floor is z = 0, the main room is centred on the origin.",
        f"{triangle_count(pieces)} triangles; the sensor stands well near 0.3 -0.2 1.0.",
        "Made by: python3 Data/make_room.py",
    )
    save(arguments.output, scene("Room of Figure 5", notes, pieces, DECIMALS))


if __name__ == "__main__":
    main()
