#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Build building.wrl: six furnished rooms on both sides of a corridor, 24 m long.

All rooms, doorways and window niches are one closed surface that faces inwards, so every beam from
inside returns. Each piece of furniture is closed and faces outwards. make_building_journey.py
drives a sensor through all rooms.
"""

from box_shell import shell
from make_room import (BEECH, BLUE, CARDBOARD, GREEN, LINEN, OAK, PINE, RED, STEEL, STONE, WALNUT,
                       WHITE, ball, barrel, books, box, chair, cupboard, door_leaf, lamp_shade,
                       lamp_stand, shelf, table, turned, turned_profile)
from vrml_writer import Piece, output_parser, save, scene, triangle_count

DECIMALS = 3

# Where the walls of the rooms stand: x0, x1, y0, y1 and the height of the ceiling.
CORRIDOR = (-12, 12, -1.1, 1.1, 2.7)
OFFICE = (-12, -5.2, 1.26, 6.5, 3)
MEETING = (-5.04, 3, 1.26, 7.2, 3)
LIBRARY = (3.16, 12, 1.26, 6.5, 3)
HALL = (-12, -1.5, -8, -1.26, 3.6)
KITCHEN = (-1.34, 4.6, -6.2, -1.26, 3)
STORE = (4.76, 12, -6.2, -1.26, 3)

# Doorways through the walls, 0.16 m thick: x0, x1, y0, y1.
DOORWAYS = (
    (-8.9, -7.98, 1.1, 1.26),  # office
    (-1.5, -0.58, 1.1, 1.26),  # meeting room
    (7.0, 7.92, 1.1, 1.26),  # library
    (3.0, 3.16, 3.6, 4.52),  # from the library to the meeting room
    (-9.5, -8.58, -1.26, -1.1),  # hall, west
    (-4.0, -2.4, -1.26, -1.1),  # hall, east: a double door without leaves
    (1.2, 2.12, -1.26, -1.1),  # kitchen
    (8.2, 9.12, -1.26, -1.1),  # store
)
LINTEL = 2.06

# Niches of the windows, 0.14 m deep: x0, x1, y0, y1.
WINDOWS = (
    (-11.2, -9.4, 6.5, 6.64), (-8.0, -6.2, 6.5, 6.64),  # office
    (-3.9, 1.7, 7.2, 7.34),  # meeting room
    (4.4, 6.2, 6.5, 6.64), (8.6, 10.4, 6.5, 6.64),  # library
    (-11, -9, -8.14, -8), (-7.8, -5.8, -8.14, -8), (-4.6, -2.6, -8.14, -8),  # hall
    (0.6, 2.9, -6.34, -6.2),  # kitchen
    (-12.14, -12, -0.6, 0.6),  # the corridor's end
)
SILL, HEAD = 0.92, 2.1


def building():
    """All rooms, doorways and niches: one closed surface that faces inwards."""
    rooms = (CORRIDOR, OFFICE, MEETING, LIBRARY, HALL, KITCHEN, STORE)
    return shell([(*room[:4], 0, room[4]) for room in rooms]
                 + [(*doorway, 0, LINTEL) for doorway in DOORWAYS]
                 + [(*window, SILL, HEAD) for window in WINDOWS])


def column():
    """A round column of the hall."""
    return turned_profile(10, [(0.24, 0), (0.24, 3.6)])


def bench():
    """A bench without a back."""
    return box(1.5, 0.36, 0.44)


# The pieces of each room: name, colour, mesh, turn in degrees and position.
CORRIDOR_PIECES = (
    ("Bench", OAK, bench(), 0, (-6.0, 0.86, 0)),
    ("CorridorPicture", BLUE, box(1.1, 0.03, 0.75), 0, (-6.0, 1.08, 1.3)),
    ("CorridorBoxes", CARDBOARD, box(0.5, 0.5, 0.9), 12, (11.5, -0.65, 0)),
    ("CorridorBarrel", WALNUT, barrel(), 0, (4.9, -0.72, 0)),
)
OFFICE_PIECES = (
    ("OfficeDoor", PINE, door_leaf(), 195, (-8.97, 1.3, 0)),
    ("OfficeTableWest", OAK, table(), 90, (-11.4, 4.9, 0)),
    ("OfficeChairWest", BEECH, chair(), 262, (-10.7, 4.8, 0)),
    ("OfficeTableEast", OAK, table(), -86, (-5.8, 4.6, 0)),
    ("OfficeChairEast", BEECH, chair(), 75, (-6.5, 4.7, 0)),
    ("OfficeShelf", WALNUT, shelf(), -90, (-11.8, 2.4, 0)),
    ("OfficeBooks", GREEN, books(), -90, (-11.8, 2.4, 0)),
    ("OfficeLampStand", STEEL, lamp_stand(), 0, (-5.7, 6.0, 0)),
    ("OfficeLampShade", LINEN, lamp_shade(), 11, (-5.7, 6.0, 0)),
)
MEETING_PIECES = (
    ("MeetingDoor", PINE, door_leaf(), 195, (-1.57, 1.3, 0)),
    ("MeetingTableWest", OAK, table(), 0, (-2.3, 5.6, 0)),
    ("MeetingTableEast", OAK, table(), 0, (-0.68, 5.6, 0)),
    ("MeetingChair1", BEECH, chair(), 4, (-2.7, 6.3, 0)),
    ("MeetingChair2", BEECH, chair(), -9, (-1.5, 6.32, 0)),
    ("MeetingChair3", BEECH, chair(), 12, (-0.4, 6.28, 0)),
    ("MeetingChair4", BEECH, chair(), 176, (-2.6, 4.9, 0)),
    ("MeetingChair5", BEECH, chair(), 188, (-0.6, 4.92, 0)),
    ("MeetingSideboard", OAK, cupboard(), -90, (-4.8, 3.6, 0)),
    ("MeetingPicture", BLUE, box(0.03, 1.6, 1.0), 0, (2.98, 5.9, 1.1)),
)
LIBRARY_PIECES = (
    ("LibraryDoor", PINE, door_leaf(), 165, (7.99, 1.3, 0)),
    ("LibraryShelf1", WALNUT, shelf(), 90, (11.8, 2.5, 0)),
    ("LibraryBooks1", GREEN, books(), 90, (11.8, 2.5, 0)),
    ("LibraryShelf2", WALNUT, shelf(), 90, (11.8, 4.1, 0)),
    ("LibraryBooks2", RED, books(), 90, (11.8, 4.1, 0)),
    ("LibraryShelf3", WALNUT, shelf(), 0, (4.6, 1.45, 0)),
    ("LibraryBooks3", BLUE, books(), 0, (4.6, 1.45, 0)),
    ("LibraryTable", OAK, table(), 8, (9.6, 5.3, 0)),
    ("LibraryChair1", BEECH, chair(), 20, (9.5, 6.02, 0)),
    ("LibraryChair2", BEECH, chair(), 195, (9.8, 4.72, 0)),
    ("LibraryBall", RED, ball(0.26), 21, (4.0, 5.8, 0)),
)
HALL_PIECES = (
    ("HallDoor", PINE, door_leaf(), -15, (-9.57, -1.3, 0)),
    ("Column1", STONE, column(), 10, (-9.4, -4.7, 0)),
    ("Column2", STONE, column(), 10, (-6.6, -4.7, 0)),
    ("Column3", STONE, column(), 10, (-3.8, -4.7, 0)),
    ("HallBoxLarge", CARDBOARD, box(0.8, 0.6, 0.55), 4, (-11.3, -7.3, 0)),
    ("HallBoxOnTop", CARDBOARD, box(0.5, 0.42, 0.36), -17, (-11.35, -7.32, 0.55)),
    ("HallBench", OAK, bench(), 90, (-1.8, -6.4, 0)),
    ("HallSideboard", OAK, cupboard(), 180, (-6.4, -1.52, 0)),
    ("HallBall", RED, ball(0.26), 0, (-5.2, -7.4, 0)),
)
KITCHEN_PIECES = (
    ("KitchenDoor", PINE, door_leaf(), -15, (1.13, -1.3, 0)),
    ("KitchenCounter1", LINEN, cupboard(), -90, (-1.1, -3.0, 0)),
    ("KitchenCounter2", LINEN, cupboard(), -90, (-1.1, -4.31, 0)),
    ("KitchenFridge", LINEN, box(0.6, 0.62, 1.8), 0, (-1.02, -5.4, 0)),
    ("KitchenTable", OAK, table(), 86, (3.9, -4.6, 0)),
    ("KitchenChair1", BEECH, chair(), 100, (3.15, -4.9, 0)),
    ("KitchenChair2", BEECH, chair(), 175, (3.9, -3.5, 0)),
)
STORE_PIECES = (
    ("StoreDoor", PINE, door_leaf(), -15, (8.13, -1.3, 0)),
    ("StoreShelf1", STEEL, shelf(), -90, (4.96, -3.2, 0)),
    ("StoreBoxes1", CARDBOARD, books(), -90, (4.96, -3.2, 0)),
    ("StoreShelf2", STEEL, shelf(), -90, (4.96, -4.9, 0)),
    ("StoreCrate", PINE, box(0.75, 0.7, 0.8), -12, (11.2, -5.4, 0)),
    ("StoreCrateOnTop", CARDBOARD, box(0.42, 0.36, 0.34), 15, (11.15, -5.35, 0.8)),
    ("StoreBarrel1", WALNUT, barrel(), 7, (11.4, -2.1, 0)),
    ("StoreBarrel2", WALNUT, barrel(), 20, (11.3, -2.9, 0)),
    ("StoreBox", CARDBOARD, box(0.8, 0.6, 0.55), 30, (7.3, -5.6, 0)),
)


def furnish():
    """The pieces of the scene."""
    pieces = (("Building", WHITE, building(), 0, (0, 0, 0)), *CORRIDOR_PIECES, *OFFICE_PIECES,
              *MEETING_PIECES, *LIBRARY_PIECES, *HALL_PIECES, *KITCHEN_PIECES, *STORE_PIECES)
    return [Piece(name, colour, *turned(mesh, turn), at) for name, colour, mesh, turn, at in pieces]


def main():
    """Write the building to the file named on the command line."""
    parser = output_parser("Write a building of six rooms and a corridor as VRML97.", "building.wrl")
    arguments = parser.parse_args()
    pieces = furnish()
    notes = (
        "Units: metres. Z is up; the floor is z = 0, the corridor lies along the x axis.",
        f"{triangle_count(pieces)} triangles; building_journey.vtp leads through all rooms.",
        "Made by: python3 Data/make_building.py",
    )
    save(arguments.output, scene("Building of six rooms", notes, pieces, DECIMALS))


if __name__ == "__main__":
    main()
