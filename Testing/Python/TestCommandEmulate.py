#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d emulate: its lines, link, end, platform and sources, read through the pseudo-terminal."""

import fcntl
import os
import signal
import subprocess
import sys
import termios
import time
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataWriter

from command_line import POSE, ROOM, CommandLineTest, array, read, write
from emulator_process import EmulatorProcess, PortHost

FAR = ("--maximum-range", 7)  # all ranges of the room fit into 13 bits of millimetres
TURNS = ("--beta-resolution", 4)
LMS200 = ("--device", "lms200-mm", "--seed", 5)


def receive(port, count):
    """A number of requested scans: metres, NaN for the code of no signal."""
    with PortHost(port) as host:
        words = [np.frombuffer(host.ask(0x30, 1)[3:], "<u2") for _ in range(count)]
    return np.where(np.equal(words, 8191), np.nan, np.array(words) / 1000)


class TestLifeOfTheCommand(CommandLineTest):
    def test_lines_and_link(self):
        link = self.folder / "lms200"
        with EmulatorProcess(ROOM, *POSE, "--link", link) as emulator:
            self.assertEqual(emulator.lines, [
                "scene    room.wrl: 804 triangles, axes as in the file, z is up",
                "device   LMS200;301063;V02.30, ranges ideal, mm, 9600 Bd, pace of the line",
                f"port     {emulator.port}, link {link}"])
            self.assertEqual(os.readlink(link), emulator.port)
            receive(link, 2)
            emulator.process.send_signal(signal.SIGINT)
            self.assertEqual(emulator.finish(), (0, "ended    after 2 fans\n"))
        self.assertFalse(os.path.lexists(link))

    def test_signals(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            for with_host in (False, True):
                link = self.folder / "lms200"
                with self.subTest(number, with_host=with_host), \
                        EmulatorProcess(ROOM, *POSE, "--link", link) as emulator:
                    if with_host:
                        host = PortHost(link)
                        self.addCleanup(host.__exit__)
                    emulator.process.send_signal(number)
                    self.assertEqual(emulator.finish()[0], 0)
                    self.assertFalse(os.path.lexists(link))

    def test_a_closed_terminal(self):
        link = self.folder / "lms200"
        master, slave = os.openpty()
        process = subprocess.Popen(
            [sys.executable, "-m", "lms3d", "emulate", str(ROOM), *map(str, POSE), "--link", link],
            stdin=slave, stdout=slave, stderr=slave, start_new_session=True,
            preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0))
        os.close(slave)
        text = b""
        while b"port " not in text:
            text += os.read(master, 1000)
        os.close(master)
        self.assertEqual(process.wait(30), 0)
        self.assertFalse(os.path.lexists(link))

    def test_problems(self):
        for code, words in ((2, (ROOM,)), (2, POSE), (2, (ROOM, *POSE, "--scan", "a.vtp")),
                            (2, ("--scan", "a.vtp", *POSE)), (1, ("--scan", "a.vtp")),
                            (2, (ROOM, *POSE, "--turn", "fast")),
                            (2, (ROOM, *POSE, "--turn", "inf")),
                            (2, (ROOM, *POSE, "--unit", "dm")),
                            (2, (ROOM, *POSE, "--device", "x"))):
            with self.subTest(words):
                self.refused(code, "emulate", *words)

    def test_options_that_a_stored_scan_has_decided(self):
        for option, words in (("--beta-range", (0, 90)), ("--beta-resolution", (4,)),
                              ("--orientation", (0, 0, 90)), ("--minimum-range", (1,)),
                              ("--maximum-range", (7,)), ("--up-axis", ("y",))):
            with self.subTest(option):
                problem = self.refused(2, "emulate", "--scan", "a.vtp", option, *words)
                self.assertIn(f"--scan: a stored scan has its own {option}", problem)

    def test_one(self):
        """Numbers of one have no plural."""
        scene = self.folder / "one.obj"
        scene.write_text("v 1 -9 -9\nv 1 9 -9\nv 1 0 9\nf 1 2 3\n")
        with EmulatorProcess(scene, "--position", 0, 0, 0) as emulator:
            receive(emulator.port, 1)
            emulator.process.terminate()
            self.assertEqual(emulator.finish(), (0, "ended    after 1 fan\n"))
            self.assertIn("scene    one.obj: 1 triangle, axes", emulator.lines[0])


class TestFans(CommandLineTest):
    def scan(self, name, *arguments):
        """The ranges of lms3d scan, a row for each turn."""
        path = self.folder / f"{name}.vti"
        self.done("scan", ROOM, *arguments, "--range-image", path)
        image = read(vtkXMLImageDataReader(), path)
        return array(image, "Range").reshape(-1, 361)

    def test_a_whole_scan(self):
        """The fans are the turns of lms3d scan, to half a millimetre."""
        expected = self.scan("ideal", *POSE, *TURNS, *FAR)
        with EmulatorProcess(ROOM, *POSE, *TURNS, *FAR) as emulator:
            found = receive(emulator.port, 4)
        np.testing.assert_array_equal(np.isnan(found), np.isnan(expected))
        np.testing.assert_allclose(found, expected, atol=0.5001e-3)

    def test_errors(self):
        """The first scan is lms3d scan with the same errors; the next has noise of its own."""
        expected = self.scan("errors", *POSE, *TURNS, *FAR, *LMS200)
        with EmulatorProcess(ROOM, *POSE, *TURNS, *FAR, "--device", "lms200-mm",
                             "--seed", 5) as emulator:
            found = receive(emulator.port, 8)
        np.testing.assert_allclose(found[:4], expected, atol=1e-9)
        differences = (found[4:] - found[:4])[~np.isnan(expected)]
        self.assertAlmostEqual(differences.std(), 0.005 * 2**0.5, delta=0.0005)

    def test_a_stored_scan(self):
        path = self.folder / "stored.vtp"
        self.done("scan", ROOM, *POSE, *TURNS, *FAR, "-o", path)
        expected = self.scan("stored", *POSE, *TURNS, *FAR)
        with EmulatorProcess("--scan", path) as emulator:
            found = receive(emulator.port, 5)
            with PortHost(emulator.port) as host:  # the scan has no quarters of a degree
                self.assertEqual(host.ask(0x3B, 100, 0, 25, 0)[1], 0)
                self.assertEqual(host.ask(0x3B, 100, 0, 100, 0)[1], 1)
                self.assertEqual(len(host.ask(0x30, 1)), 3 + 2 * 101)
        np.testing.assert_allclose(found, [*expected, expected[0]], atol=0.5001e-3)

    def test_a_scan_that_has_no_variant(self):
        path = self.folder / "odd.vtp"
        self.done("scan", ROOM, *POSE, "--alpha-resolution", 7, *TURNS, "-o", path)
        self.assertIn("has not the beams", self.refused(1, "emulate", "--scan", path))

    def test_a_trajectory(self):
        """One scan for each pose, as lms3d scan; the last pose stays."""
        path = self.folder / "path.vtp"
        points = vtkPoints()
        points.SetData(numpy_to_vtk(np.array(((0.3, -0.2, 1.0), (0.0, 0.0, 1.2))), deep=True))
        trajectory = vtkPolyData()
        trajectory.SetPoints(points)
        write(vtkXMLPolyDataWriter(), trajectory, path)
        with EmulatorProcess(ROOM, "--trajectory", path, *TURNS, *FAR) as emulator:
            found = receive(emulator.port, 12)
        for i, position in enumerate(((0.3, -0.2, 1.0), (0.0, 0.0, 1.2), (0.0, 0.0, 1.2))):
            expected = self.scan(f"pose{i}", "--position", *position, *TURNS, *FAR)
            np.testing.assert_allclose(found[4 * i:4 * i + 4], expected, atol=0.5001e-3)

    def test_a_steady_turn(self):
        """The angles grow with time, and the fans are those at the angles."""
        angles = self.folder / "angles.csv"
        with EmulatorProcess(ROOM, *POSE, *FAR, "--turn", 30, "--angles", angles) as emulator:
            found = receive(emulator.port, 4)
            time.sleep(0.1)
        lines = np.loadtxt(angles, delimiter=",", skiprows=1)
        np.testing.assert_allclose(np.diff(lines[:, 3]), 30 * np.diff(lines[:, 2]), atol=1e-3)
        for fan, angle in zip(found, lines[:, 3]):
            expected = self.scan("turned", *POSE, *FAR, "--beta-range", angle, angle,
                                 "--beta-resolution", 1)[0]
            np.testing.assert_allclose(fan[::2], expected[::2], atol=0.5001e-3)


if __name__ == "__main__":
    unittest.main()
