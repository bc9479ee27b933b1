#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Where the command line writes: full disks, devices, the standard output, and its memory."""

import io
import os
import resource
import stat
import subprocess
import sys
import tempfile
import tracemalloc
import unittest
from pathlib import Path
from unittest import mock

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from command_line import COARSE, POSE, ROOM, CommandLineTest, array, points, read, run

SCAN = ("scan", ROOM, *POSE, *COARSE)
RESULTS = (("-o", "vtp"), ("-o", "ply"), ("-o", "csv"), ("--range-image", "vti"),
           ("--map", "vtp"), ("--map", "ply"), ("--map", "stl"), ("--picture", "png"))


def run_process(*arguments, **options):
    """The finished process of `lms3d ARGUMENTS`, with options of subprocess.run; bytes."""
    return subprocess.run([sys.executable, "-m", "lms3d", *map(str, arguments)], timeout=300,
                          **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options})


class TestFullDisks(CommandLineTest):
    """A disk that is full: one line says so, and no incomplete file remains."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def assert_failed(self, result, words):
        """One line of error. The other lines are there if a result goes to the standard output."""
        self.assertEqual(result.returncode, 1, result.stderr)
        lines = result.stderr.decode().splitlines()
        self.assertEqual([line for line in lines if not line.startswith(("scene  ", "scan  "))],
                         lines[-1:])
        self.assertRegex(lines[-1], r"\Alms3d: error: ")
        self.assertIn(words, lines[-1])

    def assert_folder(self, *names):
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), sorted(names))

    @staticmethod
    def limit_files():
        resource.setrlimit(resource.RLIMIT_FSIZE, (500, 500))

    def test_files_that_cannot_grow(self):
        for option, ending in RESULTS:
            with self.subTest(option + ending):
                path = self.folder / f"old.{ending}"
                path.write_text("old")
                result = run_process(*SCAN, option, path, preexec_fn=self.limit_files)
                self.assert_failed(result, f"cannot write '{path}': File too large")
                self.assertEqual(path.read_text(), "old")
                self.assert_folder(path.name)
                path.unlink()

    def make_device(self, name, path):
        """Make the path a device. By a link a fault could replace the system's own device."""
        if os.geteuid() != 0:
            path.symlink_to(f"/dev/{name}")
            return
        try:
            os.mknod(path, 0o666 | stat.S_IFCHR, os.stat(f"/dev/{name}").st_rdev)
            path.open("wb").close()
        except OSError as error:
            self.skipTest(f"no device can be made here: {error}")

    def test_a_full_device(self):
        for option, ending in RESULTS:
            with self.subTest(option + ending):
                path = self.folder / f"full.{ending}"
                self.make_device("full", path)
                result = run_process(*SCAN, option, path)
                self.assert_failed(result, f"cannot write '{path}': No space left on device")
                self.assert_folder(path.name)
                path.unlink()

    def test_a_series(self):
        path = self.folder / "scans.pvd"
        trajectory = ROOM.parent / "journey.vtp"
        result = run_process("scan", ROOM, "--trajectory", trajectory, *COARSE, "-o", path,
                             preexec_fn=self.limit_files)
        self.assert_failed(result, f"'{self.folder / 'scans_0000.vtp'}': File too large")
        self.assert_folder()

    def test_the_standard_output(self):
        with open("/dev/full", "wb") as full:
            self.assert_failed(run_process(*SCAN, "-o", "-", stdout=full),
                               "cannot write the standard output: No space left on device")
            self.assert_failed(run_process("info", ROOM, stdout=full),
                               "standard output: No space left on device")

    def test_a_closed_pipe(self):
        reader, writer = os.pipe()
        os.close(reader)
        with open(writer, "wb") as pipe:
            self.assert_failed(run_process(*SCAN, "-o", "-", stdout=pipe), "Broken pipe")

    def test_devices_and_pipes_are_not_replaced(self):
        path = self.folder / "null.csv"
        self.make_device("null", path)
        self.done(*SCAN, "-o", path)
        self.assertTrue(path.is_char_device())


class TestStandardOutput(CommandLineTest):
    """In place of a file name: -."""

    def test_the_bytes_are_those_of_a_file(self):
        for option, ending in (("-o", "csv"), ("--range-image", "vti"), ("--map", "ply"),
                               ("--picture", "png")):
            with self.subTest(ending):
                path = self.folder / f"file.{ending}"
                self.done(*SCAN, option, path)
                result = run_process(*SCAN, option, "-")
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual(result.stdout, path.read_bytes())
                self.assertIn(b"scene    room.wrl", result.stderr)
                path.unlink()

    def test_a_file_beside_it(self):
        path = self.folder / "map.vtp"
        result = run(*SCAN, "-o", "-", "--map", path)
        self.assertEqual(result.stdout.splitlines()[0], "x,y,z,Range,Alpha,Beta,BeamId,CellId")
        self.assertGreater(read(vtkXMLPolyDataReader(), path).GetNumberOfPolys(), 0)
        path.unlink()

    def test_what_cannot_go_there(self):
        trajectory = ROOM.parent / "journey.vtp"
        words = self.refused(2, "scan", ROOM, "--trajectory", trajectory, "-o", "-")
        self.assertIn(".pvd", words)
        self.assertIn("two names", self.refused(2, *SCAN, "-o", "-", "--map", "-"))

    def test_no_binary_format_on_a_terminal(self):
        master, slave = os.openpty()
        with open(master, "rb"), open(slave, "wb") as terminal:
            result = run_process(*SCAN, "--map", "-", stdout=terminal)
        self.assertEqual(result.returncode, 2)
        self.assertIn(b"binary", result.stderr)


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

        with mock.patch("lms3d.formats._convert_rows", side_effect=MemoryError):
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
