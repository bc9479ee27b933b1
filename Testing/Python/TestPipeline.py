# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The classes in Python: between VTK's own filters, and with numpy arrays."""

import os
import re
import unittest

import numpy as np
from vtkmodules.numpy_interface import dataset_adapter as dsa
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkMultiBlockDataSet, vtkPlane
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkFeatureEdges, vtkMassProperties
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource

import lms3d

ROOM = os.path.join(os.environ["LMS3D_DATA_DIR"], "room.wrl")


def room():
    """A reader of the room, before an update."""
    reader = lms3d.vtkVRMLImporterSource()
    reader.SetFileName(ROOM)
    return reader


def scan_of(source, position=(0.3, -0.2, 1.0), beams=91, turns=90):
    """A scan of the output of `source`, before an update."""
    scan = lms3d.vtkLMS3DScanFilter()
    scan.SetInputConnection(source.GetOutputPort())
    scan.SetPosition(position)
    scan.SetAlphaResolution(beams)
    scan.SetBetaResolution(turns)
    return scan


def array(data, name):
    """A point array of a data set as a numpy array."""
    return vtk_to_numpy(data.GetPointData().GetArray(name))


class Package(unittest.TestCase):
    def test_offers_every_class_and_enumeration(self):
        for name in ("vtkVRMLImporterSource", "vtkLMS3DScanFilter",
                     "vtkLMS3DSurfaceReconstructionFilter", "vtkLMS3DMapFusion",
                     "vtkLMS3DMapComparison"):
            self.assertEqual(getattr(lms3d, name)().GetClassName(), name)

    def test_every_method_has_an_enumerator_and_a_setter(self):
        scan = lms3d.vtkLMS3DScanFilter()
        self.assertEqual(scan.GetIntersectionMethod(), scan.EXACT)
        number_of_methods = scan.GetNumberOfIntersectionMethods()
        self.assertGreater(number_of_methods, 1)
        for i in range(number_of_methods):
            name = scan.GetIntersectionMethodName(i)
            with self.subTest(name):
                getattr(scan, f"SetIntersectionMethodTo{name}")()
                self.assertEqual(scan.GetIntersectionMethod(), i)
                self.assertEqual(scan.GetIntersectionMethodAsString(), name)
                enumerator = re.sub(r"(?<!^)(?=[A-Z])", "_", name).upper()
                self.assertEqual(getattr(scan, enumerator), i)
        for i in (-1, number_of_methods):
            self.assertIsNone(scan.GetIntersectionMethodName(i))

    def test_has_the_defaults_of_the_paper(self):
        scan = lms3d.vtkLMS3DScanFilter()
        self.assertEqual(scan.GetAlphaRange(), (-90.0, 90.0))
        self.assertEqual(scan.GetAlphaResolution(), 361)
        self.assertEqual(scan.GetBetaRange(), (0.0, 360.0))
        self.assertEqual(scan.GetBetaResolution(), 360)
        self.assertEqual(scan.GetMaximumRange(), 80.0)

    def test_says_what_it_is(self):
        text = str(lms3d.vtkLMS3DScanFilter())
        for name in ("Position", "Orientation", "AlphaRange", "AlphaResolution", "BetaRange",
                     "BetaResolution", "MinimumRange", "MaximumRange", "IntersectionMethod",
                     "NumberOfThreads", "SurfaceAttributes"):
            self.assertIn(name + ":", text)


class NumpyViews(unittest.TestCase):
    def test_share_memory_with_the_filter(self):
        scan = scan_of(room())
        scan.Update()
        ranges = array(scan.GetOutput(), "Range")
        self.assertEqual(ranges.dtype, np.float64)
        ranges[0] = 42.0
        self.assertEqual(scan.GetOutput().GetPointData().GetArray("Range").GetValue(0), 42.0)
        self.assertFalse(ranges.flags.owndata)

    def test_organise_the_grid_by_turn_and_beam(self):
        scan = scan_of(room(), beams=61, turns=36)
        scan.Update()
        image = array(scan.GetOutputDataObject(1), "Range").reshape(36, 61)
        beam_id = array(scan.GetOutput(), "BeamId")
        np.testing.assert_array_equal(image.ravel()[beam_id], array(scan.GetOutput(), "Range"))

    def test_points_lie_at_their_ranges(self):
        position = np.array([0.3, -0.2, 1.0])
        scan = scan_of(room(), position)
        scan.Update()
        points = dsa.WrapDataObject(scan.GetOutput()).Points
        distances = np.linalg.norm(points - position, axis=1)
        np.testing.assert_allclose(distances, array(scan.GetOutput(), "Range"), rtol=1e-14)


class Composition(unittest.TestCase):
    def test_scans_what_vtk_filters_put_out(self):
        cube = vtkCubeSource()
        cube.SetXLength(4.0)
        cube.SetYLength(4.0)
        cube.SetZLength(4.0)
        turn = vtkTransform()
        turn.RotateWXYZ(30.0, 1.0, 2.0, 3.0)
        turned = vtkTransformPolyDataFilter()
        turned.SetTransform(turn)
        turned.SetInputConnection(cube.GetOutputPort())
        scan = scan_of(turned, (0.0, 0.0, 0.0))
        scan.Update()
        ranges = array(scan.GetOutput(), "Range")
        self.assertEqual(len(ranges), 91 * 90)
        self.assertGreaterEqual(ranges.min(), 2.0 * (1 - 1e-7))
        self.assertLessEqual(ranges.max(), np.sqrt(12.0) * (1 + 1e-7))

    def test_scans_the_same_in_a_composite(self):
        reader = room()
        alone = scan_of(reader)
        alone.Update()
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, reader.GetOutput())
        together = lms3d.vtkLMS3DScanFilter()
        together.SetInputDataObject(blocks)
        together.SetPosition(0.3, -0.2, 1.0)
        together.SetAlphaResolution(91)
        together.SetBetaResolution(90)
        together.Update()
        for name in ("Range", "CellId", "BeamId"):
            np.testing.assert_array_equal(
                array(alone.GetOutput(), name), array(together.GetOutput(), name))

    def test_scans_the_surface_of_a_volume(self):
        # A threshold turns the cells into an unstructured grid.
        reader = room()
        grid = vtkThreshold()
        grid.SetInputConnection(reader.GetOutputPort())
        grid.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "ShapeId")
        grid.SetLowerThreshold(0.0)
        grid.SetUpperThreshold(0.0)
        shell = vtkGeometryFilter()
        shell.SetInputConnection(grid.GetOutputPort())
        from_grid = scan_of(grid)
        from_grid.Update()
        from_surface = scan_of(shell)
        from_surface.Update()
        np.testing.assert_array_equal(
            array(from_grid.GetOutput(), "Range"), array(from_surface.GetOutput(), "Range"))

    def test_maps_a_scan_that_another_filter_has_cut(self):
        scan = scan_of(room())
        half = vtkClipPolyData()
        half.SetInputConnection(scan.GetOutputPort())
        plane = vtkPlane()
        plane.SetOrigin(0.0, 0.0, 1.5)
        plane.SetNormal(0.0, 0.0, -1.0)
        half.SetClipFunction(plane)
        local_map = lms3d.vtkLMS3DSurfaceReconstructionFilter()
        local_map.SetInputConnection(half.GetOutputPort())
        local_map.SetMaximumError(0.0)
        local_map.Update()
        self.assertGreater(local_map.GetOutput().GetNumberOfCells(), 8000)
        self.assertLessEqual(local_map.GetOutput().GetBounds()[5], 1.5)

    def test_the_map_of_a_ball_encloses_its_volume(self):
        ball = vtkSphereSource()
        ball.SetRadius(2.0)
        ball.SetThetaResolution(256)
        ball.SetPhiResolution(256)
        scan = scan_of(ball, (0.5, 0.2, -0.3), beams=361, turns=360)
        local_map = lms3d.vtkLMS3DSurfaceReconstructionFilter()
        local_map.SetInputConnection(scan.GetOutputPort())
        edges = vtkFeatureEdges()
        edges.SetInputConnection(local_map.GetOutputPort())
        edges.FeatureEdgesOff()
        edges.NonManifoldEdgesOn()
        edges.BoundaryEdgesOn()
        volume = vtkMassProperties()
        volume.SetInputConnection(local_map.GetOutputPort())
        for bound in (0.0, 0.01):
            with self.subTest(bound):
                local_map.SetMaximumError(bound)
                edges.Update()
                self.assertEqual(edges.GetOutput().GetNumberOfCells(), 0)
                volume.Update()
                # The bound allows a shell of that thickness on a ball of 2 m.
                self.assertAlmostEqual(volume.GetVolume() / (4.0 / 3.0 * np.pi * 8.0), 1.0,
                                       delta=0.005 + 3.0 * bound / 2.0)

    def test_the_image_can_be_updated_alone(self):
        scan = scan_of(room(), beams=31, turns=36)
        scan.Update(1)
        self.assertEqual(scan.GetRangeImage().GetDimensions(), (31, 36, 1))
        self.assertEqual(scan.GetRangeImage().GetScalarTypeAsString(), "double")

    def test_follows_a_surface_that_changes(self):
        points = vtkPoints()
        ball = vtkSphereSource()
        scan = scan_of(ball, (0.0, 0.0, 0.0))
        for radius in (1.0, 2.0, 3.0):
            ball.SetRadius(radius)
            scan.Update()
            points.ShallowCopy(scan.GetOutput().GetPoints())
            self.assertAlmostEqual(array(scan.GetOutput(), "Range").max(), radius, places=6)


if __name__ == "__main__":
    unittest.main()
