# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the table of parallel.md: `mpirun -n N pvbatch --sym measure_parallel.py PLUGIN`.

The scene is a ball of 8 million triangles around the sensor. ParaView's source creates a piece of it on
each process, so that no filter has to spread it, and each process uses one thread. Prints for each
process the time of the first scan, which builds, the time of the next ones, which do not, and the
memory that the first one took.
"""

import sys
import time
from pathlib import Path

from paraview import simple
from paraview.vtk import vtkMultiProcessController

simple.LoadPlugin(sys.argv[1], remote=False, ns=globals())

RESOLUTION = 2000
REPETITIONS = 10


def memory():
    """Resident memory of this process, MB."""
    status = Path("/proc/self/status").read_text()
    return int(status.split("VmRSS:")[1].split()[0]) / 1024


def scan_time(scan, height):
    """Seconds from moving the sensor to its scan. All processes have to call this."""
    scan.Position = [0.1, 0.2, height]
    start = time.perf_counter()
    scan.UpdatePipeline()
    return time.perf_counter() - start


ball = simple.Sphere(Radius=10, ThetaResolution=RESOLUTION, PhiResolution=RESOLUTION)
ball.UpdatePipeline()
triangles = ball.SMProxy.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()
before = memory()
scanner = LMS3DScan(Input=ball, NumberOfThreads=1)
first = scan_time(scanner, 0.0)
taken = memory() - before
later = min(scan_time(scanner, 0.01 * (i + 1)) for i in range(REPETITIONS))

process = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
print(f"process {process}: {triangles} triangles, first scan {first:.2f} s, "
      f"next {1000 * later:.0f} ms, {taken:.0f} MB", flush=True)
