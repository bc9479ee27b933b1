# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""When an LMS 200 sends the beams of a fan.

Its mirror turns 75 times a second and sends a beam at each degree. For a finer fan it turns several
times: with 0.5 degrees the first turn has every second beam, from the first one, and the next turn
the beams between them. A step that is no whole part of a degree takes one turn. The times equal
the array `Time` (Filters/Device/lms3dFan.h).
"""

from dataclasses import dataclass

import numpy as np

SCAN_TIME = 1 / 75  # seconds that a turn of the mirror takes
_DEGREE_TIME = SCAN_TIME / 360
_STEP_TOLERANCE = 1e-6


@dataclass(frozen=True)
class Part:
    """The beams of one turn of the mirror.

    beams: which beams of the fan. alpha: their elevations, `step` apart, degrees.
    delay: from the first beam of the fan to the first of these; beam_time: between two, seconds.
    """

    beams: slice
    alpha: np.ndarray
    step: float
    delay: float
    beam_time: float


class Fans:
    """The fans of a scan, one for each angle of the platform; `alpha` are the elevations."""

    def __init__(self, alpha):
        step = float(alpha[-1] - alpha[0]) / (len(alpha) - 1) if len(alpha) > 1 else 1.0
        turns = self._turns = _count_turns(abs(step))
        self.parts = [
            Part(beams=slice(turn, None, turns), alpha=alpha[turn::turns], step=turns * step,
                 delay=turn * SCAN_TIME, beam_time=turns * abs(step) * _DEGREE_TIME)
            for turn in range(min(turns, len(alpha)))]

    @property
    def duration(self):
        """Seconds from the first beam of a fan to the last."""
        last = self.parts[-1]
        return last.delay + (len(last.alpha) - 1) * last.beam_time

    def time(self, turn):
        """Seconds from the first beam of the scan to the first beam of a turn of the platform."""
        return turn * self._turns * SCAN_TIME


def _count_turns(step):
    """How many turns of the mirror a fan needs."""
    turns = round(1 / step) if 0 < step <= 1 else 1
    return turns if abs(turns * step - 1) <= _STEP_TOLERANCE else 1
