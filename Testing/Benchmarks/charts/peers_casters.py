# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Repeats a scan with one library: peers_casters.py CASTER SCENE.npz SECONDS RESULT.npz.

A caster is a function that takes the scene and returns another function, which does one scan. A
scan returns the ranges of all beams (infinite or not a number: no hit) and their points, or the
points of the beams that hit. The directions are ready-made.
"""

import ctypes
import sys
import time

import numpy

MINIMUM_SCANS = 5
LONG_SCAN = 2.0  # seconds; a scan that takes longer runs once
# Metres. A point farther than this from the end of its range is a mistake; single precision is off
# by about 1e-5.
MAXIMUM_POINT_ERROR = 1e-3


def import_open3d():
    """Return Open3D, after loading libusb, which it links to and not every system has."""
    import libusb_package
    ctypes.CDLL(str(libusb_package.get_library_path()), mode=ctypes.RTLD_GLOBAL)
    import open3d
    return open3d


def cast_with_open3d(scene):
    """Open3D's RaycastingScene, single precision."""
    open3d = import_open3d()
    caster = open3d.t.geometry.RaycastingScene()
    caster.add_triangles(scene["points"].astype(numpy.float32),
                         scene["triangles"].astype(numpy.uint32))
    origins, directions = _make_single_rays(scene)
    rays = open3d.core.Tensor(numpy.hstack([origins, directions]))

    def scan():
        ranges = caster.cast_rays(rays)["t_hit"].numpy()
        return ranges, origins + ranges[:, None] * directions
    return scan


def cast_with_embreex(scene):
    """Embreex's EmbreeScene, single precision, single rays."""
    from embreex import rtcore_scene
    from embreex.mesh_construction import TriangleMesh
    caster = rtcore_scene.EmbreeScene()
    TriangleMesh(caster, scene["points"].astype(numpy.float32), scene["triangles"])
    origins, directions = _make_single_rays(scene)

    def scan():
        ranges = caster.run(origins, directions, query="DISTANCE")
        ranges = numpy.where(ranges < 1e30, ranges, numpy.inf)
        return ranges, origins + ranges[:, None] * directions
    return scan


def cast_with_trimesh(scene):
    """Trimesh with embreex: single precision decides, the range is measured in double."""
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


# By their names on the chart.
CASTERS = {"Open3D": cast_with_open3d, "embreex": cast_with_embreex, "trimesh": cast_with_trimesh}


def _make_single_rays(scene):
    directions = scene["directions"].astype(numpy.float32)
    origins = numpy.broadcast_to(scene["sensor"].astype(numpy.float32), directions.shape).copy()
    return origins, directions


def _load_libraries(cast, scene):
    """Scan one triangle with one beam, so that no library is loaded while the clock runs."""
    cast({**scene, "triangles": scene["triangles"][:1], "directions": scene["directions"][:1]})()


def _time(scan):
    start = time.perf_counter()
    ranges, points = scan()
    return time.perf_counter() - start, ranges, points


def _check_points(scene, ranges, points):
    """Exit if a point is not where its beam's range ends."""
    is_hit = numpy.isfinite(ranges)
    expected = scene["sensor"] + ranges[is_hit, None] * scene["directions"][is_hit]
    if len(points) == len(ranges):
        points = points[is_hit]
    if points.shape != expected.shape:
        raise SystemExit(f"{len(points)} points for {len(expected)} beams that hit")
    error = numpy.linalg.norm(points - expected, axis=1).max(initial=0.0)
    if not error <= MAXIMUM_POINT_ERROR:
        raise SystemExit(f"points are {error:.1e} m from where their ranges end")


def main(name, scene_file, seconds, result_file):
    """Scan for some seconds; save the ranges and the best time of a scan in seconds."""
    scene = dict(numpy.load(scene_file))
    _load_libraries(CASTERS[name], scene)
    scan = CASTERS[name](scene)
    best, ranges, points = _time(scan)
    _check_points(scene, ranges, points)
    end = time.perf_counter() + float(seconds)
    scans = 1
    while best < LONG_SCAN and (scans < MINIMUM_SCANS or time.perf_counter() < end):
        best = min(best, _time(scan)[0])
        scans += 1
    numpy.savez(result_file, ranges=ranges, seconds=best)


if __name__ == "__main__":
    main(*sys.argv[1:])
