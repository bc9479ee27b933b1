# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a map of a scan's points with one library: peers_mappers.py MAPPER POINTS.npz MAP.npz.

A mapper gets the points and the sensor's position, towards which it turns the normals.
"""

import sys
import time

import numpy
from peers_casters import import_open3d

NEIGHBOURS = 30
SECONDS = 2.0  # for which each map is made again, as by "./run bench map"
# Poisson's surface is closed; this share of its vertices, the least supported, is cut away.
TRIMMED_SHARE = 0.05


def _make_cloud(open3d, points, sensor):
    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points))
    cloud.estimate_normals(open3d.geometry.KDTreeSearchParamKNN(NEIGHBOURS))
    cloud.orient_normals_towards_camera_location(sensor)
    return cloud


def _make_poisson_mapper(depth):
    """Return a function that solves Poisson's equation in an octree of this depth."""
    def make(open3d, points, sensor):
        mesh, densities = open3d.geometry.TriangleMesh.create_from_point_cloud_poisson(
            _make_cloud(open3d, points, sensor), depth=depth)
        densities = numpy.asarray(densities)
        mesh.remove_vertices_by_mask(densities < numpy.quantile(densities, TRIMMED_SHARE))
        return mesh
    return make


# By their names on the chart.
MAPPERS = {f"Open3D Poisson depth {depth}": _make_poisson_mapper(depth) for depth in (8, 9)}


def main(name, points_file, map_file):
    """Make the map; save it and its best time in seconds."""
    scan = numpy.load(points_file)
    open3d = import_open3d()
    times = []
    while sum(times) < SECONDS:
        start = time.perf_counter()
        mesh = MAPPERS[name](open3d, scan["points"], scan["sensor"])
        times.append(time.perf_counter() - start)
    numpy.savez(map_file, seconds=min(times), points=numpy.asarray(mesh.vertices),
                triangles=numpy.asarray(mesh.triangles))


if __name__ == "__main__":
    main(*sys.argv[1:])
