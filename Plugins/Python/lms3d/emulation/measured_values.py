# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measured values as words of a telegram (TL 46 to 48)."""

import numpy as np

CENTIMETRES, MILLIMETRES, DECIMETRES = range(3)
UNITS_PER_METRE = {CENTIMETRES: 100, MILLIMETRES: 1000, DECIMETRES: 10}

# The bits of the distance, by the measuring mode. (For 05h, the text of TL says 14 and its table
# says 15.)
DISTANCE_BITS = {0x00: 13, 0x01: 13, 0x02: 13, 0x03: 14, 0x04: 14, 0x05: 15, 0x06: 15,
                 0x0F: 16, 0x3F: 16}

_WORD = np.dtype("<u2")

# Codes in place of a distance: how far they are below the largest number.
_NO_SIGNAL = 0
_TOO_WEAK = 4
_TOO_FAR = 8

_PARTIAL = 1 << 13
_PART_SHIFT = 11
_UNIT_SHIFT = 14
# Part 0 has whole degrees, part 1 x.25, part 2 x.50 and part 3 x.75 degrees.
_QUARTERS = 4


def encode_ranges(ranges, unit, measuring_mode):
    """An array of ranges in metres as unsigned words; NaN is no signal, minus infinity too weak a signal."""
    top = (1 << DISTANCE_BITS[measuring_mode]) - 1
    values = np.fmin(np.rint(ranges * UNITS_PER_METRE[unit]), top - _TOO_FAR)
    if not ranges.min() > -np.inf:  # the minimum is NaN if any range is
        values[np.isnan(ranges)] = top - _NO_SIGNAL
        values[ranges == -np.inf] = top - _TOO_WEAK
    return values.astype(_WORD)


def encode_count(count, unit, part=None, parts=1):
    """The word before the values: their number, unit and, of a partial scan, the part."""
    word = count | unit << _UNIT_SHIFT
    if part is not None:
        word |= _PARTIAL | part * (_QUARTERS // parts) << _PART_SHIFT
    return encode_words(word)


def encode_words(*words):
    """Words, low byte first."""
    return b"".join(word.to_bytes(2, "little") for word in words)


def encode_output(output, values, count_word, indices):
    """The data of a telegram with measured values.

    output: the Output, whose mean count and sub-range come first. indices: the index of the
    mirror's turn and of the telegram, or nothing.
    """
    means = bytes((output.means,)) if output.has_means else b""
    borders = encode_words(output.first, output.last) if output.has_borders else b""
    return means + borders + count_word + values.tobytes() + bytes(index % 256 for index in indices)
