#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The file formats that the command line reads and writes."""

import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLMultiBlockDataWriter,
    vtkXMLPolyDataReader,
    vtkXMLPolyDataWriter,
    vtkXMLUnstructuredGridWriter,
)

from command_line import (
    COARSE,
    POSE,
    ROOM,
    CommandLineTest,
    array,
    points,
    read,
    room,
    triangles,
    write,
)


class TestFormats(CommandLineTest):
    """Each file format, written and read."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for ending in ("vtp", "ply", "csv"):
            cls().done("scan", ROOM, *POSE, *COARSE, "-o", cls.folder / f"scan.{ending}")
        for ending in ("vtp", "ply", "stl"):
            cls().done("scan", ROOM, *POSE, *COARSE, "--map", cls.folder / f"map.{ending}")
        cls.scan = read(vtkXMLPolyDataReader(), cls.folder / "scan.vtp")
        cls.map = read(vtkXMLPolyDataReader(), cls.folder / "map.vtp")

    def test_csv_keeps_every_bit(self):
        table = np.genfromtxt(self.folder / "scan.csv", delimiter=",", names=True)
        names = ("x", "y", "z", "Range", "Alpha", "Beta", "BeamId", "CellId")
        self.assertEqual(table.dtype.names, names)
        np.testing.assert_array_equal(np.stack([table[name] for name in "xyz"], axis=1),
                                      points(self.scan))
        for name in names[3:]:
            expected = array(self.scan, name)
            np.testing.assert_array_equal(table[name].astype(expected.dtype), expected)

    def test_ply_points(self):
        cloud = read(vtkPLYReader(), self.folder / "scan.ply")
        np.testing.assert_allclose(points(cloud), points(self.scan), rtol=1e-6, atol=1e-6)

    def test_ply_map(self):
        surface = read(vtkPLYReader(), self.folder / "map.ply")
        np.testing.assert_array_equal(triangles(surface), triangles(self.map))
        np.testing.assert_allclose(points(surface), points(self.map), rtol=1e-6, atol=1e-6)

    def test_stl_map(self):
        reader = vtkSTLReader()
        reader.MergingOff()
        surface = read(reader, self.folder / "map.stl")
        corners = points(self.map)[triangles(self.map)].reshape(-1, 3)
        np.testing.assert_allclose(points(surface), corners, rtol=1e-6, atol=1e-6)

    def test_every_scene_format_gives_the_same_ranges(self):
        expected = self.coarse_ranges("wrl", ROOM, *POSE)
        scenes = self._copies_of_the_room()
        for path in scenes:
            with self.subTest(path.suffix):
                ranges = self.coarse_ranges("copy", path, *POSE)
                # In single precision a beam that grazes an edge may hit another face.
                self.assertGreater(np.isclose(ranges, expected, atol=1e-4).mean(), 0.99)

    def test_a_scene_with_y_up_is_turned_on_demand(self):
        expected = self.coarse_ranges("z_up", ROOM, *POSE)
        for ending in ("vtp", "wrl"):
            with self.subTest(ending):
                path = self.folder / f"y_up.{ending}"
                {"vtp": self._write_y_up_vtp, "wrl": self._write_y_up_vrml}[ending](path)
                ranges = self.coarse_ranges("y_up", path, *POSE, "--up-axis", "y")
                self.assertGreater(np.isclose(ranges, expected, atol=1e-6).mean(), 0.99)
        words = self.done("scan", path, *POSE, *COARSE, "--up-axis", "y",
                          "-o", self.folder / "words.vtp")
        self.assertIn("turned from y-up to z-up", words)

    @staticmethod
    def _write_y_up_vtp(path):
        z_to_y = vtkTransform()
        z_to_y.RotateX(-90)
        turn = vtkTransformFilter()
        turn.SetTransform(z_to_y)
        turn.SetInputData(room())
        turn.Update()
        write(vtkXMLPolyDataWriter(), turn.GetOutput(), path)

    @staticmethod
    def _write_y_up_vrml(path):
        """The room again as one face set, written by hand."""
        surface = room()
        turned = points(surface)[:, (0, 2, 1)] * (1, 1, -1)
        coordinates = ", ".join("%.9g %.9g %.9g" % tuple(point) for point in turned)
        faces = ", ".join("%d, %d, %d, -1" % tuple(corners) for corners in triangles(surface))
        path.write_text(
            "#VRML V2.0 utf8\nShape { geometry IndexedFaceSet {\n"
            f"coord Coordinate {{ point [ {coordinates} ] }}\ncoordIndex [ {faces} ] }} }}\n")

    def _copies_of_the_room(self):
        surface = room()
        append = vtkAppendFilter()
        append.SetInputData(surface)
        append.Update()
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, surface)
        writers = {"vtp": (vtkXMLPolyDataWriter(), surface), "stl": (vtkSTLWriter(), surface),
                   "ply": (vtkPLYWriter(), surface), "obj": (vtkOBJWriter(), surface),
                   "vtu": (vtkXMLUnstructuredGridWriter(), append.GetOutput()),
                   "vtm": (vtkXMLMultiBlockDataWriter(), blocks)}
        for ending, (writer, data) in writers.items():
            write(writer, data, self.folder / f"room.{ending}")
        (self.folder / "room.vrml").write_bytes(ROOM.read_bytes())
        return [self.folder / f"room.{ending}" for ending in (*writers, "vrml")]


if __name__ == "__main__":
    unittest.main()
