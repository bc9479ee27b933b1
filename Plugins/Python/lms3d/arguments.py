# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Converts the arguments of Python functions. A bad one raises ValueError with its name."""

import math
import operator

import numpy as np

from .properties import MAXIMUM_COUNT


def to_numbers(name, values, count):
    """A list of finite numbers."""
    try:
        numbers = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        numbers = np.empty(0)
    if numbers.shape != (count,) or not np.isfinite(numbers).all():
        raise ValueError(f"{name} must be {count} finite numbers, not {values!r}")
    return numbers.tolist()


def to_number(name, value):
    """Any number, also infinite."""
    try:
        return float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{name} must be a number, not {value!r}") from None


def to_finite(name, value):
    """A finite number."""
    number = to_number(name, value)
    if not math.isfinite(number):
        raise ValueError(f"{name} must be finite, not {value!r}")
    return number


def to_bound(name, value):
    """A finite number, zero or above."""
    bound = to_number(name, value)
    if not 0 <= bound < math.inf:
        raise ValueError(f"{name} must be 0 or more, and finite, not {value!r}")
    return bound


def to_count(name, value, minimum=1, maximum=MAXIMUM_COUNT):
    """A whole number."""
    try:
        count = operator.index(value)
    except TypeError:
        count = minimum - 1
    if not minimum <= count <= maximum:
        raise ValueError(f"{name} must be a whole number from {minimum} to {maximum}, not "
                         f"{value!r}")
    return count


def to_choice(name, value, choices):
    """The value of a choice of a dictionary."""
    if value not in list(choices):
        raise ValueError(f"{name} must be one of {', '.join(choices)}, not {value!r}")
    return choices[value]
