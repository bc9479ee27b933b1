# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""LMS3D Map Fusion in pvpython: the map grows while a trajectory plays.

Run by pvpython. LMS3D_PLUGIN is the plugin's file, LMS3D_DATA_DIR the folder of room.wrl.
"""

import os
import sys
import unittest
from pathlib import Path

import lms3d  # noqa: F401 wraps the filter behind the proxy
import numpy as np
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from proxies import algorithm
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance

DATA = Path(os.environ["LMS3D_DATA_DIR"])
POSES = 17
BOUND = 0.02

simple.LoadPlugin(os.environ["LMS3D_PLUGIN"], remote=False, ns=globals())


class TestFusion(unittest.TestCase):
    """The journey through the room."""

    def setUp(self):
        room = VRMLReader(FileName=str(DATA / "room.wrl"))
        journey = simple.OpenDataFile(str(DATA / "journey.vtp"))
        self.scan = LMS3DScan(Input=room, Trajectory=journey, AlphaResolution=91, BetaResolution=90)
        self.map = LMS3DSurfaceReconstruction(Input=self.scan, MaximumError=BOUND)
        self.fusion = LMS3DMapFusion(Map=self.map, Scan=self.scan, MaximumError=BOUND)

    def output(self, time=None):
        """The map after an update."""
        self.fusion.UpdatePipeline(time)
        return algorithm(self.fusion).GetOutputDataObject(0)

    def scans(self, time):
        """The number of scans in the map after an update for a time."""
        return self.output(time).GetFieldData().GetArray("NumberOfScans").GetValue(0)

    def test_each_time_adds_its_pose_once(self):
        for time, expected in ((0, 1), (1, 2), (0, 2), (1, 2), (7, 3)):
            with self.subTest(time=time, expected=expected):
                self.assertEqual(self.scans(time), expected)

    def test_play_makes_the_map_grow(self):
        view = simple.GetActiveViewOrCreate("RenderView")
        self.addCleanup(simple.Delete, view)
        simple.Show(self.fusion, view)
        self.scan.UpdatePipelineInformation()
        scene = simple.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        sizes = []
        algorithm(self.fusion).AddObserver("EndEvent", lambda caller, event: sizes.append(
            caller.GetOutput().GetNumberOfCells()))
        scene.Play()
        self.assertEqual(algorithm(self.fusion).GetNumberOfScans(), POSES)
        self.assertGreaterEqual(len(sizes), POSES - 1)
        self.assertGreater(sizes[-1], sizes[0])

    def test_every_return_of_every_pose_is_near_the_map(self):
        places = []
        for time in range(POSES):
            self.output(time)
            scan = algorithm(self.scan).GetOutputDataObject(0)
            places.append(vtk_to_numpy(scan.GetPoints().GetData())[::7].copy())
        distance = vtkImplicitPolyDataDistance()
        distance.SetInput(algorithm(self.fusion).GetOutputDataObject(0))
        farthest = max(abs(distance.EvaluateFunction(place)) for place in np.vstack(places))
        self.assertLessEqual(farthest, BOUND + 1e-6)

    def test_a_change_upstream_begins_a_new_map(self):
        for time in range(3):
            self.output(time)
        self.scan.BetaResolution = 45
        self.assertEqual(self.scans(4), 1)
        self.fusion.MaximumError = 2 * BOUND
        self.assertEqual(self.scans(5), 1)

    def test_maps_of_several_sensors_become_one(self):
        """In the order of the connections; a connection that is taken out leaves the map."""
        scans = [LMS3DScan(Input=self.scan.Input, Position=(x, -0.2, 1.0), AlphaResolution=91,
                           BetaResolution=90) for x in (-1.0, 0.0, 1.0)]
        maps = [LMS3DSurfaceReconstruction(Input=scan, MaximumError=BOUND) for scan in scans]
        self.fusion.Map, self.fusion.Scan = maps, scans
        self.assertEqual(self.scans(None), 3)
        places = self.output().GetFieldData().GetArray("SensorPositions")
        self.assertEqual([places.GetTuple3(i)[0] for i in range(3)], [-1.0, 0.0, 1.0])
        self.fusion.Map, self.fusion.Scan = maps[:2], scans[:2]
        self.assertEqual(self.scans(None), 2)

    def test_arrays_to_colour_by(self):
        view = simple.GetActiveViewOrCreate("RenderView")
        self.addCleanup(simple.Delete, view)
        display = simple.Show(self.fusion, view)
        listed = display.SMProxy.GetProperty("ColorArrayName").FindDomain("vtkSMArrayListDomain")
        names = {listed.GetString(i) for i in range(listed.GetNumberOfStrings())}
        self.assertLessEqual({"BestScan", "ScanCount", "LastScan"}, names)

    def test_a_map_beyond_the_bound_is_an_error(self):
        said = []

        def listen(caller, event, words):
            said.append(words)

        listen.CallDataType = "string0"
        self.fusion.MaximumError = BOUND / 2
        filter_ = algorithm(self.fusion)
        filter_.AddObserver("ErrorEvent", listen)
        filter_.GetExecutive().AddObserver("ErrorEvent", lambda caller, event: None)
        self.assertEqual(self.output(0).GetNumberOfCells(), 0)
        self.assertNotEqual(filter_.GetErrorCode(), 0)
        self.assertEqual(len(said), 1, said)
        self.assertIn("MaximumError", said[0])


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
