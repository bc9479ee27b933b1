# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The bytes that the server sends, read without an ORB."""

import struct
import unittest
import zlib

import giop
from raw_messages import write_configuration, write_device
from server_process import BEAMS, Server


def read_header(reply):
    """The fields of LMS3D::ScanHeader that the tests need, in the order of the IDL."""
    header = dict(zip(("number", "incarnation", "generation", "start", "end"), reply.numbers("Q", 5)))
    header["scene"] = reply.string()
    header["pose"] = reply.numbers("d", 6)
    for axis in ("alpha", "beta"):
        start, stop = reply.numbers("d", 2)
        header[axis] = start, stop, reply.number("I")
    header["limits"] = reply.numbers("d", 2)
    header["method"] = reply.number("I")
    header["makeMap"] = reply.number("B")
    header["mapError"] = reply.number("d")
    names = "beams", "returns", "mapPoints", "mapTriangles", "rangesChecksum", "mapChecksum"
    header.update(zip(names, reply.numbers("I", 6)))
    return header


def read_device(reply):
    """The fields of LMS3D::Device."""
    device = dict(zip(("bias", "noise", "resolution"), reply.numbers("d", 3)))
    device["seed"] = reply.number("i")
    device["beam"] = reply.numbers("d", 2)
    device["samples"] = reply.number("I")
    device["pulse"], device["tenPercent"] = reply.numbers("d", 2)
    device["array"] = reply.string()
    device["mounting"] = reply.number("I")
    device["offset"], device["rate"] = reply.numbers("d", 3), reply.number("d")
    device["status"] = reply.number("B")
    return device


IDEAL = {"bias": 0, "noise": 0, "resolution": 0, "seed": 0, "beam": (0, 0), "samples": 1, "pulse": 1,
         "tenPercent": 0, "array": "", "mounting": 0, "offset": (0, 0, 0), "rate": 0, "status": 0}


class WireTest(unittest.TestCase):
    """One server for all."""

    @classmethod
    def setUpClass(cls):
        # Enough scans that none is dropped during a test, even on a busy machine.
        cls.server = cls.enterClassContext(Server("--keep", "100"))

    def test_fetch(self):
        """Range, elevation and turn of each beam, turn by turn, in metres and degrees."""
        with self.server.connect() as client:
            values = client.fetch()
        self.assertEqual(len(values), 3 * BEAMS)
        self.assertEqual(values[1::3], tuple(0.5 * i - 90 for i in range(361)) * 360)
        self.assertEqual(values[2::3], tuple(float(i // 361) for i in range(BEAMS)))
        # The sensor is 1 m above the room's floor and 3.7 m from the wall that it looks at.
        self.assertEqual(values[0], 1.0)
        self.assertAlmostEqual(values[3 * 180], 3.7, 6)
        self.assertTrue(all(0 < r < 20 for r in values[::3]))

    def test_header_and_checksum(self):
        """The checksum is zlib's, of the ranges as they come."""
        with self.server.connect() as client:
            header = read_header(client.call("getHeader"))
            ranges = client.fetch()[::3]
        self.assertEqual(header["scene"], "room.wrl")
        self.assertEqual(header["pose"], (0.3, -0.2, 1, 0, 0, 0))
        self.assertEqual(header["alpha"], (-90, 90, 361))
        self.assertEqual(header["beta"], (0, 360, 360))
        self.assertEqual((header["limits"], header["mapError"]), ((0, 80), 0.01))
        self.assertEqual((header["beams"], header["returns"]), (BEAMS, BEAMS))
        self.assertEqual(zlib.crc32(struct.pack(f"<{BEAMS}f", *ranges)), header["rangesChecksum"])

    def test_map(self):
        """The map's checksum covers points, then triangles."""
        with self.server.connect() as client:
            header = read_header(client.call("getHeader"))

            def everything(count):
                return lambda e: e.number("Q", header["number"]).number("I", 0).number("I", count)

            points = client.call("getMapPoints", everything(header["mapPoints"]))
            coordinates = points.numbers("d", points.number("I"))
            triangles = client.call("getMapTriangles", everything(header["mapTriangles"]))
            corners = triangles.numbers("I", triangles.number("I"))
        self.assertEqual(len(coordinates), 3 * header["mapPoints"])
        self.assertEqual(len(corners), 3 * header["mapTriangles"])
        self.assertLess(max(corners), header["mapPoints"])
        checksum = zlib.crc32(struct.pack(f"<{len(coordinates)}d", *coordinates))
        checksum = zlib.crc32(struct.pack(f"<{len(corners)}I", *corners), checksum)
        self.assertEqual(checksum, header["mapChecksum"])
        self.check_facing(coordinates, corners, header["pose"][:3])

    def test_whole_map(self):
        """One call: the header, then points, then triangles."""
        with self.server.connect() as client:
            reply = client.call("getMap")
            header = read_header(reply)
            coordinates = reply.numbers("d", reply.number("I"))
            corners = reply.numbers("I", reply.number("I"))
        self.assertEqual(len(coordinates), 3 * header["mapPoints"])
        self.assertEqual(len(corners), 3 * header["mapTriangles"])
        checksum = zlib.crc32(struct.pack(f"<{len(coordinates)}d", *coordinates))
        checksum = zlib.crc32(struct.pack(f"<{len(corners)}I", *corners), checksum)
        self.assertEqual(checksum, header["mapChecksum"])

    def test_presets(self):
        """Their names, and the values of an LMS 200."""
        with self.server.connect() as client:
            names = client.call("listPresets")
            self.assertEqual([names.string() for _ in range(names.number("I"))],
                             ["ideal", "lms200-mm", "lms200-cm", "lms291"])
            reply = client.call("getPreset", lambda e: e.string(b"lms200-mm"))
            self.assertEqual(read_device(reply), {
                **IDEAL, "noise": 0.005, "resolution": 0.001, "beam": (0.012, 0.0044), "samples": 7,
                "tenPercent": 10})
            self.assertEqual(reply.number("d"), 8)

    def test_an_operation_of_a_newer_interface(self):
        """Its client gets the exception that LMS3DScanner.idl names, and can go on."""
        with self.server.connect() as client:
            with self.assertRaisesRegex(giop.SystemException, "BAD_OPERATION"):
                client.call("getSomethingNewer")
            self.assertEqual(client.call("getScene").string(), "room.wrl")

    def check_facing(self, coordinates, corners, sensor):
        """Seen from the sensor, corners turn counter-clockwise; slivers of no area aside."""
        points = [[coordinates[i + k] - sensor[k] for k in range(3)]
                  for i in range(0, len(coordinates), 3)]
        for i in range(0, len(corners), 3):
            a, b, c = (points[corner] for corner in corners[i:i + 3])
            volume = (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                      + a[2] * (b[0] * c[1] - b[1] * c[0]))
            self.assertLess(volume, 1e-9)


class DeviceTest(unittest.TestCase):
    """A server of its own, since the device changes."""

    def test_device(self):
        """It is set, belongs to its scan, and gives each beam a status."""
        with Server("--keep", "100") as server, server.connect() as client:
            self.assertEqual(read_device(client.call("getDevice")), IDEAL)
            client.call("setConfiguration", write_configuration)
            generation = client.call("setDevice", lambda e: write_device(
                e, noise=0.25, status=1)).number("Q")
            header = read_header(client.call("waitForScan", lambda e: e.number("Q", 0).number(
                "Q", generation).number("I", 10000)))
            number = header["number"]
            device = read_device(client.call("getScanDevice", lambda e: e.number("Q", number)))
            self.assertEqual(device, {**IDEAL, "noise": 0.25, "status": 1})
            statuses = client.call("getBeamStatuses", lambda e: e.number("Q", number).number(
                "I", 5).number("I", 20)).octets()
            self.assertEqual(statuses, bytes(20))
            self.assertEqual((header["beams"], header["returns"]), (25, 25))


if __name__ == "__main__":
    unittest.main()
