# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Where the scenes that come with LMS3D are."""

import os
from pathlib import Path

from .problems import Problem

_INSTALLED = Path(__file__).parent / "data"


def scene_file(name, folder=None):
    """Path of a scene that comes with LMS3D, for example "room.wrl".

    Looked for in `folder` if given, else in the folder that the environment variable
    LMS3D_DATA_DIR names, else beside this package.
    """
    place = Path(folder or os.environ.get("LMS3D_DATA_DIR") or _INSTALLED)
    if not (place / name).is_file():
        raise Problem(f"there is no {name} in '{place}': name the folder with --data or in the "
                      "environment variable LMS3D_DATA_DIR")
    return place / name
