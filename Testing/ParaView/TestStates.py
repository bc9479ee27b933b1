# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""States and traces in pvpython: a restored pipeline gives the same numbers.

pvpython runs it. LMS3D_PLUGIN is the plugin's file, LMS3D_DATA_DIR the folder of room.wrl and, for
TestWindow, LMS3D_STATES the folder of the states that the tests in ParaView's window have saved.
"""

import os
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from paraview import simple, smtrace
from paraview.vtk.util.numpy_support import vtk_to_numpy

DATA = Path(os.environ["LMS3D_DATA_DIR"])
SENSOR = [0.3, -0.2, 1.0]
TILT = [5.0, -3.0, 40.0]
CENTRE = [1.475, 0.07, 1.5]  # of the room, where DragSensor.xml puts the sensor

simple.LoadPlugin(os.environ["LMS3D_PLUGIN"], remote=False, ns=globals())


def make_pipeline():
    """Reader, scan and map, with properties that are not their defaults."""
    room = VRMLReader(registrationName="room", FileName=str(DATA / "room.wrl"))
    scan = LMS3DScan(registrationName="scan", Input=room, Position=SENSOR, Orientation=TILT,
                     AlphaResolution=181, BetaResolution=90, MaximumRange=5.0)
    return LMS3DSurfaceReconstruction(registrationName="map", Input=scan, MaximumError=0.02)


def points(proxy, time=None):
    """The points of a proxy's filter at a time of a trajectory."""
    proxy.UpdatePipeline(time)
    data = proxy.SMProxy.GetClientSideObject().GetOutputDataObject(0)
    return vtk_to_numpy(data.GetPoints().GetData())


def source(kind):
    """The one source of this kind in the pipeline."""
    (found,) = (proxy for proxy in simple.GetSources().values() if proxy.GetXMLName() == kind)
    return found


class TestRoundTrips(unittest.TestCase):
    """A pipeline saved and restored is the same pipeline."""

    def setUp(self):
        simple.ResetSession()
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def check_restored(self, expected):
        scan = source("LMS3DScan")
        self.assertEqual(list(scan.Position), SENSOR)
        self.assertEqual(list(scan.Orientation), TILT)
        self.assertEqual((scan.AlphaResolution, scan.BetaResolution), (181, 90))
        self.assertEqual(scan.MaximumRange, 5.0)
        local_map = source("LMS3DSurfaceReconstruction")
        self.assertEqual(local_map.MaximumError, 0.02)
        np.testing.assert_array_equal(points(local_map), expected)

    def check_file(self, name):
        expected = points(make_pipeline()).copy()
        file = str(Path(self.folder.name) / name)
        simple.SaveState(file)
        simple.ResetSession()
        self.assertFalse(simple.GetSources())
        simple.LoadState(file)
        self.check_restored(expected)

    def test_state(self):
        self.check_file("state.pvsm")

    def test_python_state(self):
        self.check_file("state.py")

    def test_trace(self):
        smtrace.start_trace()
        expected = points(make_pipeline()).copy()
        trace = smtrace.stop_trace()
        for name in ("VRMLReader(", "LMS3DScan(", "LMS3DSurfaceReconstruction("):
            self.assertIn(name, trace)
        simple.ResetSession()
        exec(compile(trace, "trace", "exec"), {"__name__": "trace"})
        self.check_restored(expected)


class TestWindow(unittest.TestCase):
    """The states that the tests in ParaView's window saved."""

    def load(self, name):
        simple.ResetSession()
        simple.LoadState(str(Path(os.environ["LMS3D_STATES"]) / name))

    def test_sensor_was_dragged(self):
        for name in ("MovePose.pvsm", "Server/MovePose.pvsm"):
            with self.subTest(name):
                self.load(name)
                scan = source("LMS3DScan")
                self.check_dragged(scan)
                self.check_map_of_pose(scan)

    def test_scan_followed_while_the_mouse_was_down(self):
        for name in ("MovePoseMouseDown.pvsm", "Server/MovePoseMouseDown.pvsm"):
            with self.subTest(name):
                self.load(name)
                self.check_dragged(source("LMS3DScan"))

    def check_dragged(self, scan):
        """The sensor is at another place, at the same height, and not turned."""
        x, y, z = scan.Position
        self.assertGreater(x, 1.475 + 0.5)
        self.assertGreater(y, 0.07 + 0.2)
        self.assertAlmostEqual(z, 1.0, places=9)
        np.testing.assert_allclose(list(scan.Orientation), 0, atol=1e-9)

    def check_map_of_pose(self, scan):
        """The map is the one of a new scan from the same pose."""
        seen = points(source("LMS3DSurfaceReconstruction")).copy()
        afresh = LMS3DScan(Input=VRMLReader(FileName=str(DATA / "room.wrl")),
                           Position=list(scan.Position))
        np.testing.assert_array_equal(points(LMS3DSurfaceReconstruction(Input=afresh)), seen)

    def pose(self, name):
        """Position and orientation of the sensor in a state."""
        self.load(name)
        scan = source("LMS3DScan")
        return np.array(list(scan.Position)), np.array(list(scan.Orientation))

    def test_left_button_turned_the_sensor_about_the_vertical_axis(self):
        position, angles = self.pose("DragTurned.pvsm")
        np.testing.assert_allclose(position, CENTRE, rtol=0, atol=1e-9)
        np.testing.assert_allclose(angles[:2], 0, rtol=0, atol=1e-6)
        self.assertGreater(angles[2], 5)

    def test_ctrl_moved_the_sensor_at_its_height(self):
        (_, turned), (position, angles) = self.pose("DragTurned.pvsm"), self.pose("DragMoved.pvsm")
        np.testing.assert_allclose(angles, turned, rtol=0, atol=1e-6)
        self.assertAlmostEqual(position[2], CENTRE[2], places=9)
        self.assertGreater(np.linalg.norm(position - CENTRE), 0.2)

    def test_shift_moved_the_sensor_out_of_its_plane(self):
        position, angles = self.pose("DragFree.pvsm")
        np.testing.assert_allclose(angles, 0, rtol=0, atol=1e-6)
        self.assertGreater(abs(position[2] - CENTRE[2]), 0.1)

    def test_map_came_back_with_its_colours(self):
        self.load("TwoSensors.pvsm")
        surface = source("LMS3DSurfaceReconstruction")
        display = simple.GetRepresentation(surface, simple.GetViews()[0])
        self.assertEqual(list(display.ColorArrayName), ["POINTS", "Range"])

    def test_journey_was_played(self):
        self.load("Journey.pvsm")
        scan = source("LMS3DScan")
        self.assertEqual(list(scan.TimestepValues), list(range(17)))
        self.assertEqual(simple.GetAnimationScene().AnimationTime, 13)
        doorway, ahead = [4.0, 0.75, 1.0], [1, 0, 0]
        pose = self.pose_at(scan, 13)
        np.testing.assert_allclose(pose[:3, 3], doorway, rtol=0, atol=1e-12)
        np.testing.assert_allclose(pose[:3, 0], ahead, rtol=0, atol=1e-12)
        travelled = np.copy(points(source("LMS3DSurfaceReconstruction"), 13))
        stood = LMS3DScan(Input=VRMLReader(FileName=str(DATA / "room.wrl")), Position=doorway)
        np.testing.assert_array_equal(
            points(LMS3DSurfaceReconstruction(Input=stood)), travelled)

    def pose_at(self, scan, time):
        """The pose of the sensor at a time, as a matrix."""
        scan.UpdatePipeline(time)
        data = scan.SMProxy.GetClientSideObject().GetOutputDataObject(0)
        return vtk_to_numpy(data.GetFieldData().GetArray("SensorToWorld")).reshape(4, 4)

    def test_example_was_loaded(self):
        self.load("LoadState.pvsm")
        scan = source("LMS3DScan")
        self.assertEqual(list(scan.Position), SENSOR)
        self.assertEqual(Path(source("vrmlreader").FileName), DATA / "room.wrl")
        self.assertEqual(len(points(scan)), 361 * 360)
        self.check_map_of_pose(scan)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
