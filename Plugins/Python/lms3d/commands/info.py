# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d info: lists what a scene contains, and what was not read."""

from collections import Counter

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import scene_options

NAME = "info"
SUMMARY = "list what a scene contains and what was not read"
DESCRIPTION = """\
Read a scene and print its triangles, bounds and shapes, and a message for everything that was
not read.

A shape of a VRML file has the name that DEF gives to it or to a group around it. Shapes with the
same name are counted together. A message that begins with "error" means lost geometry.
"""
EPILOG = """\
examples:
  lms3d info room.wrl
"""


def add_arguments(parser):
    """Add the options of this command."""
    scene_options.add_scene(parser)


def run(options):
    """Read the scene and print."""
    scene = scene_options.read(options)
    print(f"scene    {scene}")
    bounds = scene.surface.GetBounds()
    for axis, low, high in zip("xyz", bounds[::2], bounds[1::2]):
        print(f"{axis:8} {low:.6g} to {high:.6g} m")
    _print_shapes(scene.surface)
    print(f"messages {len(scene.messages)}")
    for message in scene.messages:
        print(f"  {message}")


def _print_shapes(surface):
    ids = surface.GetCellData().GetArray("ShapeId")
    names = surface.GetFieldData().GetAbstractArray("ShapeNames")
    if not ids or not names:
        return
    shapes, triangles = Counter(), Counter()
    counts = np.bincount(vtk_to_numpy(ids), minlength=names.GetNumberOfValues())
    for i, count in enumerate(counts.tolist()):
        shapes[names.GetValue(i)] += 1
        triangles[names.GetValue(i)] += count
    print(f"shapes   {len(counts):,}")
    for name, count in shapes.items():
        print(f"  {name or '(no name)'}: {count:,} with {triangles[name]:,} triangles")
