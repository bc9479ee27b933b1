# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Makes one map of many scans with Open3D: peers_fusers.py FUSER SCANS.npz STOPS MAP.npz.

SCANS.npz has the `points` of all scans, the index `firsts` of each scan's first point, the `sensors`,
and the scene's `corners` and `triangles`. STOPS are numbers of poses, as in "1,5,20"; after each of
them there is one map.
"""

import sys
import time

import numpy
from peers_casters import import_open3d
from peers_mappers import NEIGHBOURS, TRIMMED_SHARE

# Six square pictures of a pinhole camera see as much as a scan. 147 x 147 pixels are 129,654 beams,
# nearly as many as a scan has (361 x 360).
PIXELS = 147
DEPTH_LIMIT = 80.0  # metres, as of the scan
TRUNCATION = 4.0  # voxels
BLOCK = 16  # voxels along an edge, as in ScalableTSDFVolume
INITIAL_BLOCKS = 10000  # more are made as needed
# The columns are the camera's axes right, down and forward in the world.
FACES = tuple(numpy.array(face, dtype=float).T for face in (
    ((0, -1, 0), (0, 0, -1), (1, 0, 0)), ((0, 1, 0), (0, 0, -1), (-1, 0, 0)),
    ((1, 0, 0), (0, 0, -1), (0, 1, 0)), ((-1, 0, 0), (0, 0, -1), (0, -1, 0)),
    ((0, -1, 0), (1, 0, 0), (0, 0, 1)), ((0, -1, 0), (-1, 0, 0), (0, 0, -1))))


class Pictures:
    """Depth pictures of the scene, cast as exactly as single precision can."""

    def __init__(self, open3d, scans):
        self._open3d = open3d
        self._caster = open3d.t.geometry.RaycastingScene()
        self._caster.add_triangles(scans["corners"].astype(numpy.float32),
                                   scans["triangles"].astype(numpy.uint32))
        half = PIXELS / 2
        # Open3D rounds the place of a voxel in a picture down to a pixel, so a pixel's ray has to be in
        # the middle of the pixel's square.
        self.camera = open3d.core.Tensor(numpy.array(((half, 0, half), (0, half, half), (0, 0, 1))))
        columns, rows = numpy.meshgrid(numpy.arange(PIXELS), numpy.arange(PIXELS))
        # The depth along the camera's axis is the length along such a ray.
        self._rays = numpy.stack([(columns - half + 0.5) / half, (rows - half + 0.5) / half,
                                  numpy.ones((PIXELS, PIXELS))], axis=-1)

    def take(self, sensor):
        """Return pairs of a picture and the world in the camera's frame."""
        tensor = self._open3d.core.Tensor
        for axes in FACES:
            rays = numpy.concatenate([numpy.broadcast_to(sensor, self._rays.shape),
                                      self._rays @ axes.T], axis=-1).astype(numpy.float32)
            depth = self._caster.cast_rays(tensor(rays))["t_hit"].numpy()
            depth = numpy.where(numpy.isfinite(depth), depth, 0).astype(numpy.float32)
            frame = numpy.eye(4)
            frame[:3, :3] = axes.T
            frame[:3, 3] = -axes.T @ sensor
            yield self._open3d.t.geometry.Image(tensor(depth)), tensor(frame)


class Volume:
    """Open3D's VoxelBlockGrid with voxels of an edge length, metres."""

    def __init__(self, open3d, scans, length):
        self._scans = scans
        self._pictures = Pictures(open3d, scans)
        core = open3d.core
        self._grid = open3d.t.geometry.VoxelBlockGrid(
            ("tsdf", "weight"), (core.float32, core.float32), ((1,), (1,)), voxel_size=length,
            block_resolution=BLOCK, block_count=INITIAL_BLOCKS, device=core.Device("CPU:0"))

    def add(self, pose):
        """Integrate what is seen from a pose; return the seconds, which exclude the pictures."""
        pictures = list(self._pictures.take(self._scans["sensors"][pose]))
        camera = self._pictures.camera
        start = time.perf_counter()
        for depth, frame in pictures:
            blocks = self._grid.compute_unique_block_coordinates(
                depth, camera, frame, depth_scale=1.0, depth_max=DEPTH_LIMIT,
                trunc_voxel_multiplier=TRUNCATION)
            self._grid.integrate(blocks, depth, camera, frame, depth_scale=1.0,
                                 depth_max=DEPTH_LIMIT, trunc_voxel_multiplier=TRUNCATION)
        return time.perf_counter() - start

    def make(self):
        """Return the map, of all voxels that were seen."""
        return self._grid.extract_triangle_mesh(weight_threshold=0.0).to_legacy()


class ScalableVolume:
    """Open3D's ScalableTSDFVolume with voxels of an edge length, metres."""

    def __init__(self, open3d, scans, length):
        self._open3d, self._scans = open3d, scans
        self._pictures = Pictures(open3d, scans)
        kinds = open3d.pipelines.integration
        self._volume = kinds.ScalableTSDFVolume(
            voxel_length=length, sdf_trunc=TRUNCATION * length, depth_sampling_stride=1,
            color_type=kinds.TSDFVolumeColorType.NoColor)

    def add(self, pose):
        """Integrate what is seen from a pose; return the seconds, which exclude the pictures."""
        focus, middle = PIXELS / 2, (PIXELS - 1) / 2
        camera = self._open3d.camera.PinholeCameraIntrinsic(
            PIXELS, PIXELS, focus, focus, middle, middle)
        pictures = [(self._make_image(depth), frame.numpy())
                    for depth, frame in self._pictures.take(self._scans["sensors"][pose])]
        start = time.perf_counter()
        for image, frame in pictures:
            self._volume.integrate(image, camera, frame)
        return time.perf_counter() - start

    def _make_image(self, depth):
        image = self._open3d.geometry.RGBDImage()
        image.depth = depth.to_legacy()
        image.color = image.depth
        return image

    def make(self):
        """Return the map."""
        return self._volume.extract_triangle_mesh()


class Poisson:
    """Open3D's Poisson reconstruction of the joined returns, in an octree of a depth."""

    def __init__(self, open3d, scans, depth):
        self._open3d, self._scans, self._depth = open3d, scans, depth
        self._cloud = open3d.geometry.PointCloud()

    def add(self, pose):
        """Add the returns from a pose, with their normals; return the seconds."""
        start = time.perf_counter()
        firsts = self._scans["firsts"]
        points = self._scans["points"][firsts[pose]:firsts[pose + 1]]
        cloud = self._open3d.geometry.PointCloud(self._open3d.utility.Vector3dVector(points))
        cloud.estimate_normals(self._open3d.geometry.KDTreeSearchParamKNN(NEIGHBOURS))
        cloud.orient_normals_towards_camera_location(self._scans["sensors"][pose])
        self._cloud += cloud
        return time.perf_counter() - start

    def make(self):
        """Return the map."""
        mesh, densities = self._open3d.geometry.TriangleMesh.create_from_point_cloud_poisson(
            self._cloud, depth=self._depth)
        densities = numpy.asarray(densities)
        mesh.remove_vertices_by_mask(densities < numpy.quantile(densities, TRIMMED_SHARE))
        return mesh


# By their names in the table.
FUSERS = {
    "Open3D ScalableTSDFVolume 20 mm": (ScalableVolume, 0.02),
    **{f"Open3D VoxelBlockGrid {1000 * length:g} mm": (Volume, length)
       for length in (0.04, 0.02, 0.01)},
    **{f"Open3D Poisson depth {depth}": (Poisson, depth) for depth in (9, 10)}}


def main(name, scans_file, stops, map_file):
    """Make the maps; save them, the mean seconds for adding a pose, and the seconds for each map."""
    scans = dict(numpy.load(scans_file))
    open3d = import_open3d()
    kind, parameter = FUSERS[name]
    fuser = kind(open3d, scans, parameter)
    result, done = {}, 0
    for stop in map(int, stops.split(",")):
        seconds = [fuser.add(pose) for pose in range(done, stop)]
        start = time.perf_counter()
        mesh = fuser.make()
        result[f"make{stop}"] = time.perf_counter() - start
        result[f"add{stop}"] = numpy.mean(seconds)
        result[f"points{stop}"] = numpy.asarray(mesh.vertices)
        result[f"triangles{stop}"] = numpy.asarray(mesh.triangles)
        done = stop
        # If a later map takes too long, the earlier ones stay.
        numpy.savez(map_file, **result)


if __name__ == "__main__":
    main(*sys.argv[1:])
