# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The platform that turns the device: in steps from fan to fan, or steadily.

A platform measures what the device requests, from a source of fans: see fans.LiveFans.
"""

import numpy as np

from .fan import Fan
from .variants import TURNS_PER_SECOND


class Stepped:
    """Turns to the next angle when the host has received all parts of a fan.

    So no fan is lost: the telegrams are a whole scan in its order, and then the next scan.
    """

    def __init__(self, fans):
        self._fans = fans
        self._scan = 0
        self._turn = 0
        self._parts = 1  # of the fan that was measured last
        self._received = set()  # parts of the present turn

    def measure(self, variant, part, _time, means):
        """The Fan of a variant, or one part of it; ranges are averaged over a number of scans."""
        ranges = self._fans.cast_turn(variant, self._scan, self._turn, means)
        parts = 1 if part is None else variant.parts
        if parts != self._parts:  # the numbers of the parts have another meaning
            self._parts = parts
            self._received.clear()
        return Fan(ranges if part is None else ranges[part::variant.parts],
                   self._fans.angles[self._turn])

    def confirm(self, record):
        """The host has received a telegram, with the FanRecord."""
        # The turn is modulo 256, which all numbers of parts divide.
        self._received.add(record.turn % self._parts)
        if len(self._received) < self._parts:
            return
        self._received.clear()
        self._turn += 1
        if self._turn == len(self._fans.angles):
            self._scan, self._turn = self._scan + 1, 0


class Turning:
    """Turns steadily, `rate` degrees a second, while the host receives fans or does not.

    The mirror measures the parts of a fan one after the other, so each has its own angle. (Within
    half a turn of the mirror, 1/150 s, the angle is taken to stay.)
    """

    def __init__(self, fans, rate, start):
        self._fans = fans
        self._rate = rate
        self._start = start

    def measure(self, variant, part, time, means):
        """As Stepped.measure."""
        if part is not None:
            return Fan(self._cast(variant, part, time, means), self._angle(time))
        ranges = np.empty(variant.count)
        for each in range(variant.parts):
            begin = time + each / TURNS_PER_SECOND
            ranges[each::variant.parts] = self._cast(variant, each, begin, means)
        return Fan(ranges, self._angle(time))

    def confirm(self, _record):
        """The platform does not wait for the host."""

    def _cast(self, variant, part, time, means):
        return self._fans.cast_part(variant, part, self._angle(time), time - self._start, means)

    def _angle(self, time):
        return (self._fans.angles[0] + self._rate * (time - self._start)) % 360.0
