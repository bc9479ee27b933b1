# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads VRML scenes and measures the result, for the tests of VRML."""

import os
import tempfile
import unittest
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING

import lms3d

CASES = Path(os.environ.get("LMS3D_VRML_CASES")
             or Path(__file__).resolve().parents[1] / "Data" / "vrml97")
WARNING, ERROR = 0, 1
HEADER = b"#VRML V2.0 utf8\n"
FACE = "IndexedFaceSet {{ coord Coordinate {{ point [ {} ] }} coordIndex [ {} ] }}"
SQUARE = "Shape { geometry " + FACE.format("0 0 0, 1 0 0, 1 1 0, 0 1 0", "0 1 2 3 -1") + " }\n"


class Scene:
    """The output and messages of vtkVRMLImporterSource. Keyword arguments set its properties."""

    def __init__(self, path, **properties):
        self.errors, self.warnings = [], []
        reader = lms3d.vtkVRMLImporterSource()
        self._keep(reader, "ErrorEvent", self.errors)
        self._keep(reader, "WarningEvent", self.warnings)
        reader.SetFileName(str(path))
        for name, value in properties.items():
            getattr(reader, "Set" + name)(value)
        reader.Update()
        numbers = range(reader.GetNumberOfMessages())
        self.messages = [reader.GetMessage(i) for i in numbers]
        self.severities = [reader.GetMessageSeverity(i) for i in numbers]
        self._measure(reader.GetOutput())

    @staticmethod
    def _keep(speaker, event, texts):
        def keep(_caller, _event, text):
            texts.append(text)
        keep.CallDataType = VTK_STRING
        speaker.AddObserver(event, keep)

    def _measure(self, surface):
        self.triangles = surface.GetNumberOfCells()
        names = surface.GetFieldData().GetAbstractArray("ShapeNames")
        self.names = [names.GetValue(i) for i in range(names.GetNumberOfValues())] if names else []
        self.corners = np.empty((0, 3, 3))
        self.shape_ids, self.colors = np.empty(0, int), np.empty((0, 4), np.uint8)
        if self.triangles:
            points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
            ids = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
            self.corners = points[ids].reshape(self.triangles, 3, 3)
            self.shape_ids = vtk_to_numpy(surface.GetCellData().GetArray("ShapeId"))
            self.colors = vtk_to_numpy(surface.GetCellData().GetArray("Color"))

    def areas(self):
        """The area of each triangle."""
        a, b, c = np.moveaxis(self.corners, 1, 0)
        return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2

    def area(self):
        """The area of all triangles."""
        return self.areas().sum()

    def volume(self):
        """The enclosed volume of a closed surface, positive if its triangles face outwards."""
        a, b, c = np.moveaxis(self.corners, 1, 0)
        return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6

    def bbox(self):
        """The bounds of all triangles, xmin ymin zmin xmax ymax zmax."""
        flat = self.corners.reshape(-1, 3)
        return np.concatenate((flat.min(axis=0), flat.max(axis=0)))

    def color_areas(self):
        """The area of each colour; the keys are texts of four numbers."""
        colors, which = np.unique(self.colors, axis=0, return_inverse=True)
        areas = np.bincount(which.ravel(), self.areas(), len(colors))
        return {" ".join(map(str, color)): area for color, area in zip(colors, areas)}

    def words(self):
        """All messages, errors and warnings, one on each line."""
        return "\n".join(self.messages + self.errors + self.warnings)


class SceneTest(unittest.TestCase):
    """Tests that write scenes, each test into its own folder."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, text, name="scene.wrl"):
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(HEADER + (text if isinstance(text, bytes) else text.encode()))
        return path

    def read(self, text, **properties):
        return Scene(self.write(text), **properties)

    def assert_lost(self, scene, area=None):
        """Requires an error message about lost geometry, and that `area` remains."""
        self.assertEqual(len(scene.errors), 1, scene.messages[:3])
        self.assertIn(ERROR, scene.severities)
        self.assertTrue(np.isfinite(scene.corners).all())
        if area is not None:
            self.assertAlmostEqual(scene.area(), area, places=5, msg=scene.words()[:300])
