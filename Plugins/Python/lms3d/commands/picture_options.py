# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Options of the commands that draw."""

from ..figure import DEFAULT_SIZE
from .sensor_options import count


def add_size(parser):
    """Add the size of the picture or window."""
    width, height = DEFAULT_SIZE
    parser.add_argument("--size", nargs=2, type=count, metavar=("WIDTH", "HEIGHT"),
                        default=DEFAULT_SIZE,
                        help=f"pixels of the picture (default: {width} {height})")
