#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A sensor that moves, in Python: the trajectory of lms3d.scan, and lms3d.undistort."""

import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import lms3d
from command_line import COARSE as COARSE_OPTIONS
from command_line import (
    POSITION,
    ROOM,
    CommandLineTest,
    array,
    points,
    read,
    room,
    triangles,
    write,
)
from lms3d.properties import MOUNTINGS

COARSE = {"alpha_range": (-60, 60), "alpha_resolution": 241, "beta_resolution": 36}
QUARTER = np.sqrt(0.5)

# Where beams point: mounting, alpha, platform angle, direction (vtkLMS3DScanFilter.h).
BEAMS = (
    ("yawing", 0, 0, (1, 0, 0)), ("yawing", 90, 0, (0, 0, 1)), ("yawing", 0, 90, (0, -1, 0)),
    ("yawing-top", 0, 0, (0, 0, 1)), ("yawing-top", 90, 0, (1, 0, 0)),
    ("yawing-top", 90, 90, (0, -1, 0)),
    ("pitching", 0, 0, (1, 0, 0)), ("pitching", 90, 0, (0, 1, 0)), ("pitching", 0, 90, (0, 0, 1)),
    ("rolling", 0, 0, (1, 0, 0)), ("rolling", 90, 0, (0, 1, 0)), ("rolling", 90, 90, (0, 0, -1)),
)


def make_scan(alpha, beta, ranges, arrays=None, fields=None):
    """A scan as vtkPolyData whose beams all return; `arrays` are its further point arrays."""
    poly = vtkPolyData()
    poly.SetPoints(vtkPoints())
    beams = np.arange(len(alpha) * len(beta), dtype=np.int32)
    values = {"Range": np.asarray(ranges, float), "BeamId": beams, **(arrays or {})}
    more = {"AlphaAngles": np.asarray(alpha, float), "BetaAngles": np.asarray(beta, float),
            "SensorToWorld": np.eye(4).ravel(), **(fields or {})}
    for data, named in ((poly.GetPointData(), values), (poly.GetFieldData(), more)):
        for name, content in named.items():
            added = numpy_to_vtk(np.ascontiguousarray(content), deep=True)
            added.SetName(name)
            data.AddArray(added)
    return poly


def pose(position, degrees, axis):
    """A transform, and its quaternion."""
    transform = vtkTransform()
    transform.Translate(position)
    transform.RotateWXYZ(degrees, axis)
    wxyz = [0.0] * 4
    transform.GetOrientationWXYZ(wxyz)
    half = np.radians(wxyz[0]) / 2
    return transform, [np.cos(half), *(np.sin(half) * np.array(wxyz[1:]))]


class TestUndistort(unittest.TestCase):
    """The geometry of lms3d.undistort."""

    def test_beams_point_where_the_mountings_say(self):
        for mounting, alpha, beta, direction in BEAMS:
            with self.subTest(mounting, alpha=alpha, beta=beta):
                scan = make_scan([alpha], [beta], [2.0],
                                 fields={"Mounting": np.array([MOUNTINGS[mounting]], np.int32)})
                np.testing.assert_allclose(
                    lms3d.undistort(scan), 2 * np.array([direction]), atol=1e-15)

    def test_a_sensor_at_rest_keeps_its_points(self):
        for more in ({}, {"range_noise": 0.01}, {"orientation": (10, 20, 30)}):
            scan = lms3d.scan(room(), POSITION, **COARSE, **more)
            np.testing.assert_allclose(lms3d.undistort(scan), scan.points, rtol=0, atol=1e-12)

    def test_the_mirror_turns_with_the_platform(self):
        scan = make_scan([0], [0, 90], [1.0, 1.0], fields={"AxisOffset": np.array([0.5, 0.2, 0.1])})
        np.testing.assert_allclose(
            lms3d.undistort(scan), [[1.5, 0.2, 0.1], [0.2, -1.5, 0.1]], atol=1e-15)

    def test_the_offset_is_along_the_axes_of_the_sensor(self):
        for mounting in MOUNTINGS:
            fields = {"Mounting": np.array([MOUNTINGS[mounting]], np.int32),
                      "AxisOffset": np.array([0.5, 0.2, 0.1])}
            scan = make_scan([90], [0], [0.0], fields=fields)
            np.testing.assert_allclose(lms3d.undistort(scan), [[0.5, 0.2, 0.1]], atol=1e-15)

    def test_the_platform_turns_during_a_fan(self):
        """Half degrees leave 1/75 s after the whole ones: 1 degree later at 75 degrees a second."""
        alpha = np.arange(-2, 2.5, 0.5)
        scan = make_scan(alpha, [10], np.ones(len(alpha)), fields={"TurnRate": np.array([75.0])})
        x, y, _ = lms3d.undistort(scan).T
        angles = np.degrees(np.arctan2(-y, x))
        times = (np.arange(9) % 2) / 75 + (np.arange(9) // 2) / (360 * 75)
        np.testing.assert_allclose(angles, 10 + 75 * times, atol=1e-12)

    def test_poses_of_beams(self):
        poses = [pose((1, 2, 3), 30, (0, 0, 1)), pose((4, 5, 6), 130, (1, 2, -1))]
        arrays = {"SensorPosition": np.array([made.GetPosition() for made, _ in poses]),
                  "SensorOrientation": 3 * np.array([quaternion for _, quaternion in poses])}
        scan = make_scan([0], [0, 90], [2.0, 2.0], arrays,
                         {"TurnToWorld": np.tile(np.eye(4).ravel(), (2, 1))})
        expected = [made.TransformPoint(place)
                    for (made, _), place in zip(poses, ((2, 0, 0), (0, -2, 0)))]
        np.testing.assert_allclose(lms3d.undistort(scan), expected, atol=1e-14)

    def test_a_scan_without_the_poses(self):
        scan = make_scan([0], [0], [2.0], fields={"TurnToWorld": np.eye(4).reshape(1, 16)})
        with self.assertRaisesRegex(ValueError, "poses=True"):
            lms3d.undistort(scan)
        with self.assertRaisesRegex(ValueError, "does not have the field data AlphaAngles"):
            lms3d.undistort(vtkPolyData())


class TestTrajectory(unittest.TestCase):
    """The trajectory of lms3d.scan."""

    times = (0.0, 2.0, 10.0)
    positions = ((0.3, -0.2, 1.0), (0.5, -0.2, 1.0), (1.3, 0.4, 1.1))
    orientations = ((1, 0, 0, 0), (QUARTER, 0, 0, QUARTER), (1, 0, 0, 0))

    def scan(self, *arrays, **more):
        return lms3d.scan(room(), trajectory=(self.times, self.positions, *arrays), **COARSE, **more)

    def test_the_start_chooses_the_pose(self):
        for start, index in ((None, 0), (-1, 0), (2.0, 1), (9.9, 1), (11, 2)):
            with self.subTest(start):
                moved = self.scan(start_time=start)
                stood = lms3d.scan(room(), self.positions[index], **COARSE)
                np.testing.assert_array_equal(moved.points, stood.points)

    def test_noise_is_that_of_the_time(self):
        noise = {"range_noise": 0.01, "seed": 3}
        first, second = (
            self.scan(start_time=start, **noise).ranges - self.scan(start_time=start).ranges
            for start in (0.0, 2.0))
        self.assertGreater((first != second).mean(), 0.99)

    def test_orientations(self):
        moved = self.scan(self.orientations, start_time=2.0)
        stood = lms3d.scan(room(), self.positions[1], orientation=(0, 0, 90), **COARSE)
        np.testing.assert_allclose(moved.points, stood.points, atol=1e-12)

    def test_a_data_object(self):
        path = lms3d.motion.to_trajectory((self.times, self.positions, self.orientations))
        np.testing.assert_array_equal(array(path, "Time"), self.times)
        np.testing.assert_array_equal(lms3d.scan(room(), trajectory=path, **COARSE).points,
                                      self.scan(self.orientations).points)

    def test_invalid_trajectories(self):
        for text, trajectory in {
            "must be a vtkPolyData, or a tuple": "path.vtp",
            "not tuple": ((0, 1, 2),),
            "times of the trajectory must be a row of N numbers": ((), ()),
            r"positions of the trajectory must be 3 x 3 numbers, not \(2, 3\)":
                (self.times, self.positions[:2]),
            r"orientations of the trajectory must be 3 x 4":
                (self.times, self.positions, self.positions),
            "Time": (self.times[::-1], self.positions),
        }.items():
            with self.subTest(text), self.assertRaisesRegex(ValueError, text):
                lms3d.scan(room(), trajectory=trajectory, **COARSE)


class TestDrive(unittest.TestCase):
    """A sensor that drives through the room during one scan."""

    drive = ((0.0, 1.0), ((-0.5, -0.2, 1.0), (1.0, 0.3, 1.0)), ((1, 0, 0, 0), (0.9, 0.1, 0, 0.4)))
    rig = {"mounting": "pitching", "axis_offset": (0.1, -0.05, 0.2), "turn_rate": 37.5,
           "beta_range": (-45, 45)}

    def off_the_surface(self, scan, places):
        """The largest distance of places from the planes of the triangles that the beams hit."""
        scene = room()
        vertices = vtk_to_numpy(scene.GetPoints().GetData()).astype(float)
        corners = vertices[triangles(scene)[scan.cells]]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        return np.abs(np.einsum("ij,ij->i", places - corners[:, 0], normals)).max()

    def test_the_points_are_skewed_and_can_be_corrected(self):
        for rig in ({}, self.rig):
            with self.subTest(rig):
                scan = lms3d.scan(room(), trajectory=self.drive, motion_during_scan=True, poses=True,
                                  **{**COARSE, **rig})
                self.assertGreater(self.off_the_surface(scan, scan.points), 0.1)
                self.assertLess(self.off_the_surface(scan, lms3d.undistort(scan)), 1e-9)

    def test_the_fields(self):
        scan = lms3d.scan(room(), trajectory=self.drive, start_time=0.0, motion_during_scan=True,
                          poses=True, time=True, incidence=True, intensity=True, status=True,
                          **COARSE)
        self.assertEqual(scan.positions.shape, scan.points.shape)
        self.assertEqual(scan.orientations.shape, (len(scan.points), 4))
        self.assertEqual(scan.status.shape, scan.ranges.shape)
        np.testing.assert_array_equal(scan.status == 0, np.isfinite(scan.ranges))
        np.testing.assert_allclose(
            scan.intensity, np.cos(np.radians(scan.incidence)), rtol=0, atol=1e-6)
        share = np.clip(scan.times, 0, 1)[:, None]
        start, end = map(np.array, self.drive[1])
        np.testing.assert_allclose(scan.positions, start + share * (end - start), atol=1e-12)
        np.testing.assert_array_equal(array(scan.poly, "Time"), scan.times)


class TestDriveByOptions(CommandLineTest):
    """The same drive on the command line."""

    def test_the_scan_is_that_of_python(self):
        path = self.folder / "path.vtp"
        write(vtkXMLPolyDataWriter(), lms3d.motion.to_trajectory(TestDrive.drive), path)
        self.done("scan", ROOM, "--trajectory", path, *COARSE_OPTIONS, "--motion-during-scan",
                  "--poses", "-o", self.folder / "scans.pvd")
        scan = read(vtkXMLPolyDataReader(), self.folder / "scans_0000.vtp")
        expected = lms3d.scan(room(), trajectory=TestDrive.drive, motion_during_scan=True,
                              poses=True, alpha_range=(-60, 60), alpha_resolution=31,
                              beta_resolution=24)
        np.testing.assert_array_equal(points(scan), expected.points)
        np.testing.assert_array_equal(lms3d.undistort(scan), lms3d.undistort(expected))
        np.testing.assert_array_equal(array(scan, "SensorPosition"), expected.positions)


if __name__ == "__main__":
    unittest.main()
