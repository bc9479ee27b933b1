# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Write a scene of coloured meshes as a readable VRML97 file.

The file uses a part of VRML97 that all readers support: explicit values, one
Shape for each piece, and at most one translation above it.
"""

import argparse
from pathlib import Path
from typing import NamedTuple

FACES_PER_LINE = 4


class Piece(NamedTuple):
    """One Shape: a mesh in metres, with faces counterclockwise from its visible side."""

    name: str
    colour: tuple
    points: list
    faces: list
    translation: tuple = (0, 0, 0)
    solid: bool = True


def numbers(values, decimals):
    """The values as text, rounded; a negative zero becomes 0."""
    return " ".join(f"{round(value, decimals) + 0.0:.{decimals}f}" for value in values)


def face_lines(faces):
    """The faces as lines of a coordIndex, each face closed by -1."""
    texts = [", ".join(map(str, face)) + ", -1" for face in faces]
    rows = [texts[i : i + FACES_PER_LINE] for i in range(0, len(texts), FACES_PER_LINE)]
    return ",\n".join(" " * 6 + ",  ".join(row) for row in rows)


def shape(piece, decimals):
    """The piece as a named Shape node."""
    points = ",\n".join(" " * 8 + numbers(point, decimals) for point in piece.points)
    return f"""\
DEF {piece.name} Shape {{
  appearance Appearance {{
    material Material {{ diffuseColor {numbers(piece.colour, 2)} }}
  }}
  geometry IndexedFaceSet {{
    solid {"TRUE" if piece.solid else "FALSE"}
    coord Coordinate {{
      point [
{points}
      ]
    }}
    coordIndex [
{face_lines(piece.faces)}
    ]
  }}
}}
"""


def node(piece, decimals):
    """The piece at its position: its Shape, in a Transform if it has a translation."""
    text = shape(piece, decimals)
    if not any(piece.translation):
        return text
    inner = "".join("    " + line + "\n" for line in text.splitlines())
    place = numbers(piece.translation, decimals)
    return f"Transform {{\n  translation {place}\n  children [\n{inner}  ]\n}}\n"


def triangle_count(pieces):
    """The number of triangles after all faces are cut into triangles."""
    return sum(len(face) - 2 for piece in pieces for face in piece.faces)


def scene(title, notes, pieces, decimals):
    """The whole file: header, a WorldInfo with title and notes, the pieces."""
    info = ",\n".join(f'    "{note}"' for note in notes)
    head = f'#VRML V2.0 utf8\n\nWorldInfo {{\n  title "{title}"\n  info [\n{info}\n  ]\n}}\n'
    return "\n".join([head] + [node(piece, decimals) for piece in pieces])


def output_parser(description, default_name):
    """A command line with the argument OUTPUT; by default the file is beside this script."""
    parser = argparse.ArgumentParser(description=description)
    default = Path(__file__).resolve().with_name(default_name)
    parser.add_argument("output", nargs="?", type=Path, default=default, metavar="OUTPUT",
                        help=f"file to write (default: {default_name} beside this script)")
    return parser


def save(path, text):
    """Write the text, with the same bytes on every platform."""
    path.write_bytes(text.encode("utf-8"))
