# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Clients that send garbage, half a message or nothing, stall or vanish do not disturb others."""

import contextlib
import os
import random
import select
import signal
import socket
import struct
import subprocess
import time
import unittest

import giop
from raw_messages import LONG_ARGUMENTS, write_wait
from server_process import BEAMS, CLIENT, Server, allow_many_files, wait_until

CONNECTIONS = 1000
# In MiB. Sanitizers need memory for each thread and keep freed memory.
MAXIMUM_GROWTH = int(os.environ.get("LMS3D_MAXIMUM_GROWTH_MIB", "64")) << 20

_header = giop.message(giop.REQUEST, b"")[:8]
_fetch = giop.request(b"LMS3D", "fetch")
HALF_MESSAGES = (
    b"GIOP", _header, _header + struct.pack("<I", 0x7FFFFFFF), _header + struct.pack("<I", 33 << 20),
    _fetch[:20], _fetch[:-1], giop.message(giop.REQUEST, b"")[:7] + b"\x02" + struct.pack("<I", 64))


def garbage(number):
    """The same bytes for each number."""
    generator = random.Random(number)
    kinds = (generator.randbytes(generator.randrange(1, 3000)), b"GET / HTTP/1.1\r\n\r\n",
             b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + generator.randbytes(500),
             b"GIOP" + generator.randbytes(200), _fetch[:12] + generator.randbytes(len(_fetch) - 12))
    return kinds[number % len(kinds)]


def refuse(client, operation, arguments):
    """The exception of a call. Empty if it succeeds."""
    try:
        client.call(operation, arguments)
        return ""
    except (giop.UserException, giop.SystemException) as problem:
        return str(problem)


class HostileTest(unittest.TestCase):
    """A server for each test, and a client that must be served in spite of the others."""

    @classmethod
    def setUpClass(cls):
        allow_many_files()

    def setUp(self):
        self.server = self.enterContext(Server())
        self.files = self.server.count_files()
        self.memory = self.server.measure_memory()

    def check_service(self, seconds=10):
        """A new client gets a complete scan."""
        start = time.monotonic()
        with self.server.connect() as client:
            self.assertEqual(len(client.fetch()), 3 * BEAMS)
        self.assertLess(time.monotonic() - start, seconds)

    def check_recovery(self):
        """Connections are closed, memory is freed, and the server ends properly."""
        self.assertTrue(wait_until(lambda: self.server.count_files() <= self.files + 2))
        self.check_service()
        self.assertLess(self.server.measure_memory() - self.memory, MAXIMUM_GROWTH)
        self.assertEqual(self.server.stop()[0], 0)

    def connect_all(self, data_of):
        """A thousand connections that have sent their bytes."""
        stack = self.enterContext(contextlib.ExitStack())
        host, port, _ = giop.parse_corbaloc(self.server.corbaloc)
        for number in range(CONNECTIONS):
            connection = stack.enter_context(socket.create_connection((host, port), 20))
            # The server may have closed the connection already.
            with contextlib.suppress(ConnectionError):
                connection.sendall(data_of(number))
        return stack

    def test_thousand_that_send_garbage(self):
        """Random bytes, other protocols, corrupted requests."""
        with self.connect_all(garbage):
            self.check_service()
        self.check_recovery()
        self.assertIn("lines are left out", self.server.read_log())

    def test_thousand_that_send_half_a_message(self):
        """Truncated headers, and headers that announce up to 2 GB."""
        with self.connect_all(lambda number: HALF_MESSAGES[number % len(HALF_MESSAGES)]):
            self.check_service()
        self.check_recovery()

    def test_thousand_that_send_nothing(self):
        """Idle connections cost a thread each, and little memory."""
        with self.connect_all(lambda _: b""):
            self.check_service()
            self.assertLess(self.server.measure_memory() - self.memory, MAXIMUM_GROWTH)
        self.check_recovery()

    def test_half_an_argument_of_two_megabytes(self):
        """Without the gate, the ORB would allocate memory for it and never free it."""
        for _ in range(5):
            with contextlib.ExitStack() as stack:
                for number in range(40):
                    client = stack.enter_context(self.server.connect())
                    client.connection.sendall(LONG_ARGUMENTS[number % len(LONG_ARGUMENTS)][:-1])
                self.check_service()
            self.assertTrue(wait_until(lambda: self.server.count_files() <= self.files + 2))
        self.check_recovery()

    def test_clients_that_vanish_while_they_wait(self):
        """Too many waiting calls. When their clients vanish, others get their places soon."""
        never = 2 ** 64 - 1
        clients, maximum = 40, 32
        with contextlib.ExitStack() as stack:
            sockets = []
            for _ in range(clients):
                client = stack.enter_context(self.server.connect())
                client.connection.sendall(
                    giop.request(client.key, "waitForScan", start_arguments=write_wait(never, 10000)))
                sockets.append(client.connection)
            # Refused calls are answered at once.
            self.assertTrue(wait_until(
                lambda: len(select.select(sockets, [], [], 0)[0]) == clients - maximum))
            with self.server.connect() as client:
                self.assertIn("LimitExceeded", refuse(client, "waitForScan", write_wait(never, 1)))
        start = time.monotonic()
        with self.server.connect() as client:
            self.assertTrue(wait_until(
                lambda: "NoScanYet" in refuse(client, "waitForScan", write_wait(never, 1))))
        self.assertLess(time.monotonic() - start, 7)
        self.check_recovery()

    def test_four_hundred_flipped_bits(self):
        """A valid request with one wrong bit at a time."""
        for bit in range(0, 400):
            data = bytearray(_fetch)
            data[bit // 8 % len(data)] ^= 1 << bit % 8
            with self.server.connect() as client:
                client.connection.settimeout(0.05)
                client.connection.sendall(data)
                with contextlib.suppress(OSError, giop.SystemException, struct.error):
                    client.read_reply()
        self.check_service()
        self.check_recovery()

    def test_clients_that_vanish_in_mid_call(self):
        """Three hundred clients that reset the connection before or during the answer."""
        for number in range(300):
            with self.server.connect() as client:
                client.connection.sendall(_fetch)
                if number % 2:
                    client.connection.recv(1000)
                client.connection.setsockopt(
                    socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        self.check_service()
        self.check_recovery()

    def test_clients_that_are_killed_in_mid_call(self):
        """Real clients that wait for a scan are killed."""
        watching = [subprocess.Popen([CLIENT, self.server.reference, "watch"],
                                     stdout=subprocess.DEVNULL) for _ in range(20)]
        time.sleep(1)
        for process in watching:
            process.send_signal(signal.SIGKILL)
            process.wait()
        self.check_service()
        self.check_recovery()


class StallTest(unittest.TestCase):
    """The server closes stuck connections after the period that the administrator sets, here two
    seconds."""

    def test_clients_that_do_not_read(self):
        """Clients that send forty requests and read nothing occupy few threads and do not delay the end."""
        with contextlib.ExitStack() as stack:
            server = stack.enter_context(Server())
            for _ in range(8):
                client = stack.enter_context(server.connect())
                client.connection.sendall(_fetch * 40)
            time.sleep(1)
            with server.connect() as client:
                self.assertEqual(len(client.fetch()), 3 * BEAMS)
            self.assertLess(server.count_threads(), 60)
            code, seconds = server.stop()
        self.assertEqual(code, 0)
        self.assertLess(seconds, 8)

    def test_half_a_message_times_out(self):
        """An incomplete request is no call yet, so another period applies."""
        with Server("-ORBinConScanPeriod", "2", "-ORBscanGranularity", "1") as server:
            with server.connect() as client:
                client.connection.sendall(_fetch[:-1])
                start = time.monotonic()
                with contextlib.suppress(ConnectionResetError):
                    while client.connection.recv(1000):
                        pass
                self.assertLess(time.monotonic() - start, 15)


if __name__ == "__main__":
    unittest.main()
