# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Long results in pieces, so that a file needs little memory beside the data that it holds."""

from .execution import ProgressBar

PIECE = 1 << 20  # bytes
ROWS = 1 << 13  # returns or triangles that are converted to text or a table at once
BEAMS = 1 << 18  # beams or returns that are converted to binary numbers at once


def slices(count, length, label="writing"):
    """Slices of at most `length` that cover `count` rows, with progress."""
    with ProgressBar(label) as bar:
        bar.show(0)
        for first in range(0, count, length):
            stop = min(first + length, count)
            yield slice(first, stop)
            bar.show(stop / count)


def convert_rows(count, convert, length=ROWS):
    """What `convert` makes of each slice of the rows."""
    for rows in slices(count, length):
        yield convert(rows)


def cut(content):
    """Bytes, or a text of VTK, in pieces."""
    for first in range(0, len(content), PIECE):
        piece = content[first:first + PIECE]
        yield piece.encode() if isinstance(piece, str) else piece
