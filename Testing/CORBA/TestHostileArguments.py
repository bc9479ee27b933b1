# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Requests with invalid arguments are refused, and disturb neither the server nor other clients."""

import struct
import unittest

import giop
from raw_messages import LONG_ARGUMENTS, write_configuration, write_device, write_wait
from server_process import BEAMS, Server


class ArgumentTest(unittest.TestCase):
    """Valid messages with invalid contents."""

    @classmethod
    def setUpClass(cls):
        cls.server = cls.enterClassContext(Server("--fused-map", "0.02"))

    def fail_with(self, exception, name, operation, arguments):
        """The call fails as expected, and the next one works."""
        with self.server.connect() as client:
            with self.assertRaisesRegex(exception, name):
                client.call(operation, arguments)
        with self.server.connect() as client:
            self.assertEqual(len(client.fetch()), 3 * BEAMS)

    def test_names_of_scenes(self):
        """Paths, and strings whose real or announced length exceeds the IDL's bound."""
        for name in (b"../room.wrl", b"/etc/passwd", b"..", b"room.wrl\n", b"%2e%2e/room.wrl"):
            self.fail_with(giop.UserException, "NoSuchScene", "selectScene",
                           lambda e, name=name: e.string(name))
        self.fail_with(giop.SystemException, "MARSHAL|BAD_PARAM", "selectScene",
                       lambda e: e.string(b"x" * 129))
        self.fail_with(giop.SystemException, "MARSHAL", "selectScene",
                       lambda e: e.number("I", 0xFFFFFFFF))

    def test_a_name_with_a_zero(self):
        """The ORB may decode it in any way, but it is not a path."""
        self.fail_with((giop.UserException, giop.SystemException), "NoSuchScene|MARSHAL|BAD_PARAM",
                       "selectScene", lambda e: e.string(b"room\0/../../etc/passwd"))

    def test_arguments_of_two_megabytes(self):
        """They are refused before they are read, also in fragments, and the connection stays."""
        with self.server.connect() as client:
            for message in LONG_ARGUMENTS:
                client.connection.sendall(message)
                header = giop.receive(client.connection, 12)
                size = struct.unpack("<I", header[8:])[0]
                self.assertIn(b"IMP_LIMIT", giop.receive(client.connection, size))
            self.assertEqual(len(client.fetch()), 3 * BEAMS)

    def test_a_fourth_wait_on_one_connection(self):
        """The call is refused, so that the server still notices the end of the connection."""
        with self.server.connect() as client:
            for number in range(4):
                client.connection.sendall(giop.request(
                    client.key, "waitForScan", start_arguments=write_wait(2 ** 64 - 1, 10000),
                    number=number))
            with self.assertRaisesRegex(giop.UserException, "LimitExceeded"):
                client.read_reply()

    def test_missing_arguments(self):
        """A truncated pose, and an operation that does not exist."""
        self.fail_with(giop.SystemException, "MARSHAL", "setPose", lambda e: e.number("d", 1.0))
        self.fail_with(giop.SystemException, "BAD_OPERATION", "format", None)

    def test_a_method_that_is_none(self):
        """A value beyond the end of an enumeration."""
        self.fail_with(giop.SystemException, "MARSHAL", "setConfiguration",
                       lambda e: write_configuration(e, method=99))

    def test_devices(self):
        """A mounting beyond the end of the enumeration, a name that is too long, a missing end."""
        self.fail_with(giop.SystemException, "MARSHAL", "setDevice",
                       lambda e: write_device(e, mounting=4))
        self.fail_with(giop.SystemException, "MARSHAL", "setDevice",
                       lambda e: write_device(e, array=b"x" * 129))
        self.fail_with(giop.SystemException, "MARSHAL", "setDevice", lambda e: e.number("d", 1.0))
        self.fail_with(giop.UserException, "NoSuchPreset", "selectPreset",
                       lambda e: e.string(b"../ideal"))
        self.fail_with(giop.SystemException, "MARSHAL|BAD_PARAM", "getPreset",
                       lambda e: e.string(b"x" * 65))

    def test_fused_maps(self):
        """States that are none, parts beyond the end, a missing end."""

        def write(encoder, number, since, first, count):
            for code, value in (("Q", number), ("Q", since), ("I", first), ("I", count)):
                encoder.number(code, value)

        for operation in ("getFusedRegions", "getFusedPoints", "getFusedTriangles"):
            for number in (0, 1, 2 ** 64 - 1):
                self.fail_with(giop.UserException, "FusedMapGone", operation,
                               lambda e, number=number: write(e, number, 0, 0, 1))
            self.fail_with(giop.SystemException, "MARSHAL", operation, lambda e: e.number("Q", 1))
        self.fail_with(giop.SystemException, "MARSHAL", "getFusedMap", lambda e: e.number("I", 1))
        with self.server.connect() as client:
            newest = client.call("getFusedMapHeader", lambda e: e.number("Q", 0)).numbers("Q", 1)[0]
        for since in (0, newest, 2 ** 64 - 1):
            self.fail_with(giop.UserException, "InvalidArgument", "getFusedPoints",
                           lambda e, since=since: write(e, newest, since, 2 ** 32 - 1, 2 ** 32 - 1))


if __name__ == "__main__":
    unittest.main()
