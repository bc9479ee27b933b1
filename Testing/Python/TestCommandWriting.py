#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Where the command line writes: full disks, devices and the standard output."""

import os
import resource
import stat
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from command_line import COARSE, POSE, ROOM, CommandLineTest, read, run
from optional_libraries import needs

SCAN = ("scan", ROOM, *POSE, *COARSE)
RESULTS = (("-o", "vtp"), ("-o", "ply"), ("-o", "csv"), ("-o", "pcd"), ("-o", "ptx"),
           ("--range-image", "vti"), ("--map", "vtp"), ("--map", "ply"), ("--map", "stl"),
           ("--picture", "png"))


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

    @needs("laspy", "lazrs", "pye57", "rosbags")
    def test_files_of_libraries_that_cannot_grow(self):
        """Each library fails at another step, and reports it in its own words."""
        for ending in ("las", "laz", "e57", "db3", "mcap"):
            for limit in (500, 50_000):
                with self.subTest(ending, limit=limit):
                    path = self.folder / f"scan.{ending}"
                    result = run_process(
                        "scan", ROOM, *POSE, "-o", path,
                        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
                    self.assert_failed(result, f"cannot write '{path}': ")
                    self.assert_folder()

    @needs("laspy", "lazrs", "pye57")
    def test_libraries_need_a_file(self):
        for ending in ("las", "laz", "e57"):
            with self.subTest(ending):
                path = self.folder / f"null.{ending}"
                self.make_device("null", path)
                self.assert_failed(run_process(*SCAN, "-o", path),
                                   f"'{path}': .{ending} can only be written to a file")
                self.assertTrue(path.is_char_device())
                path.unlink()

    def test_a_later_result_that_fails(self):
        """The results before it do not replace their files."""
        local_map, old = (self.folder / name for name in ("map.vtp", "old.vtp"))
        full = self.folder / "teapot_map.vtp"
        self.done(*SCAN, "--map", local_map)
        self.make_device("full", full)
        for arguments in ((*SCAN, "-o", old, "--map", full),
                          ("compare", local_map, ROOM, "-o", old, "--scene-points", full),
                          ("demo", "--output", self.folder)):
            with self.subTest(arguments[0]):
                old.write_text("old")
                result = run_process(*arguments)
                self.assertEqual(result.returncode, 1, result.stderr)
                self.assertIn(f"cannot write '{full}': No space left on device".encode(),
                              result.stderr)
                self.assertNotIn(b"wrote", result.stdout)
                self.assertEqual(old.read_text(), "old")
                self.assert_folder(local_map.name, old.name, full.name)

    def test_a_file_before_a_broken_pipe(self):
        """The standard output comes last, and no file gets its name if it fails."""
        reader, writer = os.pipe()
        os.close(reader)
        path = self.folder / "ranges.vti"
        with open(writer, "wb") as pipe:
            self.assert_failed(run_process(*SCAN, "-o", "-", "--range-image", path, stdout=pipe),
                               "Broken pipe")
        self.assert_folder()

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


if __name__ == "__main__":
    unittest.main()
