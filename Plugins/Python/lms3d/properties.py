# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The scan filter's methods, as Python and the command line name them, and its limits."""

import re

from .vtkLMS3DFilters import vtkLMS3DScanFilter

# The filter's names in lower case: AngleSum is angle-sum.
METHODS = {
    re.sub(r"(?<!^)(?=[A-Z])", "-", vtkLMS3DScanFilter.GetIntersectionMethodName(i)).lower(): i
    for i in range(vtkLMS3DScanFilter.GetNumberOfIntersectionMethods())
}

# A count is an int in VTK.
MAXIMUM_COUNT = 2**31 - 1
MINIMUM_SEED = -2**31
MAXIMUM_THREADS = 1024
