# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scans with all processes of a pvbatch: `pvbatch ParallelScan.py JOB.json`, under mpirun.

JOB.json lists the cases: a scene, the filter that spreads it over the processes, the properties of
the scan, and the errors of its ranges. In the folder of the job the first process writes the arrays of
each case to CASE.npz and its errors to CASE.txt, and each process the names of its arrays to
CASE.RANK.json.
"""

import json
import os
import sys
from pathlib import Path

import numpy as np
from paraview import simple
from paraview.vtk import vtkMultiProcessController
from paraview.vtk.util.numpy_support import vtk_to_numpy

simple.LoadPlugin(os.environ["LMS3D_PLUGIN"], remote=False, ns=globals())

JOB = Path(sys.argv[1])
PROCESS = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()


def spread(scene, way):
    """The scene with its cells on the first process, or on all of them."""
    if way == "one":
        return scene
    numbered = simple.GenerateGlobalIds(Input=scene)
    return getattr(simple, way)(Input=numbered)


def algorithm(proxy):
    """The VTK filter behind a proxy, in this process."""
    return proxy.SMProxy.GetClientSideObject()


def listen(filter_, said):
    """Collect the errors of a filter, and silence its executive, which repeats them."""
    def hear(caller, event, words):
        said.append(words)
    hear.CallDataType = "string0"
    filter_.AddObserver("ErrorEvent", hear)
    filter_.GetExecutive().AddObserver("ErrorEvent", lambda caller, event: None)


def names(scan):
    """The names, types and sizes of this process's arrays, and the name of its active normals."""
    points = algorithm(scan).GetOutputDataObject(0)
    data = points.GetPointData()
    arrays = map(data.GetAbstractArray, range(data.GetNumberOfArrays()))
    normals = data.GetNormals()
    return {"count": points.GetNumberOfPoints(), "normals": normals and normals.GetName(),
            "arrays": sorted([array.GetName(), array.GetDataType(), array.GetNumberOfComponents()]
                             for array in arrays)}


def contents(scan):
    """The arrays of the scan by name; empty without a return."""
    points = algorithm(scan).GetOutputDataObject(0)
    if points.GetNumberOfPoints() == 0:
        return {}
    arrays = {array.GetName(): vtk_to_numpy(array)
              for array in map(points.GetPointData().GetArray,
                               range(points.GetPointData().GetNumberOfArrays()))}
    arrays["Points"] = vtk_to_numpy(points.GetPoints().GetData())
    status = points.GetFieldData().GetArray("Status")
    return {**arrays, **({"Status": vtk_to_numpy(status)} if status else {})}


def contents_of_map(local_map):
    """The map's points and triangles."""
    surface = algorithm(local_map).GetOutputDataObject(0)
    if surface.GetNumberOfCells() == 0:
        return {}
    return {"Map": vtk_to_numpy(surface.GetPoints().GetData()),
            "MapTriangles": vtk_to_numpy(surface.GetPolys().GetConnectivityArray())}


def save_image(scan, name):
    """Save this process's part of the arrays of the range image, and its place in the whole."""
    image = algorithm(scan).GetOutputDataObject(1)
    if image.GetNumberOfPoints():
        first_beam, last_beam, first_turn, last_turn = image.GetExtent()[:4]
        arrays = image.GetPointData()
        for array in map(arrays.GetArray, range(arrays.GetNumberOfArrays())):
            rows = vtk_to_numpy(array).reshape(last_turn - first_turn + 1, last_beam - first_beam + 1)
            np.savez(JOB.parent / f"{name}.{array.GetName()}.{PROCESS}",
                     first=(first_turn, first_beam), rows=rows)


def run(case):
    """Scan once and reconstruct the map."""
    reader = VRMLReader if case["scene"].endswith(".wrl") else simple.OpenDataFile
    scene = reader(FileName=case["scene"]) if reader is VRMLReader else reader(case["scene"])
    scan = LMS3DScan(Input=spread(scene, case["spread"]), **case["properties"])
    if "trajectory" in case:
        poses = simple.OpenDataFile(case["trajectory"])
        poses.UpdatePipeline()
        algorithm(scan).SetInputConnection(1, algorithm(poses).GetOutputPort())
    said = []
    listen(algorithm(scan), said)
    if "time" in case:
        scan.UpdatePipeline(case["time"])
    else:
        scan.UpdatePipeline()
    if "errors" in case:
        scan = LMS3DRangeError(Input=scan, **case["errors"])
        scan.UpdatePipeline()
    local_map = LMS3DSurfaceReconstruction(Input=scan)
    if not said:
        local_map.UpdatePipeline()
    if "compare" in case:
        comparison = LMS3DMapComparison(Map=local_map, Scene=scan.Input)
        listen(algorithm(comparison), said)
        comparison.UpdatePipeline()
    arrays = {**contents(scan), **contents_of_map(local_map)}
    save_image(scan, case["name"])
    (JOB.parent / f"{case['name']}.{PROCESS}.json").write_text(json.dumps(names(scan)))
    if PROCESS == 0:
        np.savez(JOB.parent / case["name"], **arrays)
        (JOB.parent / f"{case['name']}.txt").write_text("".join(said))
    else:
        assert not arrays, "the first process alone has returns"


for case_ in json.loads(JOB.read_text()):
    run(case_)
