# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""ROS 2 bags: what robots' software would have recorded of a scan, or of a whole journey."""

import os
import shutil
import sqlite3
from contextlib import contextmanager
from pathlib import Path

import numpy as np

from .execution import ProgressBar
from .fans import SCAN_TIME, Fans
from .grid import Grid, quaternion
from .interruption import interruptible
from .pieces import BEAMS, slices
from .problems import Problem
from .results import BAG_ENDINGS, check_new, writing

_SECOND = 10**9  # nanoseconds
_MAXIMUM_TIME = 2**31 - 1  # seconds, in ROS 2's stamps
_POINT_SIZE = 12  # bytes: x, y, z in single precision
_MAXIMUM_SIZE = 2**32 - 1  # bytes in a message

# The frames: the scene, the sensor, and the plane of the fan on the turning platform.
_WORLD, _SENSOR, _LASER = "map", "sensor", "laser"


def is_bag(path):
    """Whether a path names a bag."""
    return Path(path).suffix.lower() in BAG_ENDINGS


class Bag:
    """A bag of all scans of a simulation: a folder.

    A context manager, which deletes what has not got its name. `times` are the scans' times.
    """

    def __init__(self, path, simulation, times=(0.0,)):
        self._path = Path(path).resolve()
        self._simulation = simulation
        self._folder = self._path.with_name(f".{self._path.name}.{os.getpid()}")
        self._bag = self._folder / self._path.stem
        self._next = 0  # nanoseconds: when the sensor is free for a scan
        self._writer = None
        self.delayed = 0  # scans that begin after the time of their pose
        check_new("bag", path)
        self._check(times)

    def _check(self, times):
        if not 0 <= min(times) <= max(times) <= _MAXIMUM_TIME:
            raise Problem(f"cannot write '{self._path}': a bag has times from 0 to "
                          f"{_MAXIMUM_TIME} s, not {min(times):g} to {max(times):g} s")
        if _POINT_SIZE * self._simulation.beams > _MAXIMUM_SIZE:
            raise Problem(f"cannot write '{self._path}': a message has room for "
                          f"{_MAXIMUM_SIZE // _POINT_SIZE:,} beams, not for "
                          f"{self._simulation.beams:,}")
        if self._path.suffix.lower() == ".db3" and any(mark in str(self._path) for mark in "?#%"):
            raise Problem(f"cannot write '{self._path}': the path of a .db3 must not contain ? # %")

    def __enter__(self):
        from rosbags.rosbag2 import StoragePlugin, Writer  # pylint: disable=import-outside-toplevel

        storage = {".db3": StoragePlugin.SQLITE3, ".mcap": StoragePlugin.MCAP}
        try:
            with self._writing():
                self._folder.mkdir()
                self._writer = Writer(self._bag, version=Writer.VERSION_LATEST,
                                      storage_plugin=storage[self._path.suffix.lower()])
                self._writer.open()
                self._messages = _Messages(self._writer)
        except BaseException:
            self.__exit__()
            raise
        return self

    def add(self, scan, time):
        """Write a scan whose first beam leaves at a time, or when the scan before it has ended."""
        begin = max(round(time * _SECOND), self._next)
        self.delayed += begin > round(time * _SECOND)
        grid = Grid(scan)
        fans = Fans(grid.alpha)
        with self._writing(), ProgressBar("writing") as bar:
            for turn, beta in enumerate(grid.beta):
                end = self._add_fan(grid, fans, turn, beta, begin)
                bar.show((turn + 1) / len(grid.beta))
            self._messages.write_cloud(end, grid)
        self._next = begin + round(fans.time(len(grid.beta)) * _SECOND)

    def _add_fan(self, grid, fans, turn, beta, begin):
        """A message for each turn of the mirror; returns the time of the last beam.

        The platform turns evenly from the first beam to the last, as readers interpolate it.
        """
        first = turn * len(grid.alpha)
        ranges = grid.ranges_of_beams(slice(first, first + len(grid.alpha)), self._missing)
        start = begin + round(fans.time(turn) * _SECOND)
        self._messages.write_pose(start, grid, beta)
        for part in fans.parts:
            self._messages.write_scan(start + round(part.delay * _SECOND), part,
                                      ranges[part.beams], self._simulation.sensor)
        end = start + round(fans.duration * _SECOND)
        self._messages.write_pose(end, grid, beta + grid.platform.turn_rate * fans.duration)
        return end

    @property
    def _missing(self):
        """The range without a return: infinite where it is certain that no surface is in range.

        A surface that is too dark or nearer than the minimum range, or a range that the device's
        errors brought to 0 or less, gives no return either. If there may be such beams, all have NaN.
        """
        seen = self._simulation.sensor.GetOutput().GetNumberOfPoints()
        is_certain = not self._simulation.may_lose_beams and seen == self._simulation.returns
        return np.inf if is_certain else np.nan

    def finish(self, files):
        """Give the complete bag to ResultFiles."""
        with self._writing():
            self._writer.close()
        self._writer = None
        files.add(self._bag, self._path)

    def __exit__(self, *_):
        with interruptible(lambda: None):
            writer, self._writer = self._writer, None
            try:
                if writer:
                    writer.abort()
            except (OSError, sqlite3.Error):
                pass  # the folder goes anyway
            finally:
                shutil.rmtree(self._folder, ignore_errors=True)

    @contextmanager
    def _writing(self):
        try:
            with writing(self._path):
                yield
        except sqlite3.Error as error:
            raise Problem(
                f"cannot write '{self._path}': {error}; the disk may be full") from error


class _Messages:
    """Writes the messages of a bag. Times are in nanoseconds."""

    def __init__(self, writer):
        from rosbags.typesys import Stores, get_typestore  # pylint: disable=import-outside-toplevel

        self._writer = writer
        self._store = get_typestore(Stores.ROS2_HUMBLE)
        self._connections = {
            topic: writer.add_connection(topic, kind, typestore=self._store)
            for topic, kind in (("/tf", "tf2_msgs/msg/TFMessage"),
                                ("/scan", "sensor_msgs/msg/LaserScan"),
                                ("/points", "sensor_msgs/msg/PointCloud2"))}

    def write_scan(self, time, part, ranges, sensor):
        """A LaserScan: the beams of one turn of the mirror."""
        low, high = np.radians(part.alpha[[0, -1]])
        self._write("/scan", time, self._make(
            "sensor_msgs/msg/LaserScan", header=self._header(time, _LASER), angle_min=low,
            angle_max=high, angle_increment=np.radians(part.step), time_increment=part.beam_time,
            scan_time=SCAN_TIME, range_min=sensor.GetMinimumRange(),
            range_max=sensor.GetMaximumRange(), ranges=ranges.astype(np.float32),
            intensities=np.empty(0, np.float32)))

    def write_pose(self, time, grid, beta):
        """A TFMessage: the sensor in the scene, and the plane of the fan on the sensor."""
        fan, mirror = grid.platform.get_fan(beta)
        self._write("/tf", time, self._make("tf2_msgs/msg/TFMessage", transforms=[
            self._transform(time, _WORLD, _SENSOR, grid.position, grid.quaternion),
            self._transform(time, _SENSOR, _LASER, mirror, quaternion(fan))]))

    def write_cloud(self, time, grid):
        """A PointCloud2: a row for each turn of the platform, NaN without a return."""
        points = np.empty((grid.beams, 3), "<f4")
        for beams in slices(grid.beams, BEAMS):
            points[beams] = grid.points_of_beams(beams, np.nan, True)
        fields = [self._make("sensor_msgs/msg/PointField", name=name, offset=4 * i, datatype=7,
                             count=1) for i, name in enumerate("xyz")]
        self._write("/points", time, self._make(
            "sensor_msgs/msg/PointCloud2", header=self._header(time, _SENSOR),
            height=len(grid.beta), width=len(grid.alpha), fields=fields, is_bigendian=False,
            point_step=_POINT_SIZE, row_step=_POINT_SIZE * len(grid.alpha),
            data=points.reshape(-1).view(np.uint8), is_dense=False))

    def _transform(self, time, parent, child, translation, rotation):
        x, y, z = map(float, translation)
        w, *axis = rotation
        return self._make(
            "geometry_msgs/msg/TransformStamped", header=self._header(time, parent),
            child_frame_id=child, transform=self._make(
                "geometry_msgs/msg/Transform",
                translation=self._make("geometry_msgs/msg/Vector3", x=x, y=y, z=z),
                rotation=self._make("geometry_msgs/msg/Quaternion", w=w, **dict(zip("xyz", axis)))))

    def _header(self, time, frame):
        seconds, nanoseconds = divmod(time, _SECOND)
        stamp = self._make("builtin_interfaces/msg/Time", sec=seconds, nanosec=nanoseconds)
        return self._make("std_msgs/msg/Header", stamp=stamp, frame_id=frame)

    def _make(self, kind, **fields):
        return self._store.types[kind](**fields)

    def _write(self, topic, time, message):
        self._writer.write(self._connections[topic], time,
                           self._store.serialize_cdr(message, message.__msgtype__))
