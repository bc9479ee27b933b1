# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The paths that the charts use."""

import os
import pathlib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
DATA = ROOT / "Data"
CHART_FOLDER = ROOT / "Documentation" / "charts"
# ./run sets the build folder of its preset.
BENCHMARK = pathlib.Path(os.environ.get("LMS3D_BUILD_DIR") or ROOT / "build", "bin/lms3dBenchmark")
# The virtual environment of the libraries that are compared.
ENVIRONMENT = ROOT / "build" / "peers"
