# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Finds the scenes that are installed with LMS3D."""

import os
from pathlib import Path

from .problems import Problem

_INSTALLED = Path(__file__).parent / "data"


def scene_file(name, folder=None):
    """Path of a scene that is installed with LMS3D, for example "room.wrl".

    Searches `folder` if given, else the folder in the environment variable LMS3D_DATA_DIR, else the
    folder "data" of this package.
    """
    location = Path(folder or os.environ.get("LMS3D_DATA_DIR") or _INSTALLED)
    if not (location / name).is_file():
        raise Problem(f"there is no {name} in '{location}': give the folder by --data or by the "
                      "environment variable LMS3D_DATA_DIR")
    return location / name
