# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Options that several commands share: the scene, and the limits of its reader."""

import argparse

from .. import vtkVRMLImporterSource
from ..scene import LIMITS, READERS, UP_AXES, read_scene

# In MB this is less than VTK's integers hold in bytes.
_MAXIMUM_LIMIT = 10**12


def add_scene(parser, is_needed=True):
    """Add the scene, its up axis, its root folder and its limits."""
    parser.add_argument("scene", metavar="SCENE", nargs=None if is_needed else "?",
                        help="the scene's file: " + " ".join(READERS))
    parser.add_argument("--up-axis", choices=UP_AXES, default="file",
                        help="file: z is up, or what the format says: glTF is y-up and is turned "
                        "to z-up (default); y: the file is y-up, as most VRML and many OBJ files "
                        "are, and is turned; z: the axes are kept")
    parser.add_argument("--scene-root", metavar="FOLDER",
                        help="folder that contains all other files of a VRML scene, also in "
                        "subfolders (default: the scene's folder)")
    _add_limits(parser.add_argument_group("limits for VRML scenes"))


def _add_limits(group):
    reader = vtkVRMLImporterSource()
    for name, what in (("nodes", "nodes, where each USE and each instance counts again"),
                       ("triangles", "triangles"),
                       ("memory", "MB of memory for what is made of the files"),
                       ("size", "MB of all files, unpacked")):
        property_name, unit = LIMITS[name]
        default = getattr(reader, "Get" + property_name)() // unit
        group.add_argument(f"--scene-{name}", type=_limit, metavar="N",
                           help=f"at most this many {what} (default: {default})")


def limits(options):
    """The limits of the VRML reader that the options set, by the keys of LIMITS."""
    given = {name: getattr(options, f"scene_{name}") for name in LIMITS}
    return {name: value for name, value in given.items() if value is not None}


def read(options):
    """Read the scene of the options."""
    return read_scene(options.scene, options.up_axis, options.scene_root, limits(options))


def _limit(text):
    value = int(text)
    if not 0 < value <= _MAXIMUM_LIMIT:
        raise argparse.ArgumentTypeError(f"{text.strip()} is not within 1 to {_MAXIMUM_LIMIT}")
    return value
