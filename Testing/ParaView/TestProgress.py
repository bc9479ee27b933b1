# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Progress and abort of reading, scanning and mapping in ParaView.

Run by pvpython. LMS3D_PLUGIN is the plugin's file, LMS3D_DATA_DIR the folder of room.wrl.
"""

import os
import sys
import tempfile
import time
import unittest
from pathlib import Path

from paraview import simple
from proxies import algorithm

ROOM = str(Path(os.environ["LMS3D_DATA_DIR"]) / "room.wrl")
SIDE = 400
# Seconds. ParaView reports the progress of a step at most once in this time.
INTERVAL = 0.01

simple.LoadPlugin(os.environ["LMS3D_PLUGIN"], remote=False, ns=globals())


def write_field(path):
    """A scene of 2 * SIDE * SIDE triangles, which takes long enough to be interrupted."""
    numbers = range(SIDE + 1)
    points = " ".join(f"{x} {y} 0," for y in numbers for x in numbers)
    corners = ((y * (SIDE + 1) + x, y * (SIDE + 1) + x + 1, (y + 1) * (SIDE + 1) + x + 1,
                (y + 1) * (SIDE + 1) + x) for y in numbers[:-1] for x in numbers[:-1])
    faces = " ".join("{}, {}, {}, {}, -1,".format(*corner) for corner in corners)
    path.write_text("#VRML V2.0 utf8\nShape { geometry IndexedFaceSet { coord Coordinate { point ["
                    f"{points}] }} coordIndex [{faces}] }} }}\n")


def slow_down(proxy):
    """Make each report of the step outlast ParaView's interval, however fast the machine is."""
    filter_ = algorithm(proxy)
    tag = filter_.AddObserver("ProgressEvent", lambda caller, event: time.sleep(2 * INTERVAL))
    return lambda: filter_.RemoveObserver(tag)


def count(proxy):
    """The points of the first output."""
    return algorithm(proxy).GetOutputDataObject(0).GetNumberOfPoints()


class TestProgress(unittest.TestCase):
    """Each step of the pipeline, which takes long enough to be interrupted."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.field = Path(folder.name) / "field.wrl"
        write_field(cls.field)

    def setUp(self):
        simple.ResetSession()
        self.scene = VRMLReader(FileName=str(self.field))
        self.scan = LMS3DScan(Input=VRMLReader(FileName=ROOM), Position=[0.3, -0.2, 1.0],
                              AlphaResolution=1000, BetaResolution=1000)
        self.map = LMS3DSurfaceReconstruction(Input=self.scan)

    def steps(self):
        """The steps of the pipeline; the inputs of each step are up to date."""
        self.scan.Input.UpdatePipeline()
        yield self.scene
        yield self.scan
        self.scan.UpdatePipeline()
        yield self.map

    def test_progress_bar_moves_and_names_the_step(self):
        handler = simple.servermanager.ActiveConnection.Session.GetProgressHandler()
        handler.SetProgressInterval(INTERVAL)
        reports = []
        handler.AddObserver("ProgressEvent", lambda caller, event: reports.append(
            (caller.GetLastProgressText(), caller.GetLastProgress())))
        for step in self.steps():
            reports.clear()
            name = algorithm(step).GetClassName()
            with self.subTest(name):
                restore_speed = slow_down(step)
                step.UpdatePipeline()
                restore_speed()
                percents = [percent for text, percent in reports if text == name]
                self.assertEqual(percents, sorted(percents))
                self.assertTrue(any(0 < percent < 100 for percent in percents), reports)

    def test_abort_empties_the_output_and_the_next_run_is_complete(self):
        for step in self.steps():
            filter_ = algorithm(step)
            with self.subTest(filter_.GetClassName()):
                self.run_aborted(step)
                self.assertEqual((count(step), filter_.GetErrorCode()), (0, 0))
                filter_.SetAbortExecute(0)
                filter_.Update()
                self.assertGreater(count(step), 100)

    def run_aborted(self, step):
        """Abort during the work, as the button of later versions of ParaView does."""
        filter_ = algorithm(step)

        def stop(caller, event):
            if 0.0 < caller.GetProgress() < 1.0:
                caller.SetAbortExecuteAndUpdateTime()

        tag = filter_.AddObserver("ProgressEvent", stop)
        step.UpdatePipeline()
        filter_.RemoveObserver(tag)
        self.assertTrue(filter_.GetAbortExecute())


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
