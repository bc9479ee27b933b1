#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that several processes return the same bits as one process.

Starts pvbatch under mpirun with ParallelScan.py. LMS3D_PVBATCH and LMS3D_MPIEXEC name the programs,
LMS3D_PLUGIN the plugin's file, LMS3D_DATA_DIR the folder of room.wrl.
"""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import lms3d
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkIOXML import (
    vtkXMLPolyDataReader,
    vtkXMLPolyDataWriter,
    vtkXMLUnstructuredGridWriter,
)

from parallel_scenes import journey, lattice, volume, write

ROOM = Path(os.environ["LMS3D_DATA_DIR"]) / "room.wrl"
SCRIPT = Path(__file__).with_name("ParallelScan.py")

# The runs of pvbatch by name: the number of processes, and whether all of them run the script.
# Otherwise the first one runs it and drives the others.
RUNS = {"1": (1, True), "2": (2, True), "4": (4, True), "driven": (2, False)}

# Returns that are too weak, and why beams gave none.
WEAK = {"RangeAtTenPercent": 2.5, "ReflectanceArray": "Color", "ComputeIncidence": 1,
        "ComputeIntensity": 1, "ComputeStatus": 1}

COARSE = {"AlphaResolution": 37, "BetaResolution": 36}

# A wide beam from a mirror beside the axis of a platform that turns during the fans.
DEVICE = {"Position": [0.3, -0.2, 1.0], "Mounting": 3, "AxisOffset": [0.1, 0.03, -0.05],
          "TurnRate": 37.5, "BeamDiameter": 0.012, "BeamDivergence": 0.0044, "BeamSamples": 7,
          "ComputeTime": 1, "ComputePoses": 1, **WEAK, **COARSE}

# A scan with beams that have no return, and the errors of its ranges.
NEAR = {"Position": [0.3, -0.2, 1.0], "MinimumRange": 2.0, "MaximumRange": 4.0}
ERRORS = {"RangeBias": 0.01, "RangeNoise": 0.005, "RangeResolution": 0.001, "NoiseSeed": 7}

# Errors that remove returns.
NEARER = {**ERRORS, "RangeBias": -2.5}

# Sensors and methods by name. Each scans a scene on one process and a spread scene.
SCANS = {
    "room": (ROOM, {"Position": [0.3, -0.2, 1.0]}),
    "near": (ROOM, NEAR),
    # From the middle, beams hit the ball's vertices and edges, and the squares' corners.
    "lattice": ("lattice.vtp", {"Position": [0.0, 0.0, 0.0]}),
    "device": (ROOM, DEVICE),
    "weak": (ROOM, {**NEAR, **WEAK}),
    "weak and labelled": (ROOM, {**NEAR, **WEAK, "SurfaceAttributes": 1, **COARSE}),
    # A beam that meets a limit exactly, and vertices and edges.
    "status": ("lattice.vtp", {"Position": [0.0, 0.0, 0.0], "MinimumRange": 1.0, "MaximumRange": 2.5,
                               "ComputeStatus": 1}),
    "labelled": (ROOM, {"Position": [0.3, -0.2, 1.0], "SurfaceAttributes": 1, **COARSE}),
    "paper": (ROOM, {"Position": [0.0, 0.0, 1.0], "IntersectionMethod": 2, **COARSE}),
    "textbook": ("lattice.vtp", {"Position": [0.0, 0.0, 0.0], "IntersectionMethod": 3, **COARSE}),
}


def read(path):
    """The reader of a scene in one process."""
    reader = (lms3d.vtkVRMLImporterSource if str(path).endswith(".wrl") else vtkXMLPolyDataReader)()
    reader.SetFileName(str(path))
    return reader


def serial(scene, properties, errors=None):
    """The arrays that one process computes, in the form of ParallelScan.py."""
    reader = read(scene)
    scan = lms3d.vtkLMS3DScanFilter()
    scan.SetInputConnection(reader.GetOutputPort())
    for name, value in properties.items():
        getattr(scan, f"Set{name}")(value)
    if errors:
        ideal, scan = scan, lms3d.vtkLMS3DRangeErrorFilter()
        scan.SetInputConnection(ideal.GetOutputPort())
        for name, value in errors.items():
            getattr(scan, f"Set{name}")(value)
    local_map = lms3d.vtkLMS3DSurfaceReconstructionFilter()
    local_map.SetInputConnection(scan.GetOutputPort())
    local_map.Update()
    data = scan.GetOutput().GetPointData()
    arrays = {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
              for i in range(data.GetNumberOfArrays())}
    arrays["Points"] = vtk_to_numpy(scan.GetOutput().GetPoints().GetData())
    beams, turns, _ = scan.GetRangeImage().GetDimensions()
    image = vtk_to_numpy(scan.GetRangeImage().GetPointData().GetArray("Range"))
    arrays["Image"] = image.reshape(turns, beams)
    status = scan.GetOutput().GetFieldData().GetArray("Status")
    if status:
        arrays["Status"] = vtk_to_numpy(status)
        image = vtk_to_numpy(scan.GetRangeImage().GetPointData().GetArray("Status"))
        arrays["StatusImage"] = image.reshape(turns, beams)
    surface = local_map.GetOutput()
    arrays["Map"] = vtk_to_numpy(surface.GetPoints().GetData())
    arrays["MapTriangles"] = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
    return arrays


def can_redistribute():
    """Whether ParaView's RedistributeDataSet keeps all cells on this system.

    It sends the pieces as XML with raw appended data. Updates of Debian 12 brought a libexpat that
    rejects such XML, and the filter then loses the pieces. D3 sends pieces in another format.
    """
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(lattice())
    writer.WriteToOutputStringOn()
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.Write()
    reader = vtkXMLPolyDataReader()
    reader.ReadFromInputStringOn()
    reader.SetInputString(writer.GetOutputString())
    vtkObject.GlobalWarningDisplayOff()
    reader.Update()
    vtkObject.GlobalWarningDisplayOn()
    return reader.GetOutput().GetNumberOfCells() > 0


# How scenes are spread over the processes; "one" leaves them on the first.
CAN_REDISTRIBUTE = can_redistribute()
SPREADS = ("one", "D3", *(["RedistributeDataSet"] if CAN_REDISTRIBUTE else []))


class TestParallel(unittest.TestCase):
    """Runs all cases in one pvbatch for each number of processes."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        write(lattice(), cls.folder / "lattice.vtp")
        write(volume(), cls.folder / "volume.vtu", vtkXMLUnstructuredGridWriter)
        write(journey((0.0, 0.0, 0.5), (0.3, -0.2, 1.0)), cls.folder / "journey.vtp")
        write(journey((0.0, 0.0, 1e19)), cls.folder / "bad.vtp")
        for run, (count, is_symmetric) in RUNS.items():
            cls.run_all(run, count, ["--sym"] if is_symmetric else [])

    @classmethod
    def run_all(cls, run, count, options):
        """Scan all cases with `count` processes."""
        folder = cls.folder / run
        folder.mkdir()
        job = folder / "job.json"
        job.write_text(json.dumps(list(cls.cases())))
        subprocess.run(
            [os.environ["LMS3D_MPIEXEC"], "-n", str(count),
             os.environ["LMS3D_PVBATCH"], *options, str(SCRIPT), str(job)],
            check=True, timeout=300)

    @classmethod
    def cases(cls):
        """The cases for ParallelScan.py."""
        for name, (scene, properties) in SCANS.items():
            for spread in SPREADS:
                yield {"name": f"{name}.{spread}", "scene": str(cls.folder / scene),
                       "spread": spread, "properties": properties}
        room = {"scene": str(ROOM), "spread": SPREADS[-1], "properties": {}}
        yield {**room, "name": "reported", "properties": NEAR, "errors": ERRORS}
        yield {**room, "name": "reported status", "properties": {**NEAR, **WEAK}, "errors": NEARER}
        yield {**room, "name": "uncoloured", "properties": {**WEAK, "ReflectanceArray": "Colour"}}
        yield {**room, "name": "journey", "trajectory": str(cls.folder / "journey.vtp"), "time": 1}
        yield {**room, "name": "lost", "trajectory": str(cls.folder / "bad.vtp")}
        # From far above, no beam returns. The labelled cells are in all processes, or in the first alone.
        for spread in SPREADS[:2]:
            yield {**room, "name": f"unseen.{spread}", "spread": spread, "properties":
                   {"Position": [0.0, 0.0, 1000.0], "SurfaceAttributes": 1, **COARSE}}
        yield {**room, "name": "volume", "scene": str(cls.folder / "volume.vtu")}
        yield {**room, "name": "empty", "scene": str(cls.folder / "journey.vtp")}
        yield {**room, "name": "missing", "scene": str(cls.folder / "no.wrl"), "spread": "one"}
        yield {**room, "name": "compared", "compare": True}

    def assert_same(self, name, scene, properties, errors=None):
        """Every number of processes returns what one process returns."""
        expected = serial(self.folder / scene, properties, errors)
        self.assertGreater(expected["MapTriangles"].size, 0)
        for run, (_, is_symmetric) in RUNS.items():
            with self.subTest(name, run=run), np.load(self.folder / run / f"{name}.npz") as scan:
                # The script does not see the part of a driven process.
                images = {image: (self.image(f"{name}.{kind}", run, expected[image].shape)
                                  if is_symmetric else expected[image])
                          for image, kind in (("Image", "Range"), ("StatusImage", "Status"))
                          if image in expected}
                found = {**scan, **images}
                # The filters that spread a scene add this cell array, and the scan passes it on.
                found.pop("vtkOriginalCellIds", None)
                self.assertEqual(set(found), set(expected))
                for array, values in expected.items():
                    np.testing.assert_array_equal(found[array], values, array)

    def image(self, name, run, shape):
        """The range image of a case, assembled from the parts of all processes."""
        whole = np.full(shape, -1.0)
        for part in (self.folder / run).glob(f"{name}.*.npz"):
            with np.load(part) as found:
                (turn, beam), rows = found["first"], found["rows"]
                whole[turn:turn + rows.shape[0], beam:beam + rows.shape[1]] = rows
        return whole

    def assert_scans(self, spread):
        """All scans of scenes that are spread this way return what one process returns."""
        for name, (scene, properties) in SCANS.items():
            self.assert_same(f"{name}.{spread}", scene, properties)

    def test_scenes_on_one_process(self):
        self.assert_scans("one")

    def test_scenes_spread_by_d3(self):
        self.assert_scans("D3")

    @unittest.skipUnless(CAN_REDISTRIBUTE, "libexpat rejects what RedistributeDataSet sends")
    def test_scenes_spread_by_redistribute_data_set(self):
        self.assert_scans("RedistributeDataSet")

    def test_trajectory_is_followed_by_all(self):
        self.assert_same("journey", ROOM, {"Position": [0.3, -0.2, 1.0]})

    def names(self, run, name):
        """The arrays of each process."""
        return [json.loads((self.folder / run / f"{name}.{rank}.json").read_text())
                for rank in range(RUNS[run][0] if RUNS[run][1] else 1)]

    def test_all_processes_have_the_same_arrays(self):
        for name in ("room.one", "labelled.one", "labelled.D3", "unseen.one", "unseen.D3"):
            for run in ("2", "4"):
                with self.subTest(name, run=run):
                    first, *others = self.names(run, name)
                    self.assertEqual(first["count"] == 0, name.startswith("unseen"))
                    self.assertEqual(others, [{**first, "count": 0}] * len(others))

    def test_a_scan_without_returns_has_the_arrays_of_one_process(self):
        for name in ("unseen.one", "unseen.D3"):
            expected = self.names("1", name)[0]["arrays"]
            names = {array for array, *_ in expected}
            self.assertLessEqual({"Normals", "Incidence", "Color", "ShapeId", "Range"}, names)
            for run in ("2", "4"):
                with self.subTest(name, run=run):
                    # The filters that spread a scene over several processes add a cell array.
                    found = [array for array in self.names(run, name)[0]["arrays"]
                             if array[0] != "vtkOriginalCellIds"]
                    self.assertEqual(found, expected)

    def test_errors_of_ranges_are_the_same(self):
        self.assert_same("reported", ROOM, NEAR, ERRORS)

    def test_status_of_reported_ranges_is_the_same(self):
        self.assert_same("reported status", ROOM, {**NEAR, **WEAK}, NEARER)

    def test_all_processes_report_errors_and_go_on(self):
        words_of = {"lost": "The trajectory has its point 0", "empty": "The scene has no polygons",
                    "volume": "The scene has volume cells on several processes",
                    "missing": "The scene has no polygons",
                    "uncoloured": 'ReflectanceArray is "Colour", but the scene has no such'}
        for name, words in words_of.items():
            for run, (count, _) in RUNS.items():
                if name in ("volume", "missing") and count == 1:
                    continue
                with self.subTest(name, run=run):
                    folder = self.folder / run
                    self.assertIn(words, (folder / f"{name}.txt").read_text())
                    with np.load(folder / f"{name}.npz") as found:
                        self.assertEqual(set(found), set())

    def test_map_comparison_refuses_a_spread_scene(self):
        for run, (count, _) in RUNS.items():
            with self.subTest(run=run):
                words = (self.folder / run / "compared.txt").read_text()
                self.assertEqual("The scene is spread over" in words, count > 1, words)


if __name__ == "__main__":
    unittest.main()
