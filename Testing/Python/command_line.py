# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the command line as a process, for tests of its exit code, output and files.

The scenes are in the folder LMS3D_DATA_DIR, by default in ../../Data.
"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLWriter

import lms3d

DATA = Path(os.environ.get("LMS3D_DATA_DIR") or Path(__file__).resolve().parents[2] / "Data")
ROOM = DATA / "room.wrl"
TRIANGLES = 804
POSITION = np.array((0.3, -0.2, 1.0))
POSE = ("--position", *POSITION)
BEAMS, TURNS = 361, 360

COARSE_BEAMS, COARSE_TURNS = 31, 24
COARSE = ("--alpha-range", -60, 60, "--alpha-resolution", COARSE_BEAMS,
          "--beta-resolution", COARSE_TURNS)


def run(*arguments, **environment):
    """The finished process of `lms3d ARGUMENTS`; None removes a variable."""
    variables = {**os.environ, **environment}
    return subprocess.run(
        [sys.executable, "-m", "lms3d", *map(str, arguments)], capture_output=True, text=True,
        env={name: text for name, text in variables.items() if text is not None}, timeout=300)


def read(reader, path):
    """The output of a VTK reader for a file."""
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def write(writer, data, path):
    """Write with a VTK writer."""
    writer.SetInputData(data)
    writer.SetFileName(str(path))
    if isinstance(writer, vtkXMLWriter):
        writer.SetDataModeToBinary()  # some versions of VTK cannot read appended data
    writer.Write()


def array(data, name):
    """An array of the point data as numpy."""
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def points(data):
    """The coordinates as numpy."""
    return vtk_to_numpy(data.GetPoints().GetData())


def field(data, name):
    """An array of the field data as numpy, flat."""
    return vtk_to_numpy(data.GetFieldData().GetArray(name)).ravel()


def triangles(data):
    """The corners of each triangle, as numbers of points."""
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def pixels(path):
    """A picture as rows of colours, 0 to 255."""
    image = read(vtkPNGReader(), path)
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3).astype(int)


def room():
    """The scene of most tests."""
    return read(lms3d.vtkVRMLImporterSource(), ROOM)


class CommandLineTest(unittest.TestCase):
    """Gives each class a folder, and checks every run of a command."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)

    def done(self, *arguments, **environment):
        """Run a command that must succeed."""
        result = run(*arguments, **environment)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        return result.stdout

    def refused(self, code, *arguments, **environment):
        """Run a command that must fail with a code and one line of text, and leave no file."""
        before = sorted(self.folder.iterdir())
        result = run(*arguments, **environment)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertRegex(result.stderr, r"\Alms3d: error: [^\n]+\n\Z")
        self.assertEqual(sorted(self.folder.iterdir()), before)
        return result.stderr

    def coarse_ranges(self, name, *arguments):
        """The grid of ranges of a small scan; each row has the beams of a turn."""
        path = self.folder / f"{name}.vti"
        self.done("scan", *arguments, *COARSE, "--range-image", path)
        return array(read(vtkXMLImageDataReader(), path), "Range").reshape(COARSE_TURNS, -1)
