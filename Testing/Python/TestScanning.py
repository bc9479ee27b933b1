#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d.scan and lms3d.reconstruct: numpy arrays in and out."""

import gc
import inspect
import unittest
import warnings

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource

import lms3d
from command_line import array, points, room, triangles
from lms3d.properties import METHODS, MOUNTINGS

POSITION = (0.3, -0.2, 1.0)
COARSE = {"alpha_resolution": 31, "beta_resolution": 24}

# A tetrahedron around the origin.
VERTICES = np.array([[3.0, 3, 3], [-3, -3, 3], [-3, 3, -3], [3, -3, -3]])
TRIANGLES = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])


def tetrahedron(**options):
    """A coarse scan inside of the tetrahedron."""
    return lms3d.scan((VERTICES, TRIANGLES), (0.1, 0.2, -0.1), **{**COARSE, **options})


def ball(radius=2.0):
    """A vtkPolyData."""
    source = vtkSphereSource()
    source.SetRadius(radius)
    source.Update()
    return source.GetOutput()


class TestScan(unittest.TestCase):
    """What a scan returns."""

    def check_equal(self, scan, other):
        """Expect equal measurements."""
        for name in ("points", "ranges", "cells", "beams", "alpha", "beta"):
            np.testing.assert_array_equal(getattr(scan, name), getattr(other, name), name)

    def test_it_has_what_the_filter_puts_out(self):
        scene = room()
        scan = lms3d.scan(scene, POSITION)
        sensor = lms3d.vtkLMS3DScanFilter()
        sensor.SetInputData(scene)
        sensor.SetPosition(POSITION)
        sensor.Update()
        np.testing.assert_array_equal(scan.points, points(sensor.GetOutput()))
        np.testing.assert_array_equal(scan.cells, array(sensor.GetOutput(), "CellId"))
        np.testing.assert_array_equal(
            scan.ranges, array(sensor.GetOutputDataObject(1), "Range").reshape(360, 361))
        self.assertEqual(repr(scan), "<lms3d.Scan: 360 x 361 beams, 129960 returns>")

    def test_the_fields_belong_together(self):
        scan = lms3d.scan(ball(), (1.5, 0.0, 0.0), maximum_range=1.0, **COARSE)
        self.assertEqual(scan.ranges.shape, (24, 31))
        self.assertEqual((scan.beta.shape, scan.alpha.shape), ((24,), (31,)))
        self.assertEqual(scan.points.shape, (len(scan.beams), 3))
        self.assertEqual(scan.cells.shape, scan.beams.shape)
        self.assertTrue(0 < len(scan.points) < scan.ranges.size)
        returned = np.flatnonzero(np.isfinite(scan.ranges))
        np.testing.assert_array_equal(scan.beams, returned)
        self.assertTrue(np.isnan(scan.ranges).any())
        np.testing.assert_allclose(np.linalg.norm(scan.points - (1.5, 0, 0), axis=1),
                                   scan.ranges.ravel()[scan.beams], rtol=1e-14)
        alpha = np.radians(scan.alpha[scan.beams % 31])
        beta = np.radians(scan.beta[scan.beams // 31])
        directions = np.stack((np.cos(alpha) * np.cos(beta), -np.cos(alpha) * np.sin(beta),
                               np.sin(alpha)), axis=1)
        np.testing.assert_allclose(
            scan.points, (1.5, 0, 0) + scan.ranges.ravel()[scan.beams, None] * directions,
            atol=1e-12)

    def test_cells_are_the_triangles(self):
        scan = tetrahedron()
        self.assertEqual(set(scan.cells), {0, 1, 2, 3})
        corners = VERTICES[TRIANGLES[scan.cells]]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        offsets = np.einsum("ij,ij->i", scan.points - corners[:, 0], normals)
        np.testing.assert_allclose(offsets, 0, atol=1e-12)

    def test_the_kinds_of_meshes_agree(self):
        class Surface(vtkPolyData):  # as PyVista's PolyData
            pass

        expected = tetrahedron()
        surface = Surface()
        surface.ShallowCopy(lms3d.mesh.to_vtk((VERTICES, TRIANGLES)))
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, surface)
        for mesh in ((VERTICES.tolist(), TRIANGLES.tolist()), [VERTICES, TRIANGLES],
                     (VERTICES.astype("f4"), TRIANGLES.astype("u1")),
                     (np.asfortranarray(VERTICES), TRIANGLES.astype(">i4")),
                     lms3d.Mesh(VERTICES, TRIANGLES), surface, blocks):
            with self.subTest(type(mesh)):
                self.check_equal(lms3d.scan(mesh, (0.1, 0.2, -0.1), **COARSE), expected)

    def test_the_arrays_stay(self):
        scan = tetrahedron()
        copies = [scan.ranges.copy(), scan.points.copy()]
        arrays = [scan.ranges, scan.points]
        del scan
        gc.collect()
        for radius in (1.0, 2.0):
            lms3d.scan(ball(radius), (0, 0, 0), **COARSE)
        for values, copy in zip(arrays, copies):
            np.testing.assert_array_equal(values, copy)

    def test_no_return(self):
        scan = lms3d.scan(ball(), (0, 0, 500), **COARSE)
        self.assertEqual(scan.points.shape, (0, 3))
        self.assertEqual((scan.cells.shape, scan.beams.shape), ((0,), (0,)))
        self.assertTrue(np.isnan(scan.ranges).all())


class TestOptions(unittest.TestCase):
    """The arguments of a scan."""

    def test_the_defaults_are_the_filters(self):
        """None stands for the value of the device, whose default is an ideal one."""
        sensor, errors = lms3d.vtkLMS3DScanFilter(), lms3d.vtkLMS3DRangeErrorFilter()
        choices = {"method": METHODS, "device": lms3d.DEVICES, "mounting": MOUNTINGS}
        names_in_vtk = {"seed": "NoiseSeed", "reflectance": "ReflectanceArray",
                        "method": "IntersectionMethod",
                        **{name: f"Compute{name.title()}" for name in
                           ("incidence", "intensity", "time", "status", "poses")}}
        for name, parameter in inspect.signature(lms3d.scan).parameters.items():
            if name in ("mesh", "position", "threads", "trajectory", "start_time"):
                continue
            with self.subTest(name):
                name_in_vtk = names_in_vtk.get(name, name.title().replace("_", ""))
                owner = sensor if hasattr(sensor, f"Get{name_in_vtk}") else errors
                default = parameter.default
                if default is None and name != "reflectance":
                    default = owner.GetDeviceValue(owner.IDEAL, name_in_vtk)
                default = choices[name][default] if name in choices else default
                self.assertEqual(default, getattr(owner, f"Get{name_in_vtk}")())
                self.assertIn(name, lms3d.scan.__doc__)

    def test_options_reach_the_sensor(self):
        options = {"orientation": (10, 20, 30), "alpha_range": (-40, 50), "alpha_resolution": 19,
                   "beta_range": (-30, 100), "beta_resolution": 14, "minimum_range": 2.5,
                   "maximum_range": 4}
        scan = lms3d.scan(room(), POSITION, **options)
        sensor = lms3d.vtkLMS3DScanFilter()
        sensor.SetInputData(room())
        sensor.SetPosition(POSITION)
        for name, value in options.items():
            getattr(sensor, "Set" + name.title().replace("_", ""))(value)
        sensor.Update()
        self.assertTrue(0 < len(scan.points) < scan.ranges.size)
        np.testing.assert_array_equal(scan.points, points(sensor.GetOutput()))
        self.assertEqual((scan.alpha[0], scan.alpha[-1], scan.beta[0], scan.beta[-1]),
                         (-40, 50, -30, 100))

    def test_surface_attributes(self):
        self.assertIsNone(tetrahedron().poly.GetPointData().GetArray("Incidence"))
        scan = tetrahedron(surface_attributes=True)
        self.assertEqual(len(array(scan.poly, "Incidence")), len(scan.points))

    def test_methods_and_threads(self):
        expected = tetrahedron().ranges
        for method in METHODS:
            with self.subTest(method):
                np.testing.assert_allclose(tetrahedron(method=method).ranges, expected, rtol=1e-6)
            self.assertIn(method, lms3d.scan.__doc__)
        np.testing.assert_array_equal(tetrahedron(threads=2).ranges, expected)
        np.testing.assert_array_equal(tetrahedron(threads=np.int32(1)).ranges, expected)

    def test_invalid_arguments(self):
        for text, options in {
            "orientation must be 3 finite numbers": {"orientation": 5},
            "alpha_range must be 2 finite numbers": {"alpha_range": (-90, float("nan"))},
            "AlphaRange is -95 to 90": {"alpha_range": (-95, 90)},
            "alpha_resolution must be a whole number from 1": {"alpha_resolution": 0},
            "alpha_resolution .* not 2.5": {"alpha_resolution": 2.5},
            "beta_resolution .* from 1 to 2147483647": {"beta_resolution": 2**31},
            "BetaRange is 0 to 361": {"beta_range": (0, 361)},
            "at most 2147483647": {"alpha_resolution": 2**20, "beta_resolution": 2**20},
            "MinimumRange": {"minimum_range": -1},
            "maximum_range must be a number": {"maximum_range": "far"},
            "method must be one of exact, fast,": {"method": "EXACT"},
            "threads must be a whole number from 0 to 1024": {"threads": 1025},
        }.items():
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                tetrahedron(**options)

    def test_invalid_positions(self):
        for position in (1.0, (1, 2), (1, 2, None), "here", (0, 0, float("inf")), (0, 0, 1e19)):
            with self.subTest(position), self.assertRaisesRegex(ValueError, "(?i)position"):
                lms3d.scan(ball(), position, **COARSE)

    def test_invalid_meshes(self):
        far, flat = TRIANGLES + 1, TRIANGLES.ravel()
        for text, mesh in {
            "mesh must be a vtkPolyData or a pair": "room.wrl",
            "not ndarray": VERTICES,
            r"vertices must be an array of N x 3 .* \(0,\)": ([], TRIANGLES),
            r"triangles must be an array of N x 3 .* \(12,\)": (VERTICES, flat),
            "vertices must be an array": (VERTICES[:, :2], TRIANGLES),
            "vertices must be numbers": (VERTICES.astype(str), TRIANGLES),
            "vertices must be finite": (VERTICES * np.nan, TRIANGLES),
            "triangles must be integers, not float64": (VERTICES, TRIANGLES * 1.0),
            "numbers of vertices, 0 to 3, not 1 to 4": (VERTICES, far),
            "numbers of vertices, 0 to 3, not -1 to 2": (VERTICES, TRIANGLES - 1),
            "(?i)vertices": ([[0, 0, 0], [1, 2]], TRIANGLES),
            "polygons": vtkPolyData(),
        }.items():
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                lms3d.scan(mesh, (0, 0, 0), **COARSE)

    def test_warnings_are_pythons(self):
        source = vtkCubeSource()
        source.Update()
        broken = vtkPolyData()
        broken.DeepCopy(source.GetOutput())
        broken.GetPoints().SetPoint(0, float("nan"), 0, 0)
        with self.assertWarnsRegex(UserWarning, "finite") as caught:
            lms3d.scan(broken, (0, 0, 0), **COARSE)
        self.assertEqual(caught.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            tetrahedron()


class TestReconstruct(unittest.TestCase):
    """Local maps."""

    def test_it_has_what_the_filter_puts_out(self):
        scan = lms3d.scan(room(), POSITION)
        local_map = lms3d.reconstruct(scan)
        mapping = lms3d.vtkLMS3DSurfaceReconstructionFilter()
        mapping.SetInputData(scan.poly)
        mapping.Update()
        np.testing.assert_array_equal(local_map.vertices, points(mapping.GetOutput()))
        np.testing.assert_array_equal(local_map.triangles, triangles(mapping.GetOutput()))
        for name, parameter in inspect.signature(lms3d.reconstruct).parameters.items():
            if parameter.default is not parameter.empty:
                getter = "Get" + name.title().replace("_", "")
                self.assertEqual(parameter.default, getattr(mapping, getter)())

    def test_a_map_is_a_mesh(self):
        grid = lms3d.reconstruct(lms3d.scan(room(), POSITION, **COARSE), maximum_error=0)
        again = lms3d.scan(grid, POSITION, **COARSE)
        self.assertGreater(np.isfinite(again.ranges).mean(), 0.9)

    def test_goes_on_behind_speckles(self):
        resolution = {"alpha_resolution": 181, "beta_resolution": 180}
        whole = len(lms3d.reconstruct(lms3d.scan(room(), POSITION, **resolution)).triangles)
        strays = lms3d.scan(room(), POSITION, **resolution)
        ranges = vtk_to_numpy(strays.poly.GetPointData().GetArray("Range"))
        ranges[::100] *= 0.5
        torn = len(lms3d.reconstruct(strays).triangles)
        kept = len(lms3d.reconstruct(strays, maximum_speckle_size=1).triangles)
        dropped = len(lms3d.reconstruct(strays, maximum_speckle_size=1,
                                        keep_speckles=False).triangles)
        self.assertLess(whole, dropped)
        self.assertLess(dropped, kept)
        self.assertLess(2 * kept, torn)

    def test_without_returns_it_is_empty_or_an_error(self):
        scan = lms3d.scan(ball(), (0, 0, 500), **COARSE)
        self.assertEqual(lms3d.reconstruct(scan).triangles.shape, (0, 3))

    def test_invalid_arguments(self):
        scan = tetrahedron()
        for name, value in (("maximum_error", -1), ("maximum_error", np.nan), ("depth_step", "x"),
                            ("maximum_gap_size", -2), ("maximum_gap_size", 0.5),
                            ("maximum_speckle_size", 1000001)):
            with self.subTest(name, value=value), self.assertRaisesRegex(ValueError, name):
                lms3d.reconstruct(scan, **{name: value})


if __name__ == "__main__":
    unittest.main()
