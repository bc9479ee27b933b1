# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d view --server as a command: pictures and errors. Needs a display."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from lms3d.problems import Problem
from lms3d.remote import RemoteScanner
from server_process import Server
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

SIZE = (400, 160)


def run_view(*arguments):
    """The finished command."""
    return subprocess.run([sys.executable, "-m", "lms3d", "view", *arguments], capture_output=True,
                          text=True, timeout=60, check=False)


def read_picture(path):
    """Rows of colours."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, 3)


class TestCommand(unittest.TestCase):
    """The output in a shell."""

    def test_picture(self):
        with tempfile.TemporaryDirectory() as folder, Server() as server:
            picture = Path(folder) / "view.png"
            done = run_view("--server", server.corbaloc, "--screenshot", str(picture), "--size",
                            *map(str, SIZE))
            self.assertEqual(done.returncode, 0, done.stderr)
            left, right = np.split(read_picture(picture).astype(int), 2, axis=1)
            coloured = [np.ptp(half, axis=2) > 40 for half in (left, right)]
            self.assertGreater(coloured[0].mean(), 0.05)
            self.assertGreater(coloured[1].mean(), 0.3)
            green = right[coloured[1]]
            self.assertGreater(np.mean(green.argmax(axis=1) == 1), 0.9)

    def test_no_server_answers(self):
        with Server() as server:
            url = server.corbaloc
        for place, words in ((url, "no server answers there"), ("nonsense", "neither a corbaloc")):
            with self.subTest(place):
                done = run_view("--server", place)
                self.assertEqual(done.returncode, 1)
                self.assertRegex(done.stderr, rf"^lms3d: error: [^\n]*{words}[^\n]*\n$")

    def test_words_that_do_not_go_together(self):
        for arguments in ((), ("room.wrl", "--server", "x"), ("--server", "x", "--position", *"000"),
                          ("--server", "x", "--alpha-resolution", "9")):
            with self.subTest(arguments):
                self.assertEqual(run_view(*arguments).returncode, 2)

    def test_without_corba(self):
        """The module does not exist, as in a build of LMS3D without CORBA."""
        hidden = "import sys; sys.modules['lms3d.vtkLMS3DRemote'] = None; from lms3d.cli import main; " \
            "sys.exit(main(['view', '--server', 'x']))"
        done = subprocess.run([sys.executable, "-c", hidden], capture_output=True, text=True,
                              timeout=60, check=False, env=os.environ)
        self.assertEqual(done.returncode, 1)
        self.assertIn("without CORBA", done.stderr)

    def test_problem_of_a_scanner(self):
        self.assertRaises(Problem, RemoteScanner, "file:/nowhere")


if __name__ == "__main__":
    unittest.main()
