# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Libraries that only some tests need, from requirements-formats.txt beside this file.

Without one, its tests are skipped. If the environment variable LMS3D_REQUIRE_FORMATS is set, they
fail instead.
"""

import os
import unittest
from importlib.util import find_spec

_INSTALL = "./run python -m pip install -r Testing/Python/requirements-formats.txt"


def needs(*names):
    """A decorator for a test, or a class of tests, that imports libraries."""
    missing = [name for name in names if find_spec(name) is None]
    is_skipped = missing and not os.environ.get("LMS3D_REQUIRE_FORMATS")
    return unittest.skipIf(is_skipped, f"no Python package {', '.join(missing)}: {_INSTALL}")
