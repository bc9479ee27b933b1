# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scans one scene with one peer: peers_casters.py PEER SCENE.npz RESULT.npz.

Each peer is a function that takes the scene and returns another function, which does one scan and
returns the ranges (infinite or not a number where nothing is hit) and the points of all beams. What
it does before that counts as building. The directions are ready-made; LMS3D makes its own.
"""

import ctypes
import sys
import time

import numpy

SECONDS = 3.0
FEWEST_SCANS = 5
LONG_SCAN = 2.0


def open3d(scene):
    """Open3D's RaycastingScene, single precision, all cores."""
    # Open3D links to libusb, which not every system has.
    import libusb_package
    ctypes.CDLL(str(libusb_package.get_library_path()), mode=ctypes.RTLD_GLOBAL)
    import open3d
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


def _vtk_locator(name):
    def cast(scene):
        import vtkmodules.vtkCommonDataModel as data_model
        from vtkmodules.vtkCommonCore import mutable
        locator = getattr(data_model, name)()
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


def _lms3d(method, threads=0):
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
    cast.__doc__ = f"LMS3D, {method}; {threads or 'all'} cores."
    return cast


# In the order of the table: the words there, whether it runs in Debian's Python, the function.
PEERS = {
    "LMS3D Fast": (True, _lms3d("Fast")),
    "LMS3D Exact": (True, _lms3d("Exact")),
    "LMS3D Fast, 1 thread": (True, _lms3d("Fast", 1)),
    "LMS3D Exact, 1 thread": (True, _lms3d("Exact", 1)),
    "Open3D RaycastingScene": (False, open3d),
    "embreex EmbreeScene": (False, embreex),
    "trimesh + embreex": (False, trimesh),
    "vtkStaticCellLocator in LMS3D": (True, _lms3d("StaticCellLocator")),
    "vtkStaticCellLocator": (True, _vtk_locator("vtkStaticCellLocator")),
    "vtkCellLocator": (True, _vtk_locator("vtkCellLocator")),
}


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
    PEERS[peer][1]({**scene, "triangles": scene["triangles"][:1],
                    "directions": scene["directions"][:1]})()


def main(peer, scene_file, result_file):
    """Build, scan many times, save the ranges and the best time."""
    scene = dict(numpy.load(scene_file))
    _load(peer, scene)
    build, scan = _time(lambda: PEERS[peer][1](scene))
    first, (ranges, points) = _time(scan)
    best = first
    end = time.perf_counter() + SECONDS
    scans = 1
    while best < LONG_SCAN and (scans < FEWEST_SCANS or time.perf_counter() < end):
        seconds, (ranges, points) = _time(scan)
        best = min(best, seconds)
        scans += 1
    ranges = numpy.where(ranges <= scene["reach"], ranges, numpy.inf)
    assert points.shape[1] == 3
    numpy.savez(result_file, ranges=ranges, build=build + first - best, scan=best, scans=scans)


if __name__ == "__main__":
    main(*sys.argv[1:])
