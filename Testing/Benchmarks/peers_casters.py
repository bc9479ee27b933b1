# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scans one scene with one peer: peers_casters.py PEER SCENE.npz RESULT.npz SECONDS.

Each peer is a function that takes the scene and returns another function, which does one scan and
returns the ranges (infinite or not a number where nothing is hit) of all beams and their points, or
those of the beams that hit. What it does before that counts as building. The directions are
ready-made; LMS3D makes its own.
"""

import ctypes
import dataclasses
import importlib
import os
import sys
import time
from typing import Callable

import numpy

SECONDS = 3.0
FEWEST_SCANS = 5
LONG_SCAN = 2.0


def import_open3d():
    """Return Open3D, which links to libusb, which not every system has."""
    import libusb_package
    ctypes.CDLL(str(libusb_package.get_library_path()), mode=ctypes.RTLD_GLOBAL)
    import open3d
    return open3d


def open3d(scene):
    """Open3D's RaycastingScene, single precision, all cores."""
    open3d = import_open3d()
    caster = open3d.t.geometry.RaycastingScene()
    caster.add_triangles(scene["points"].astype(numpy.float32),
                         scene["triangles"].astype(numpy.uint32))
    origins, directions = _single_rays(scene)
    rays = open3d.core.Tensor(numpy.hstack([origins, directions]))

    def scan():
        ranges = caster.cast_rays(rays)["t_hit"].numpy()
        return ranges, origins + ranges[:, None] * directions
    return scan


def embreex(scene):
    """Embreex's EmbreeScene, single rays, one core."""
    from embreex import rtcore_scene
    from embreex.mesh_construction import TriangleMesh
    caster = rtcore_scene.EmbreeScene()
    TriangleMesh(caster, scene["points"].astype(numpy.float32), scene["triangles"])
    origins, directions = _single_rays(scene)

    def scan():
        ranges = caster.run(origins, directions, query="DISTANCE")
        ranges = numpy.where(ranges < 1e30, ranges, numpy.inf)
        return ranges, origins + ranges[:, None] * directions
    return scan


def trimesh(scene):
    """Trimesh with embreex, which intersects the planes anew in double; one core."""
    import trimesh
    from trimesh.ray.ray_pyembree import RayMeshIntersector
    mesh = trimesh.Trimesh(scene["points"], scene["triangles"], process=False)
    caster = RayMeshIntersector(mesh)
    directions = scene["directions"]
    origins = numpy.broadcast_to(scene["sensor"], directions.shape).copy()

    def scan():
        points = numpy.full(directions.shape, numpy.nan)
        hits, beams, _ = caster.intersects_location(origins, directions, multiple_hits=False)
        points[beams] = hits
        return numpy.linalg.norm(points - scene["sensor"], axis=1), points
    return scan


def _vtk_locator(name, module="vtkCommonDataModel"):
    def cast(scene):
        from vtkmodules.vtkCommonCore import mutable
        locator = getattr(importlib.import_module(f"vtkmodules.{module}"), name)()
        locator.SetDataSet(_make_surface(scene))
        locator.BuildLocator()
        start = scene["sensor"].tolist()
        ends = (scene["sensor"] + scene["reach"] * scene["directions"]).tolist()
        reach = float(scene["reach"])

        def scan():
            ranges, points = numpy.full(len(ends), numpy.nan), numpy.full((len(ends), 3), numpy.nan)
            t, part = mutable(0.0), mutable(0)
            point, place = [0.0] * 3, [0.0] * 3
            for beam, end in enumerate(ends):
                if locator.IntersectWithLine(start, end, 1e-9, t, point, place, part):
                    ranges[beam] = reach * t.get()
                    points[beam] = point
            return ranges, points
        return scan
    cast.__doc__ = f"VTK's {name}, called from Python beam by beam; one core."
    return cast


def _lms3d(method, threads):
    def cast(scene):
        from lms3d import vtkLMS3DScanFilter
        from vtkmodules.util.numpy_support import vtk_to_numpy
        filter_ = vtkLMS3DScanFilter()
        filter_.SetInputData(_make_surface(scene))
        filter_.SetNumberOfThreads(threads)
        filter_.SetPosition(scene["sensor"])
        getattr(filter_, f"SetIntersectionMethodTo{method}")()
        filter_.SetMaximumRange(float(scene["reach"]))

        def scan():
            filter_.Modified()
            filter_.Update()
            image = filter_.GetOutputDataObject(1).GetPointData()
            return (vtk_to_numpy(image.GetArray("Range")),
                    vtk_to_numpy(filter_.GetOutput().GetPoints().GetData()))
        return scan
    cast.__doc__ = f"LMS3D, {method}."
    return cast


@dataclasses.dataclass(frozen=True)
class Peer:
    """A row of the table."""

    name: str
    threads: int
    # Whether it runs in Debian's Python, not in the environment of pip's packages.
    is_debian: bool
    make: Callable


CORES = len(os.sched_getaffinity(0))

# In the order of the table.
PEERS = (
    Peer("LMS3D Fast", CORES, True, _lms3d("Fast", CORES)),
    Peer("LMS3D Exact", CORES, True, _lms3d("Exact", CORES)),
    Peer("LMS3D Fast", 1, True, _lms3d("Fast", 1)),
    Peer("LMS3D Exact", 1, True, _lms3d("Exact", 1)),
    Peer("Open3D RaycastingScene", CORES, False, open3d),
    Peer("embreex EmbreeScene", 1, False, embreex),
    Peer("trimesh + embreex", 1, False, trimesh),
    Peer("vtkStaticCellLocator in LMS3D", CORES, True, _lms3d("StaticCellLocator", CORES)),
    Peer("vtkStaticCellLocator", 1, True, _vtk_locator("vtkStaticCellLocator")),
    Peer("vtkCellLocator", 1, True, _vtk_locator("vtkCellLocator")),
    Peer("vtkModifiedBSPTree", 1, True, _vtk_locator("vtkModifiedBSPTree", "vtkFiltersFlowPaths")),
    Peer("vtkOBBTree", 1, True, _vtk_locator("vtkOBBTree", "vtkFiltersGeneral")),
)


def _single_rays(scene):
    directions = scene["directions"].astype(numpy.float32)
    origins = numpy.broadcast_to(scene["sensor"].astype(numpy.float32), directions.shape).copy()
    return origins, directions


def _make_surface(scene):
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    points = vtkPoints()
    points.SetData(numpy_to_vtk(scene["points"], deep=True))
    corners = scene["triangles"].astype(numpy.int64)
    offsets = numpy.arange(0, corners.size + 1, 3, dtype=numpy.int64)
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(corners.ravel(), deep=True))
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(cells)
    return surface


def _time(work):
    start = time.perf_counter()
    result = work()
    return time.perf_counter() - start, result


def _load(peer, scene):
    """Scan with one triangle and one beam, so that libraries are loaded before the clock starts."""
    peer.make({**scene, "triangles": scene["triangles"][:1],
               "directions": scene["directions"][:1]})()


def _memory(name):
    """Bytes of a line of /proc/self/status: VmRSS is held now, VmHWM was the most."""
    with open("/proc/self/status", encoding="ascii") as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith(name))


def _point_error(scene, ranges, points):
    """Return how far the farthest point is from where its beam's range ends, metres."""
    is_hit = numpy.isfinite(ranges)
    expected = scene["sensor"] + ranges[is_hit, None] * scene["directions"][is_hit]
    if len(points) == len(ranges):
        points = points[is_hit]
    if points.shape != expected.shape:
        raise SystemExit(f"{len(points)} points for {len(expected)} beams that hit")
    return numpy.linalg.norm(points - expected, axis=1).max(initial=0.0)


def main(number, scene_file, result_file, most):
    """Build, scan for so many seconds, save the ranges and the best time."""
    peer = PEERS[int(number)]
    scene = dict(numpy.load(scene_file))
    _load(peer, scene)
    with open("/proc/self/clear_refs", "w", encoding="ascii") as clear:
        clear.write("5")  # lets the peak start anew
    start = _memory("VmRSS")
    build, scan = _time(lambda: peer.make(scene))
    first, (ranges, points) = _time(scan)
    best = first
    end = time.perf_counter() + float(most)
    scans = 1
    while best < LONG_SCAN and (scans < FEWEST_SCANS or time.perf_counter() < end):
        seconds, (ranges, points) = _time(scan)
        best = min(best, seconds)
        scans += 1
    peak = _memory("VmHWM") - start
    point_error = _point_error(scene, ranges, points)
    ranges = numpy.where(ranges <= scene["reach"], ranges, numpy.inf)
    numpy.savez(result_file, ranges=ranges, build=build + first - best, scan=best, scans=scans,
                peak=peak, point_error=point_error)


if __name__ == "__main__":
    main(*sys.argv[1:])
