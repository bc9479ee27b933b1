# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Fragments and cancellations of requests disturb neither the server nor other clients."""

import contextlib
import struct
import unittest

import giop
from raw_messages import CANCEL_REQUEST, FRAGMENT, LONG_ARGUMENTS, part, write_wait
from server_process import BEAMS, Server

IN_FRAGMENTS = LONG_ARGUMENTS[1]
# For crashes that depend on the time at which threads run.
ATTEMPTS = 100
# Bytes, more than the server needs for anything else.
LONG = 50000000
# The number that omniORB assigns to calls before it has read theirs.
NO_NUMBER = 0xFFFFFFFF


def read_answer(client):
    """The bytes of a reply in any version of GIOP."""
    header = giop.receive(client.connection, 12)
    return header + giop.receive(client.connection, struct.unpack("<I", header[8:])[0])


class FragmentTest(unittest.TestCase):
    """Messages about a request whose number another call has, or none."""

    @classmethod
    def setUpClass(cls):
        cls.server = cls.enterClassContext(Server("--rate", "1"))

    def tearDown(self):
        """The server still answers others."""
        with self.server.connect() as client:
            self.assertEqual(len(client.fetch()), 3 * BEAMS)

    def send_during_a_wait(self, *messages):
        """A connection whose call 1 waits for a scan while the messages arrive."""
        client = self.enterContext(self.server.connect())
        waiting = giop.request(client.key, "waitForScan",
                               start_arguments=write_wait(2 ** 64 - 1, 200))
        for message in (waiting, *messages):
            client.connection.sendall(message)
        return client

    def test_requests_in_fragments_one_after_the_other(self):
        """Each gets its answer, also if both have the same number."""
        for _ in range(ATTEMPTS):
            with self.server.connect() as client:
                for _ in range(2):
                    client.connection.sendall(IN_FRAGMENTS)
                    self.assertIn(b"IMP_LIMIT", read_answer(client))

    def test_a_request_in_fragments_with_the_number_of_another_call(self):
        """Both get their answers."""
        for _ in range(3):
            client = self.send_during_a_wait(IN_FRAGMENTS)
            answers = (read_answer(client), read_answer(client))
            self.assertEqual(sum(b"IMP_LIMIT" in answer for answer in answers), 1)

    def test_messages_about_a_call_in_progress(self):
        """They are skipped, so the call and the next one on its connection get their answers."""
        for kind, body in ((FRAGMENT, b""), (FRAGMENT, b"x" * 100000), (CANCEL_REQUEST, b"")):
            for number in (1, 2, NO_NUMBER):
                with self.subTest(kind=kind, size=len(body), number=number):
                    messages = [part(kind, number, body, order=order) for order in "<>"]
                    client = self.send_during_a_wait(*messages * 10)
                    with self.assertRaisesRegex(giop.UserException, "NoScanYet"):
                        client.read_reply()
                    self.assertEqual(len(client.fetch()), 3 * BEAMS)

    def test_messages_that_arrive_in_pieces(self):
        """Skipped messages and requests, in pieces and many at once, keep their order."""
        with self.server.connect() as client:
            request = giop.request(client.key, "getStatus")
            for size in (1, 11, 17, 5000):
                data = (3 * part(CANCEL_REQUEST, 1) + request + part(FRAGMENT, 1, b"x" * 9000)
                        + part(FRAGMENT, 1) + request)
                for start in range(0, len(data), size):
                    client.connection.sendall(data[start:start + size])
                for _ in range(2):
                    client.read_reply()

    def test_requests_that_arrive_during_a_request_in_fragments(self):
        """The server does not keep them."""
        before = self.server.measure_memory()
        for _ in range(5):
            with self.server.connect() as client:
                with contextlib.suppress(OSError):
                    client.connection.sendall(part(giop.REQUEST, 1, is_last=False))
                    client.connection.sendall(part(giop.REQUEST, 2, bytes(LONG)))
                self.assertLess(self.server.measure_memory() - before, 0.8 * LONG)


if __name__ == "__main__":
    unittest.main()
