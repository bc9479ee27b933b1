# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Options of the commands that draw."""

from ..figure import DEFAULT_SIZE
from .values import count

_MAXIMUM_SIDE = 2**14  # pixels; OpenGL 4.1 guarantees this size


def pixel_count(text):
    """A whole number of pixels that can be drawn."""
    return count(text, _MAXIMUM_SIDE)


def add_picture(parser):
    """Add the size of the picture or window, and the edges of the map."""
    width, height = DEFAULT_SIZE
    parser.add_argument("--size", nargs=2, type=pixel_count, metavar=("WIDTH", "HEIGHT"),
                        default=DEFAULT_SIZE,
                        help=f"pixels of the picture, up to {_MAXIMUM_SIDE} each "
                        f"(default: {width} {height})")
    parser.add_argument("--edges", action="store_true",
                        help="draw the edges of the map's triangles")
