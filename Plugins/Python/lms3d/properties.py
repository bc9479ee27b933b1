# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The scan filter's choices, as Python and the command line name them, and its limits."""

import itertools
import re

from .vtkLMS3DFilters import vtkLMS3DScanFilter


def _number(get_name):
    """The names that a function gives to 0, 1 and so on, with these numbers.

    The names are in lower case: AngleSum is angle-sum, and LMS200-mm is lms200-mm.
    """
    names = itertools.takewhile(bool, map(get_name, itertools.count()))
    return {re.sub(r"(?<=[a-z])(?=[A-Z])", "-", name).lower(): i for i, name in enumerate(names)}


METHODS = _number(vtkLMS3DScanFilter.GetIntersectionMethodName)
MOUNTINGS = _number(vtkLMS3DScanFilter.GetMountingName)
DEVICES = _number(vtkLMS3DScanFilter.GetDeviceName)

# A count is an int in VTK.
MAXIMUM_COUNT = 2**31 - 1
MINIMUM_SEED = -2**31
MAXIMUM_THREADS = 1024
MAXIMUM_BEAM_SAMPLES = 1000
MAXIMUM_GROUP = 1000000  # beams of a gap, or returns of a speckle
