#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d scan --trajectory: its series of files, what it refuses, and its progress."""

import io
import os
import re
import signal
import subprocess
import sys
import unittest
from contextlib import redirect_stderr
from pathlib import Path
from unittest import mock

import numpy as np
from lms3d import vtkLMS3DMapFusion
from lms3d.problems import Problem
from lms3d.results import ResultFiles
from lms3d.scene import read_scene
from lms3d.simulation import Simulation
from lms3d.trajectory import Series, TrajectoryScan
from command_line import COARSE, ROOM, array, field, points, read, room, write
from journeys import PLACES, TrajectoryTest, trajectory
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

TIMES = (2.0, 2.5, 4.25)


class TestTrajectory(TrajectoryTest):
    """The room from three poses."""

    def test_each_step_is_the_scan_from_its_pose(self):
        words = self.done("scan", ROOM, "--trajectory", self.path(Time=TIMES), *COARSE,
                          "-o", self.folder / "scans.pvd", "--map", self.folder / "maps.pvd")
        self.assertIn("3 from time 2 to 4.25", words)
        names = [f"{result}_{i:04}.vtp" for result in ("maps", "scans") for i in range(3)]
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()),
                         sorted(["path.vtp", "maps.pvd", "scans.pvd", *names]))
        times, scans = self.steps("scans.pvd")
        self.assertEqual(times, list(TIMES))
        map_times, maps = self.steps("maps.pvd")
        self.assertEqual(map_times, times)
        for place, scan, surface in zip(PLACES, scans, maps):
            single, single_map = (self.folder / name for name in ("single.vtp", "single_map.vtp"))
            self.done("scan", ROOM, "--position", *place, *COARSE, "-o", single, "--map", single_map)
            expected = read(vtkXMLPolyDataReader(), single)
            np.testing.assert_array_equal(points(scan), points(expected))
            for name in ("Range", "BeamId", "CellId"):
                np.testing.assert_array_equal(array(scan, name), array(expected, name))
            np.testing.assert_array_equal(
                points(surface), points(read(vtkXMLPolyDataReader(), single_map)))

    def test_the_sensor_looks_along_a_polyline(self):
        self.done("scan", ROOM, "--trajectory", self.path(line=True), *COARSE,
                  "-o", self.folder / "scans.pvd")
        times, scans = self.steps("scans.pvd")
        self.assertEqual(times, [0, 1, 2])
        ahead = PLACES[2] - PLACES[0]
        np.testing.assert_allclose(field(scans[1], "SensorToWorld").reshape(4, 4)[:3, 0],
                                   ahead / np.linalg.norm(ahead), rtol=0, atol=1e-15)

    def test_a_quaternion_turns_the_sensor(self):
        half = np.sqrt(0.5)
        self.done("scan", ROOM, "--trajectory", self.path(Orientation=[(half, 0, 0, half)] * 3),
                  *COARSE, "-o", self.folder / "scans.pvd")
        for scan in self.steps("scans.pvd")[1]:
            np.testing.assert_allclose(field(scan, "SensorToWorld").reshape(4, 4)[:3, 0],
                                       (0, 1, 0), rtol=0, atol=1e-15)

    def test_what_is_refused_leaves_no_files(self):
        self.path(Time=(0, 2, 2)).rename(self.folder / "bad.vtp")
        path = self.path()
        series = ("-o", self.folder / "scans.pvd")
        cases = {
            "not allowed with argument": (2, "--trajectory", path, "--position", 0, 0, 1, *series),
            "ending must be .pvd": (2, "--trajectory", path, "-o", self.folder / "scan.vtp"),
            "only -o, --map and --fused": (2, "--trajectory", path, *series,
                                  "--picture", self.folder / "picture.png"),
            "ending is not one of .vtp": (2, "--trajectory", "path.csv", *series),
            "cannot read trajectory 'nowhere.vtp'": (1, "--trajectory", "nowhere.vtp", *series),
            "Time 2 at its point 2, after 2": (1, "--trajectory", self.folder / "bad.vtp", *series),
            "no beam returned from any pose": (1, "--trajectory", path, *series,
                                               "--maximum-range", 0.01),
            "would have the same names": (2, "--trajectory", path, *series,
                                          "--map", self.folder / "scans.PVD"),
            "ending must be .vtp or .ply or .csv": (2, "--position", 0, 0, 1, *series),
        }
        for words, (code, *arguments) in cases.items():
            with self.subTest(words):
                self.assertIn(words, self.refused(code, "scan", ROOM, *COARSE, *arguments))

    def test_a_series_does_not_replace_its_inputs(self):
        path = self.path()
        scene = self.folder / "scans_0001.vtp"
        write(vtkXMLPolyDataWriter(), room(), scene)
        before = scene.read_bytes()
        words = self.refused(2, "scan", scene, "--trajectory", path, *COARSE,
                             "-o", self.folder / "scans.pvd")
        self.assertIn("would be replaced", words)
        self.assertEqual(scene.read_bytes(), before)

    def test_a_folder_with_the_name_of_a_step_is_reported_before_the_first_scan(self):
        path = self.path()
        (self.folder / "maps_0002.vtp").mkdir()
        # If the command scanned first, it would report that no beam returns.
        words = self.refused(1, "scan", ROOM, "--trajectory", path, *COARSE, "--maximum-range", 0.01,
                             "-o", self.folder / "scans.pvd", "--map", self.folder / "maps.pvd")
        self.assertIn("maps_0002.vtp': that is a folder", words)

    def test_a_folder_that_appears_during_the_scans_is_reported(self):
        path = self.folder / "scans_0001.vtp"
        with self.assertRaisesRegex(Problem, f"cannot write '{path}': Is a directory"), \
                Series(self.folder / "scans.pvd", 2, ()) as series, ResultFiles() as files:
            for time in (0.0, 1.0):
                series.add(trajectory(), time)
            series.finish(files)
            path.mkdir()
        self.assertEqual(list(self.folder.iterdir()), [path])

    def replace_series(self):
        """Replace a series of two old files and their list."""
        self.names = ("scans.pvd", "scans_0000.vtp", "scans_0001.vtp")
        for name in self.names:
            (self.folder / name).write_text("old")
        with Series(self.folder / "scans.pvd", 2, ()) as series, ResultFiles() as files:
            for time in (0.0, 1.0):
                series.add(trajectory(), time)
            series.finish(files)

    def count_old_files(self):
        """How many files of the series are old; there are no other files."""
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), sorted(self.names))
        return sum((self.folder / name).read_text() == "old" for name in self.names)

    def test_a_list_that_cannot_be_written_leaves_the_old_series(self):
        with self.assertRaisesRegex(Problem, "scans.pvd': No space left"), \
                mock.patch.object(Path, "write_text", self.fail_for_new_lists):
            self.replace_series()
        self.assertEqual(self.count_old_files(), 3)

    @staticmethod
    def fail_for_new_lists(path, text, encoding=None):
        """Path.write_text on a disk that is full for a list."""
        if text.startswith("<?xml"):
            raise OSError(28, "No space left on device")
        path.write_bytes(text.encode(encoding or "utf-8"))

    def test_two_series_are_published_together(self):
        path = self.path()
        names = ("scans.pvd", "scans_0000.vtp", "maps.pvd", "maps_0000.vtp")
        for name in names:
            (self.folder / name).write_text("old")
        code = ("import sys\nfrom pathlib import Path\nfrom lms3d import cli\n"
                "write_text = Path.write_text\n"
                "def write(path, *args, **named):\n"
                "    if path.name == 'scans.pvd':\n"
                "        raise OSError(28, 'No space left on device')\n"
                "    return write_text(path, *args, **named)\n"
                "Path.write_text = write\nsys.exit(cli.main())\n")
        result = subprocess.run(
            [sys.executable, "-c", code, "scan", str(ROOM), "--trajectory", str(path),
             *map(str, COARSE), "-o", str(self.folder / names[0]), "--map",
             str(self.folder / names[2])], capture_output=True, text=True, timeout=300, check=False)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("scans.pvd': No space left", result.stderr)
        self.assertEqual({(self.folder / name).read_text() for name in names}, {"old"})
        self.assertEqual(sorted(each.name for each in self.folder.iterdir()),
                         sorted([*names, path.name]))

    def test_an_interrupted_series_is_complete(self):
        replace = os.replace

        def replace_and_interrupt(temporary, path):
            replace(temporary, path)
            if path.parent == self.folder.resolve():
                signal.raise_signal(signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt), \
                mock.patch("os.replace", replace_and_interrupt):
            self.replace_series()
        self.assertEqual(self.count_old_files(), 0)


class Terminal(io.StringIO):
    """A stream that shows progress bars."""

    def isatty(self):
        return True


class TestProgress(unittest.TestCase):
    """One bar for all steps."""

    def check_bar(self, simulation, works):
        """Scan, map and more: the bar never goes back, and each work begins where one ends."""
        scans = TrajectoryScan(simulation, trajectory())
        with redirect_stderr(Terminal()) as shown:
            for _ in scans.run(with_map=True):
                pass
        percents = [int(number) for number in re.findall(r"(\d+) %", shown.getvalue())]
        self.assertEqual(percents, sorted(percents))
        self.assertEqual(percents[-1], 100)
        for number in range(1, works):
            self.assertIn(round(100 * number / works), percents)
        return shown.getvalue()

    def test_it_never_goes_back_and_ends_at_100(self):
        self.check_bar(Simulation(read_scene(ROOM)), 6)

    def test_with_one_map_of_all_poses(self):
        simulation = Simulation(read_scene(ROOM))
        simulation.add_fusion(vtkLMS3DMapFusion())
        shown = self.check_bar(simulation, 9)
        for step in (1, 2, 3):
            self.assertIn(f"joining {step}", shown)


if __name__ == "__main__":
    unittest.main()
