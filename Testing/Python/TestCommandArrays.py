#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Files that the command line writes with numpy: contents, permissions, and its memory."""

import io
import os
import stat
import tracemalloc
import unittest
from unittest import mock

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from command_line import COARSE, POSE, ROOM, CommandLineTest, array, points, read

SCAN = ("scan", ROOM, *POSE, *COARSE)


class TestArrays(CommandLineTest):
    """Formats that numpy writes."""

    def test_ply_points_carry_the_arrays(self):
        self.done(*SCAN, "-o", self.folder / "scan.ply")
        self.done(*SCAN, "-o", self.folder / "scan.vtp")
        header, body = (self.folder / "scan.ply").read_bytes().split(b"end_header\n", 1)
        types = {"float": "<f4", "double": "<f8", "int": "<i4"}
        names = [line.split()[1:] for line in header.decode().splitlines()
                 if line.startswith("property")]
        self.assertEqual(names, [["float", "x"], ["float", "y"], ["float", "z"],
                                 ["double", "Range"], ["float", "Alpha"], ["float", "Beta"],
                                 ["int", "BeamId"], ["int", "CellId"]])
        table = np.frombuffer(body, [(name, types[kind]) for kind, name in names])
        scan = read(vtkXMLPolyDataReader(), self.folder / "scan.vtp")
        self.assertEqual(len(table), scan.GetNumberOfPoints())
        for name in ("Range", "Alpha", "Beta", "BeamId", "CellId"):
            np.testing.assert_array_equal(table[name], array(scan, name))
        np.testing.assert_array_equal(table["x"], points(scan)[:, 0].astype(np.float32))

    def test_a_map_without_triangles(self):
        for ending in ("ply", "stl", "vtp"):
            with self.subTest(ending):
                path = self.folder / f"empty.{ending}"
                self.done("scan", ROOM, *POSE, "--alpha-range", 0, 0, "--alpha-resolution", 1,
                          "--beta-resolution", 1, "--maximum-error", 0, "--map", path)
        surface = read(vtkXMLPolyDataReader(), self.folder / "empty.vtp")
        self.assertEqual(surface.GetNumberOfPolys(), 0)
        self.assertIn(b"element vertex ", (self.folder / "empty.ply").read_bytes())
        self.assertEqual((self.folder / "empty.stl").read_bytes()[80:], bytes(4))

    def test_the_permissions_of_a_file_stay(self):
        from lms3d.results import save

        path = self.folder / "kept.csv"
        path.touch()
        for mode in (0o600, 0o664):
            path.chmod(mode)
            save(self._scan(1), path)
            self.assertEqual(stat.S_IMODE(path.stat().st_mode), mode)

    def test_a_temporary_file_that_exists_is_not_touched(self):
        from lms3d.problems import Problem
        from lms3d.results import save

        other = self.folder / f".new.{os.getpid()}.csv"
        other.write_text("other")
        with self.assertRaisesRegex(Problem, f"delete '{other}' first"):
            save(self._scan(1), self.folder / "new.csv")
        self.assertEqual(other.read_text(), "other")
        self.assertFalse((self.folder / "new.csv").exists())

    def test_ids_that_ply_s_integers_cannot_hold(self):
        from lms3d.results import save

        path = self.folder / "large.ply"
        save(self._scan(3, 2**40), path)
        header, body = path.read_bytes().split(b"end_header\n", 1)
        self.assertIn(b"property double CellId\n", header)
        self.assertEqual(np.frombuffer(body[-8:], "<f8"), 2**40 + 2)

    def test_csv_takes_little_memory_and_shows_progress(self):
        from lms3d.results import save

        terminal = io.StringIO()
        terminal.isatty = lambda: True
        scan = self._scan(200_000)
        tracemalloc.start()
        self.addCleanup(tracemalloc.stop)
        with mock.patch("sys.stderr", terminal):
            save(scan, self.folder / "large.csv")
        self.assertLess(tracemalloc.get_traced_memory()[1], 40e6)
        self.assertIn("writing", terminal.getvalue())
        self.assertIn("100 %", terminal.getvalue())
        with open(self.folder / "large.csv", encoding="ascii") as file:
            lines = file.read().splitlines()
        self.assertEqual(len(lines), 200_001)
        self.assertEqual(lines[-1], "199999.0,0.0,0.0,0.1,0.1,0.1,199999,199999")

    def test_memory_that_ends_is_said_in_one_line(self):
        from lms3d.problems import Problem
        from lms3d.results import save

        with mock.patch("lms3d.formats.convert_rows", side_effect=MemoryError):
            with self.assertRaisesRegex(Problem, "not enough memory"):
                save(self._scan(1), self.folder / "none.csv")
        self.assertFalse((self.folder / "none.csv").exists())

    @staticmethod
    def _scan(count, first_id=0):
        places = np.zeros((count, 3))
        places[:, 0] = np.arange(count)
        coordinates = vtkPoints()
        coordinates.SetData(numpy_to_vtk(places, deep=True))
        scan = vtkPolyData()
        scan.SetPoints(coordinates)
        ids = np.arange(count)
        for name, values in (("Range", np.full(count, 0.1)),
                             ("Alpha", np.full(count, 0.1, np.float32)),
                             ("Beta", np.full(count, 0.1, np.float32)),
                             ("BeamId", ids.astype(np.int32)), ("CellId", first_id + ids)):
            values = numpy_to_vtk(values, deep=True)
            values.SetName(name)
            scan.GetPointData().AddArray(values)
        return scan


if __name__ == "__main__":
    unittest.main()
