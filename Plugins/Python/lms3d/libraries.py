# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The optional libraries of some file formats."""

from importlib import import_module

from .problems import Problem

# What each format imports. requirements-formats.txt has the names and versions of the packages.
LIBRARIES = {
    ".las": ("laspy",),
    ".laz": ("laspy", "lazrs"),
    ".e57": ("pye57",),
    ".db3": ("rosbags",),
    ".mcap": ("rosbags",),
}

_INSTALL = "./run python -m pip install -r Plugins/Python/requirements-formats.txt"


def check_library(ending, failure):
    """Raise Problem, beginning with `failure`, if a format's library does not load."""
    for name in LIBRARIES.get(ending, ()):
        try:
            import_module(name)
        except ModuleNotFoundError as error:
            raise Problem(f"{failure}: the Python package '{error.name}' is missing; install it: "
                          f"{_INSTALL}") from error
        except ImportError as error:
            raise Problem(f"{failure}: the Python package '{name}' does not load: {error}; install "
                          f"the version of LMS3D: {_INSTALL}") from error
