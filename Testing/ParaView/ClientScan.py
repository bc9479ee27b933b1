# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the pipeline in a client: `pvpython ClientScan.py RESULTS.npz [PORT]`.

With a port it connects to the pvserver there, and the server reads, scans and maps. Without a port
this process does all. LMS3D_PLUGIN is the plugin's file, LMS3D_DATA_DIR the folder of room.wrl.
"""

import os
import sys
from pathlib import Path

import numpy as np
from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy

DATA = Path(os.environ["LMS3D_DATA_DIR"])
PLUGIN = os.environ["LMS3D_PLUGIN"]
DOORWAY_TIME = 13

RESULTS, *PORT = sys.argv[1:]

if PORT:
    assert simple.Connect("127.0.0.1", int(*PORT))
    simple.LoadPlugin(PLUGIN, remote=True)
simple.LoadPlugin(PLUGIN, remote=False, ns=globals())


def contents(proxy, time=None):
    """The output of a proxy's filter in any process: points, triangles and point data."""
    proxy.UpdatePipeline(time)
    data = servermanager.Fetch(proxy)
    yield "Points", data.GetPoints().GetData()
    yield "Triangles", data.GetPolys().GetConnectivityArray()
    arrays = data.GetPointData()
    for i in range(arrays.GetNumberOfArrays()):
        yield arrays.GetArrayName(i), arrays.GetArray(i)


def results():
    """All arrays of the pipeline, by the names of proxy and array."""
    room = simple.OpenDataFile(str(DATA / "room.wrl"))
    scan = LMS3DScan(Input=room, Position=[0.3, -0.2, 1.0])
    journey = LMS3DScan(Input=room, Trajectory=simple.OpenDataFile(str(DATA / "journey.vtp")))
    made = {
        "room": contents(room),
        "scan": contents(scan),
        "map": contents(LMS3DSurfaceReconstruction(Input=scan)),
        "doorway": contents(journey, DOORWAY_TIME),
    }
    return {f"{name}.{array}": vtk_to_numpy(values)
            for name, arrays in made.items() for array, values in arrays}


connection = servermanager.ActiveConnection
np.savez(RESULTS, remote=connection.IsRemote(), processes=connection.GetNumberOfDataPartitions(),
         **results())
