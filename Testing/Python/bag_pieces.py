# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads ROS 2 bags by two libraries, and looks up their transforms."""

from pathlib import Path

import numpy as np
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from command_line import POSE, ROOM, CommandLineTest, read
from scan_pieces import ScanWithMisses


def read_with_rosbags(path):
    """The messages of a bag in their order: triples of a topic, a time and a message."""
    from rosbags.highlevel import AnyReader

    with AnyReader([Path(path)]) as reader:
        return [(connection.topic, time, reader.deserialize(data, connection.msgtype))
                for connection, time, data in reader.messages()]


def read_with_mcap(path):
    """The same with a library that takes all from the file in the bag."""
    from mcap.reader import make_reader
    from mcap_ros2.decoder import DecoderFactory

    with open(next(Path(path).glob("*.mcap")), "rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        return [(channel.topic, record.log_time, message)
                for _, channel, record, message in reader.iter_decoded_messages()]


def stamp(header):
    """The time of a header in nanoseconds."""
    return header.stamp.sec * 10**9 + header.stamp.nanosec


def select(messages, topic):
    """The messages of a topic."""
    return [message for name, _, message in messages if name == topic]


def matrix(transform):
    """The 4 x 4 matrix of a geometry_msgs/Transform."""
    q, t = transform.rotation, transform.translation
    result = np.identity(4)
    result[:3, :3] = ScanWithMisses.rotate((q.w, q.x, q.y, q.z))
    result[:3, 3] = t.x, t.y, t.z
    return result


def cloud_points(cloud):
    """The coordinates of a PointCloud2: rows x columns x 3."""
    names = [(field.name, field.offset, field.datatype) for field in cloud.fields]
    assert names == [("x", 0, 7), ("y", 4, 7), ("z", 8, 7)] and not cloud.is_bigendian
    table = np.frombuffer(bytes(cloud.data), "<f4")
    return table.reshape(cloud.height, cloud.width, 3)


class BagTest(CommandLineTest):
    """Reads bags by all readers, which must agree, and looks up transforms."""

    def scanned(self, name, *arguments):
        """Scan to a bag and to a .vtp; the messages and the scan."""
        bag, path = self.folder / name, self.folder / f"{name}.vtp"
        if not bag.exists():
            self.done("scan", ROOM, *POSE, *arguments, "-o", bag)
            self.done("scan", ROOM, *POSE, *arguments, "-o", path)
        return read_with_rosbags(bag), read(vtkXMLPolyDataReader(), path)

    def pose_of_fan(self, messages, time):
        """The matrix from the fan's plane to the world; between two equal transforms only."""
        poses = select(messages, "/tf")
        times = [stamp(pose.transforms[0].header) for pose in poses]
        before = max(i for i, t in enumerate(times) if t <= time)
        after = min(i for i, t in enumerate(times) if t >= time)
        matrices = [self.chain(poses[i]) for i in (before, after)]
        np.testing.assert_array_equal(*matrices)
        return matrices[0]

    def chain(self, pose):
        """The matrix from the fan's plane to the world."""
        frames = [(each.header.frame_id, each.child_frame_id) for each in pose.transforms]
        self.assertEqual(frames, [("map", "sensor"), ("sensor", "laser")])
        world, turn = (matrix(each.transform) for each in pose.transforms)
        return world @ turn
