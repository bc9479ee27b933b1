# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in pvpython: a correct scan of the room, and errors.

LMS3D_PLUGIN is the plugin's file, LMS3D_DATA_DIR the folder of room.wrl.
"""

import gzip
import os
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from proxies import algorithm
from vtkmodules.vtkCommonTransforms import vtkTransform

ROOM = str(Path(os.environ["LMS3D_DATA_DIR"]) / "room.wrl")
SENSOR = [0.3, -0.2, 1.0]
BEAMS, TURNS = 361, 360

simple.LoadPlugin(os.environ["LMS3D_PLUGIN"], remote=False, ns=globals())


def output(proxy, port=0):
    """The data that a proxy's filter made."""
    proxy.UpdatePipeline()
    return algorithm(proxy).GetOutputDataObject(port)


def points(data):
    """The points as an array, one a row."""
    return vtk_to_numpy(data.GetPoints().GetData())


def array(data, name):
    """One array of the point data."""
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def scan_room(**properties):
    """A scan of the room from the place of the paper's Figure 5."""
    return LMS3DScan(Input=VRMLReader(FileName=ROOM), Position=SENSOR, **properties)


class TestOpening(unittest.TestCase):
    """ParaView uses our reader for all VRML files."""

    def test_endings(self):
        text = Path(ROOM).read_bytes()
        with tempfile.TemporaryDirectory() as folder:
            for name, content in {"room.wrl": text, "room.vrml": text,
                                  "room.wrz": gzip.compress(text)}.items():
                with self.subTest(name):
                    file = Path(folder) / name
                    file.write_bytes(content)
                    reader = simple.OpenDataFile(str(file))
                    self.assertEqual(algorithm(reader).GetClassName(), "vtkVRMLImporterSource")
                    self.assertEqual(output(reader).GetNumberOfPolys(), 804)


class TestRoom(unittest.TestCase):
    """The room through the whole pipeline."""

    @classmethod
    def setUpClass(cls):
        cls.reader = VRMLReader(FileName=ROOM)
        cls.scan = LMS3DScan(Input=cls.reader, Position=SENSOR)
        cls.map = LMS3DSurfaceReconstruction(Input=cls.scan, MaximumError=0.0)

    def test_reader_keeps_places_and_triangles(self):
        room = output(self.reader)
        self.assertEqual(room.GetNumberOfPolys(), 804)
        np.testing.assert_allclose(
            room.GetBounds(), [-4, 6.95, -3, 3.14, 0, 3], rtol=0, atol=1e-6)

    def test_every_beam_returns_from_the_pose(self):
        scan = output(self.scan)
        self.assertEqual(scan.GetNumberOfPoints(), BEAMS * TURNS)
        self.assertEqual(scan.GetNumberOfVerts(), BEAMS * TURNS)
        a, b = (np.radians(array(scan, name), dtype=float) for name in ("Alpha", "Beta"))
        directions = np.transpose([np.cos(a) * np.cos(b), -np.cos(a) * np.sin(b), np.sin(a)])
        expected = SENSOR + array(scan, "Range")[:, None] * directions
        np.testing.assert_allclose(points(scan), expected, rtol=0, atol=1e-5)
        down = array(scan, "Alpha") == -90
        np.testing.assert_allclose(array(scan, "Range")[down], SENSOR[2], rtol=0, atol=1e-9)

    def test_second_output_is_the_range_image(self):
        scan = output(self.scan)
        image = algorithm(self.scan).GetOutputDataObject(1)
        self.assertEqual(image.GetClassName(), "vtkImageData")
        self.assertEqual(image.GetDimensions(), (BEAMS, TURNS, 1))
        ranges = array(image, "Range")
        np.testing.assert_array_equal(ranges[array(scan, "BeamId")], array(scan, "Range"))

    def test_outputs_have_names(self):
        self.assertEqual(
            [self.scan.SMProxy.GetOutputPortName(i) for i in (0, 1)], ["Scan", "Range Image"])

    def test_map_faces_the_sensor(self):
        surface = output(self.map)
        directions = (BEAMS - 2) * TURNS + 2
        most = 2 * TURNS * (BEAMS - 2)
        self.assertEqual(surface.GetNumberOfPoints(), directions)
        self.assertEqual(surface.GetNumberOfCells(), surface.GetNumberOfPolys())
        self.assertLessEqual(surface.GetNumberOfPolys(), most)
        self.assertGreater(surface.GetNumberOfPolys(), 0.95 * most)
        corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        p, q, r = np.moveaxis(points(surface)[corners], 1, 0)
        facing = np.einsum("ij,ij->i", np.cross(q - p, r - p), SENSOR - p)
        self.assertTrue(np.all(facing > 0))

    def test_map_within_a_bound_has_patches(self):
        surface = output(LMS3DSurfaceReconstruction(Input=self.scan))
        self.assertLess(surface.GetNumberOfPolys(), 3000)
        results = surface.GetFieldData()
        self.assertLessEqual(results.GetArray("LargestDeviation").GetValue(0), 0.01)
        patches = vtk_to_numpy(surface.GetCellData().GetArray("PatchId"))
        self.assertEqual(patches.max() + 1, results.GetArray("NumberOfPatches").GetValue(0))

    def test_range_errors_change_scan_image_and_map(self):
        errors = LMS3DRangeError(Input=self.scan, RangeBias=0.25, NoiseSeed=3)
        scan, ideal = output(errors), output(self.scan)
        image = algorithm(errors).GetOutputDataObject(1)
        np.testing.assert_array_equal(array(scan, "Range"), array(ideal, "Range") + 0.25)
        np.testing.assert_array_equal(
            array(image, "Range")[array(scan, "BeamId")], array(scan, "Range"))
        errors.RangeNoise = 0.005
        noise = array(output(errors), "Range") - array(ideal, "Range") - 0.25
        self.assertAlmostEqual(noise.std(), 0.005, delta=4e-5)
        self.assertGreater(output(LMS3DSurfaceReconstruction(Input=errors)).GetNumberOfPolys(), 0)
        self.assertEqual(
            [errors.SMProxy.GetOutputPortName(i) for i in (0, 1)], ["Scan", "Range Image"])

    def test_field_arrays_are_no_choice_for_colouring(self):
        comparison = LMS3DMapComparison(Map=self.map, Scene=self.reader)
        bounded = LMS3DSurfaceReconstruction(Input=self.scan)
        for proxy, wanted in ((self.scan, "Range"), (bounded, "PatchId"), (comparison, "Error")):
            with self.subTest(proxy.GetXMLName()):
                display = simple.Show(proxy)
                listed = display.SMProxy.GetProperty("ColorArrayName").FindDomain(
                    "vtkSMArrayListDomain")
                names = {listed.GetString(i) for i in range(listed.GetNumberOfStrings())}
                self.assertIn(wanted, names)
                fields = output(proxy).GetFieldData()
                self.assertGreater(fields.GetNumberOfArrays(), 2)
                hidden = {fields.GetArrayName(i) for i in range(fields.GetNumberOfArrays())}
                self.assertEqual(names & hidden, set())

    def test_map_is_compared_with_the_scene(self):
        for scan in ({}, {"Scan": self.scan}):
            comparison = LMS3DMapComparison(Map=self.map, Scene=self.reader, **scan)
            results = output(comparison).GetFieldData()
            for name in ("Correctness", "Completeness"):
                self.assertGreater(results.GetArray(name).GetValue(0), 0.9)
            self.assertEqual(results.HasArray("LargestReturnDistance"), bool(scan))
            self.assertEqual(array(output(comparison), "Error").size,
                             output(self.map).GetNumberOfPoints())
            seen = algorithm(comparison).GetOutputDataObject(1)
            self.assertGreater(seen.GetNumberOfPoints(), 100000)


class TestPose(unittest.TestCase):
    """The box in the view turns as the filter does: about z, then x, then y."""

    def test_box_and_filter_agree(self):
        angles = [20.0, -35.0, 130.0]
        manager = simple.servermanager.ProxyManager().SMProxyManager
        box = manager.NewProxy("3d_widget_representations", "BoxRepresentation")
        for name, values in {"Position": SENSOR, "Rotation": angles}.items():
            for i, value in enumerate(values):
                box.GetProperty(name).SetElement(i, value)
        box.UpdateVTKObjects()
        drawn = vtkTransform()
        box.GetClientSideObject().GetTransform(drawn)
        matrix = [drawn.GetMatrix().GetElement(i, j) for i in range(4) for j in range(4)]
        scan = output(scan_room(Orientation=angles, AlphaResolution=3, BetaResolution=4))
        pose = vtk_to_numpy(scan.GetFieldData().GetArray("SensorToWorld")).ravel()
        np.testing.assert_allclose(matrix, pose, rtol=0, atol=1e-12)


class TestErrors(unittest.TestCase):
    """Bad properties give an error that names them, and nothing else."""

    def error_of(self, proxy):
        """What the filter says at an update; its output has to be empty."""
        said = []

        def listen(caller, event, words):
            said.append(words)

        listen.CallDataType = "string0"
        filter_ = algorithm(proxy)
        filter_.AddObserver("ErrorEvent", listen)
        filter_.GetExecutive().AddObserver("ErrorEvent", lambda caller, event: None)
        proxy.UpdatePipeline()
        self.assertNotEqual(filter_.GetErrorCode(), 0)
        self.assertEqual(filter_.GetOutputDataObject(0).GetNumberOfPoints(), 0)
        return "".join(said)

    def test_bad_scan(self):
        for name, value in {
            "AlphaRange": [30, 20],
            "AlphaResolution": 0,
            "BetaRange": [0, 400],
            "MaximumRange": 0,
            "Position": [float("nan"), 0, 0],
        }.items():
            with self.subTest(name):
                proxy = scan_room()
                proxy.SetPropertyWithName(name, value)
                self.assertIn(name, self.error_of(proxy))

    def test_file_that_is_not_there(self):
        self.assertIn("no-such.wrl", self.error_of(VRMLReader(FileName="no-such.wrl")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
