# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Variants of the fan, what a telegram of measured values contains, and how long both take."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Optional

from .telegrams import FRAME_SIZE

TURNS_PER_SECOND = 75  # of the mirror; a turn measures a value for each degree (TL 19)
BITS_PER_BYTE = 10  # on the line, with start and stop bit


@dataclass(frozen=True)
class Variant:
    """The angle of the fan in degrees, and its step in hundredths of a degree."""

    angle: int = 180
    step: int = 50

    @cached_property
    def parts(self):
        """Number of mirror turns that the whole fan needs; each measures one part of it."""
        return 100 // self.step

    @cached_property
    def first_alpha(self):
        """The elevation of the first beam; the first beam is the device's right."""
        return -self.angle / 2 if self.angle == 180 else -50.0

    @cached_property
    def count(self):
        """Number of beams."""
        return self.angle * self.parts + 1

    @cached_property
    def alphas(self):
        """The elevations of all beams."""
        return [self.first_alpha + i * self.step / 100 for i in range(self.count)]


# TL 47, 66. A fan of 180 degrees in quarters of a degree exists in parts only.
VARIANTS = (Variant(180, 100), Variant(180, 50),
            Variant(100, 100), Variant(100, 50), Variant(100, 25))
FANS = (*VARIANTS, Variant(180, 25))
_HALF_CIRCLES = {variant.step: variant for variant in FANS if variant.angle == 180}


@dataclass(frozen=True)
class Output:
    """What a telegram of measured values contains.

    code: of the telegram. means: number of scans that are averaged. first, last: the sub-range,
    counted from 1. is_partial: whether it is one part of an interlaced scan.
    """

    code: int
    means: Optional[int] = None
    first: Optional[int] = None
    last: Optional[int] = None
    is_partial: bool = False

    @property
    def has_means(self):
        """Whether the telegram contains the number of scans that are averaged."""
        return self.means is not None

    @property
    def has_borders(self):
        """Whether the telegram contains a sub-range."""
        return self.first is not None

    def turns(self, variant):
        """Number of mirror turns that the values need."""
        return 1 if self.is_partial else variant.parts * (self.means or 1)

    def fan(self, variant):
        """The variant that is measured. A partial scan has 180 degrees always (TL 46)."""
        return _HALF_CIRCLES[variant.step] if self.is_partial else variant

    def value_count(self, variant):
        """Number of values in the longest telegram."""
        if self.has_borders:
            return self.last - self.first + 1
        return _HALF_CIRCLES[100].count if self.is_partial else variant.count

    def size(self, variant, has_indices):
        """Number of bytes of the longest telegram."""
        head = 1 + self.has_means + 4 * self.has_borders + 2
        return FRAME_SIZE + head + 2 * self.value_count(variant) + 2 * has_indices + 1


def interval(output, variant, size, rate):
    """Mirror turns from one telegram to the next.

    The line carries whole scans: those that are measured while it is busy are lost. (TL prints the
    numbers of scans.) All parts of a partial scan come in turn. Without a rate, no scan is lost.
    """
    turns = output.turns(variant)
    scans = -(-size * BITS_PER_BYTE * TURNS_PER_SECOND // (rate * turns)) if rate else 1
    if output.is_partial:
        while math.gcd(scans, variant.parts) > 1:
            scans += 1
    return turns * scans
