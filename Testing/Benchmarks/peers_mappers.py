# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a map of a scan's points with one peer: NAME POINTS-FILE MAP-FILE.

Runs in a process of its own, with the Python that has the peer. The peers know the points and where
the sensor was, towards which they turn their normals.
"""

import sys
import time

import numpy

from peers_casters import import_open3d

NEIGHBOURS = 30
# Each is repeated for so long, as those of "./run bench map" are.
SECONDS = 2.0
# Of the vertices, those that the fewest points support; Poisson closes every surface.
TRIMMED_SHARE = 0.05


def _make_cloud(open3d, points, sensor):
    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points))
    cloud.estimate_normals(open3d.geometry.KDTreeSearchParamKNN(NEIGHBOURS))
    cloud.orient_normals_towards_camera_location(sensor)
    return cloud


def poisson(depth):
    """Return a function that solves Poisson's equation in an octree and trims what is far."""

    def make(open3d, points, sensor):
        mesh, densities = open3d.geometry.TriangleMesh.create_from_point_cloud_poisson(
            _make_cloud(open3d, points, sensor), depth=depth)
        densities = numpy.asarray(densities)
        mesh.remove_vertices_by_mask(densities < numpy.quantile(densities, TRIMMED_SHARE))
        return mesh

    return make


PEERS = {
    "Open3D Poisson depth 8": poisson(8),
    "Open3D Poisson depth 9": poisson(9),
}


def main():
    """Make the map and save it with its best time in seconds."""
    name, points_file, map_file = sys.argv[1:]
    scan = numpy.load(points_file)
    open3d = import_open3d()
    times = []
    while sum(times) < SECONDS:
        start = time.perf_counter()
        mesh = PEERS[name](open3d, scan["points"], scan["sensor"])
        times.append(time.perf_counter() - start)
    numpy.savez(map_file, seconds=min(times), points=numpy.asarray(mesh.vertices),
                triangles=numpy.asarray(mesh.triangles))


if __name__ == "__main__":
    main()
