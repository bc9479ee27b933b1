#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C in each step of the command line: exit code 130, one line, and no file is left."""

import os
import select
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from command_line import COARSE, POSE, ROOM, CommandLineTest, run, write
from optional_libraries import needs

HUGE = ("--alpha-resolution", 10000, "--beta-resolution", 10000)
LARGE = ("--alpha-resolution", 2000, "--beta-resolution", 2000)

# The command line; Ctrl-C comes just after a new file was made.
CREATING = """
import builtins
import signal
import sys
from lms3d import cli

def make(path, mode="r", **options):
    file = plain_open(path, mode, **options)
    if mode == "xb":
        signal.raise_signal(signal.SIGINT)
    return file

plain_open, builtins.open = open, make
sys.exit(cli.main())
"""

# The command line, which prints "running" when its window handles events.
WINDOW = """
import sys
from lms3d import cli, viewer

def run(window):
    def show(*_):
        window.interactor.RemoveObserver(observer)
        print("running", flush=True)

    observer = window.interactor.AddObserver("TimerEvent", show)
    run_window(window)

run_window, viewer.Window.run = viewer.Window.run, run
sys.exit(cli.main())
"""

# The command line; Ctrl-C comes while its window is drawn first.
DRAWING = """
import signal
import sys
from lms3d import cli, figure

def render(self):
    observer = self.window.AddObserver("StartEvent", lambda *_: signal.raise_signal(signal.SIGINT))
    render_figure(self)
    self.window.RemoveObserver(observer)

render_figure, figure.Figure.render = figure.Figure.render, render
sys.exit(cli.main())
"""


class Process:
    """A running `lms3d ARGUMENTS`, with a terminal for its error stream."""

    def __init__(self, *arguments):
        self._terminal, slave = os.openpty()
        self._process = subprocess.Popen([sys.executable, "-m", "lms3d", *map(str, arguments)],
                                         stdout=subprocess.DEVNULL, stderr=slave)
        os.close(slave)
        self.text = ""

    def wait_for(self, words):
        """Wait until the terminal shows the words."""
        while words not in self.text and self._read():
            pass
        return words in self.text

    def _read(self):
        """Read what the terminal shows next; False at its end, or after 60 seconds."""
        if not select.select([self._terminal], [], [], 60)[0]:
            return False
        try:
            self.text += os.read(self._terminal, 65536).decode()
            return True
        except OSError:  # the process has ended
            return False

    def interrupt(self):
        """Send what Ctrl-C sends."""
        self._process.send_signal(signal.SIGINT)

    def finish(self):
        """The exit code, the text without the progress bars, and the seconds that it took."""
        start = time.monotonic()
        while self._read():
            pass
        code = self._process.wait(60)
        os.close(self._terminal)
        return code, self.text.split("\033[K")[-1], time.monotonic() - start


class TestInterrupt(CommandLineTest):
    def assert_interrupted(self, step, *arguments):
        """Interrupt a command in the step that its progress bar names."""
        before = sorted(self.folder.iterdir())
        process = Process(*arguments)
        self.assertTrue(process.wait_for(step), process.text)
        time.sleep(0.2)
        process.interrupt()
        code, text, seconds = process.finish()
        self.assertEqual(text, "lms3d: error: interrupted\r\n")
        self.assertEqual(code, 130)
        self.assertLess(seconds, 60)
        self.assertEqual(sorted(self.folder.iterdir()), before)

    def test_a_reader(self):
        uses = "".join(f"DEF A{i} Group {{ children [ {f'USE A{i - 1} ' * 10} ] }}\n"
                       for i in range(1, 9))
        path = self.folder / "laughs.wrl"
        path.write_text("#VRML V2.0 utf8\nSwitch { choice [ DEF A0 Shape { geometry Box { } }\n"
                        f"{uses} ] }}\nUSE A8\n")
        self.assert_interrupted("reading", "info", path, "--scene-nodes", 10**9)

    def test_a_scan(self):
        self.assert_interrupted("scanning", "scan", ROOM, *POSE, *HUGE,
                                "-o", self.folder / "scan.vtp")

    def test_a_map(self):
        self.assert_interrupted("mapping", "scan", ROOM, *POSE, *LARGE,
                                "--map", self.folder / "map.vtp")

    def test_a_comparison(self):
        local_map = self.folder / "map.vtp"
        self.done("scan", ROOM, *POSE, *COARSE, "--map", local_map)
        self.assert_interrupted("comparing", "compare", local_map, ROOM, "--samples", 10_000_000,
                                "-o", self.folder / "errors.vtp")

    def test_a_search(self):
        self.assert_interrupted("measuring", "advise", ROOM, *POSE, "--tolerance", 0.001)

    def test_writing(self):
        self.assert_writing_interrupted("csv", "vtp", "ptx")

    @needs("laspy", "lazrs", "pye57", "rosbags")
    def test_writing_by_libraries(self):
        self.assert_writing_interrupted("laz", "e57", "db3", "mcap")

    def assert_writing_interrupted(self, *endings):
        for ending in endings:
            with self.subTest(ending):
                self.assert_interrupted("writing", "scan", ROOM, *POSE, *LARGE,
                                        "-o", self.folder / f"scan.{ending}")

    def test_a_new_file(self):
        """The file is removed even if it has no content yet."""
        before = list(self.folder.iterdir())
        process = subprocess.run(
            [sys.executable, "-c", CREATING, *map(str, ("scan", ROOM, *POSE, *COARSE)), "-o",
             self.folder / "scan.vtp"], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual((process.returncode, process.stderr.splitlines()[-1:]),
                         (130, ["lms3d: error: interrupted"]))
        self.assertEqual(list(self.folder.iterdir()), before)

    def test_writing_to_a_pipe_that_is_not_read(self):
        path = self.folder / "scan.ply"
        os.mkfifo(path)
        reader = os.open(path, os.O_RDONLY | os.O_NONBLOCK)
        self.addCleanup(os.close, reader)
        self.assert_interrupted("writing", "scan", ROOM, *POSE, "-o", path)

    def test_a_series(self):
        path = self.folder / "path.vtp"
        self._write_trajectory(path)
        self.assert_interrupted("scanning 30", "scan", ROOM, "--trajectory", path,
                                "-o", self.folder / "scans.pvd")

    def test_one_map_of_many_poses(self):
        """While a map is joined to the others: the scans, which come before, are small."""
        path = self.folder / "path.vtp"
        self._write_trajectory(path)
        self.assert_interrupted("joining 30", "scan", ROOM, *COARSE, "--trajectory", path,
                                "--fused", self.folder / "fused.vtp")

    @staticmethod
    def _write_trajectory(path):
        places = np.zeros((1000, 3))
        places[:, 2] = np.linspace(0.5, 1.5, 1000)
        points = vtkPoints()
        points.SetData(numpy_to_vtk(places, deep=True))
        trajectory = vtkPolyData()
        trajectory.SetPoints(points)
        write(vtkXMLPolyDataWriter(), trajectory, path)

    @needs("rosbags")
    def test_a_bag_of_a_journey(self):
        path = self.folder / "journey.vtp"
        self._write_trajectory(path)
        self.assert_interrupted("scanning 30", "scan", ROOM, "--trajectory", path,
                                "-o", self.folder / "scans.mcap")

    def test_the_window(self):
        process = subprocess.Popen([sys.executable, "-c", WINDOW, "view", str(ROOM)],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertIn("running\n", iter(process.stdout.readline, ""))
        time.sleep(0.5)  # the window waits for an event
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
        self.assertEqual((process.returncode, errors), (130, "lms3d: error: interrupted\n"))

    def test_a_window_that_has_not_opened_yet(self):
        process = subprocess.run([sys.executable, "-c", DRAWING, "view", str(ROOM)],
                                 capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual((process.returncode, process.stderr), (130, "lms3d: error: interrupted\n"))

    def test_the_start(self):
        for module in ("numpy", "argparse"):  # of the package, and of its command line
            with self.subTest(module), tempfile.TemporaryDirectory() as folder:
                Path(folder, f"{module}.py").write_text(
                    "import signal\nsignal.raise_signal(signal.SIGINT)\n")
                folders = f"{folder}:{os.environ.get('PYTHONPATH', '')}"
                result = run("info", ROOM, PYTHONPATH=folders)
                self.assertEqual((result.returncode, result.stderr),
                                 (130, "lms3d: error: interrupted\n"))


if __name__ == "__main__":
    unittest.main()
