# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A measured fan, and what a telegram reports about it."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, eq=False)
class Fan:
    """The ranges of a fan or of a part of it, as fans.py describes them; and the platform angle.

    The first range is the one at the device's right.
    """

    ranges: np.ndarray
    angle: float


@dataclass(frozen=True)
class FanRecord:
    """What belongs to a telegram of measured values, but is not in it.

    turn, telegram: the two indices that the telegram can contain, modulo 256. time: when the first
    of its mirror turns began, seconds of the device's clock. angle: of the platform then, degrees.
    """

    turn: int
    telegram: int
    time: float
    angle: float
