#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Programs that read the emulated LMS 200: the example, and drivers of robots' software.

LMS3D_MRPT is the program readWithMRPT; without Debian's libmrpt-hwdrivers-dev it is not built.
"""

import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

from command_line import POSE, ROOM, CommandLineTest, array, read
from emulator_process import EmulatorProcess

EXAMPLES = Path(__file__).resolve().parents[2] / "Plugins" / "Python" / "Examples"
MRPT = os.environ.get("LMS3D_MRPT")
TURNS = 24

# Asks a terminal for its serial port, sets a divisor, and tries another request.
SET_DIVISOR = """
import array, fcntl, os, sys, termios
port = os.open(sys.argv[1], os.O_RDWR | os.O_NOCTTY)
settings = array.array("i", [0] * 40)
fcntl.ioctl(port, 0x541E, settings)  # TIOCGSERIAL
print(settings[7])
fcntl.ioctl(port, 0x541F, settings)  # TIOCSSERIAL
try:
    fcntl.ioctl(port, termios.TIOCMGET, settings)
except OSError as error:
    print(error.errno)
"""


class TestExamples(CommandLineTest):
    def test_the_3d_scan(self):
        """The example rebuilds the scan from port and angles. It uses no package."""
        image = self.folder / "direct.vti"
        self.done("scan", ROOM, *POSE, "--beta-resolution", TURNS, "--range-image", image)
        expected = array(read(vtkXMLImageDataReader(), image), "Range").reshape(TURNS, 361)
        angles = self.folder / "angles.csv"
        with EmulatorProcess(ROOM, *POSE, "--beta-resolution", TURNS,
                             "--angles", angles) as emulator:
            done = subprocess.run([sys.executable, "-I", EXAMPLES / "assemble_scan.py",
                                   emulator.port, angles, str(TURNS)], capture_output=True,
                                  text=True, timeout=60, check=False)
        self.assertEqual(done.stderr, "")
        x, y, z, ranges, beams, beta = np.loadtxt(done.stdout.splitlines(), delimiter=",",
                                                  skiprows=1).T
        found = np.full((TURNS, 361), np.nan)
        found[np.rint(beta * TURNS / 360).astype(int), beams.astype(int)] = ranges
        np.testing.assert_allclose(found, expected, atol=0.5001e-3)
        np.testing.assert_allclose(np.hypot(np.hypot(x, y), z), ranges, atol=2e-6)
        np.testing.assert_allclose(z, ranges * np.sin(np.radians(beams / 2 - 90)), atol=2e-6)
        angle = -np.degrees(np.arctan2(y, x))
        away = (angle - beta + 180) % 360 - 180
        np.testing.assert_allclose(away[(beams > 5) & (beams < 355)], 0, atol=0.1)

    @unittest.skipUnless(shutil.which("gcc"), "no C compiler (Debian: gcc)")
    def test_a_custom_divisor(self):
        """With the preload example a divisor is accepted; other requests still fail."""
        library = self.folder / "serial_divisor.so"
        subprocess.run(["gcc", "-shared", "-fPIC", "-Wall", "-Wextra", "-Werror", "-o", library,
                        EXAMPLES / "serial_divisor.c", "-ldl"], check=True)
        master, slave = os.openpty()
        self.addCleanup(os.close, master)
        self.addCleanup(os.close, slave)
        command = [sys.executable, "-c", SET_DIVISOR, os.ttyname(slave)]
        plain = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertIn("Inappropriate ioctl", plain.stderr)
        loaded = subprocess.run(command, capture_output=True, text=True, check=False,
                                env={**os.environ, "LD_PRELOAD": str(library)})
        self.assertEqual((loaded.stdout.split(), loaded.stderr), (["24000000", "25"], ""))


@unittest.skipUnless(MRPT, "MRPT's driver was not built (Debian: libmrpt-hwdrivers-dev)")
class TestMRPT(CommandLineTest):
    """MRPT's driver, as it is."""

    def check(self, rate, unit, angle, step, atol):
        image = self.folder / "direct.vti"
        low = angle / 2
        beams = angle * 100 // step + 1
        self.done("scan", ROOM, *POSE, "--alpha-range", -low, low, "--alpha-resolution", beams,
                  "--beta-resolution", TURNS, "--range-image", image)
        expected = array(read(vtkXMLImageDataReader(), image), "Range").reshape(TURNS, beams)
        with EmulatorProcess(ROOM, *POSE, "--beta-resolution", TURNS) as emulator:
            done = subprocess.run([MRPT, emulator.port, str(rate), str(int(unit == "mm")),
                                   str(angle), str(step), "6"], capture_output=True, text=True,
                                  timeout=60, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = np.array([line.replace("-", "nan").split()[1:]
                          for line in done.stdout.splitlines() if line.startswith("scan ")], float)
        # If the driver tries again, it drops the first fans. The others follow in order.
        starts = [i for i in range(TURNS) if np.allclose(found, np.roll(expected, -i, axis=0)[:6],
                                                         rtol=0, atol=atol, equal_nan=True)]
        self.assertEqual(len(starts), 1)

    def test_millimetres(self):
        for rate in (38400, 500000):
            with self.subTest(rate):
                self.check(rate, "mm", 180, 50, 0.5001e-3)

    def test_centimetres(self):
        self.check(500000, "cm", 180, 100, 5.001e-3)
        self.check(500000, "cm", 100, 50, 5.001e-3)


if __name__ == "__main__":
    unittest.main()
