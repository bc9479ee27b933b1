# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Where the repository is, and what ./run has built of it."""

import os
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
# ./run says which folder its preset has.
BENCHMARK = pathlib.Path(os.environ.get("LMS3D_BUILD_DIR") or ROOT / "build", "bin/lms3dBenchmark")
