# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Entry point of ``python3 -m lms3d``."""

import sys

from . import _loading

try:
    from .cli import main

    sys.exit(main())
except KeyboardInterrupt:
    _loading.exit_interrupted()
