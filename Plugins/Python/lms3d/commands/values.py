# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The values of options. A text that is not one ends the command with code 2."""

import argparse
import math

from ..properties import MAXIMUM_COUNT, MAXIMUM_GROUP, MAXIMUM_THREADS, MINIMUM_SEED


def number(text):
    """A finite number."""
    value = float(text)
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{text.strip()} is not a finite number")
    return value


def positive(text):
    """A finite number above zero."""
    value = number(text)
    if value <= 0:
        raise argparse.ArgumentTypeError(f"{text.strip()} is not above 0")
    return value


def bound(text):
    """A finite number, zero or above."""
    value = number(text)
    if value < 0:
        raise argparse.ArgumentTypeError(f"{text.strip()} is below 0")
    return value


def count(text, maximum=MAXIMUM_COUNT):
    """A whole number from 1 to `maximum`."""
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text.strip()} is below 1")
    if value > maximum:
        raise argparse.ArgumentTypeError(f"{text.strip()} is above {maximum}")
    return value


def thread_count(text):
    """A number of threads; 0 stands for all cores."""
    return 0 if int(text) == 0 else count(text, MAXIMUM_THREADS)


def group_size(text, minimum=0):
    """The largest number of beams in a group."""
    value = int(text)
    if not minimum <= value <= MAXIMUM_GROUP:
        raise argparse.ArgumentTypeError(
            f"{text.strip()} is not within {minimum} to {MAXIMUM_GROUP}")
    return value


def gap_size(text):
    """The largest number of beams in a gap; -1 lets the scan decide."""
    return group_size(text, -1)


def seed(text):
    """The seed of random numbers: an int of VTK."""
    value = int(text)
    if not MINIMUM_SEED <= value <= MAXIMUM_COUNT:
        raise argparse.ArgumentTypeError(
            f"{text.strip()} is not within {MINIMUM_SEED} to {MAXIMUM_COUNT}")
    return value
