# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A log or an output that is not read, as at the end of a stopped pipe, blocks neither the server's
work nor its end. What clients cause has a limit."""

import collections
import contextlib
import fcntl
import itertools
import os
import re
import select
import signal
import socket
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import giop
from raw_messages import write_configuration
from server_process import DATA, SERVER, Server, wait_until

# Seconds until the server ends.
MAXIMUM_SECONDS = 8
# Per second, of one kind.
MAXIMUM_LINES = 20
PIPE_BYTES = 4096

TRIANGLE = """#VRML V2.0 utf8
Shape {{
  geometry IndexedFaceSet {{
    coord Coordinate {{ point [ {0} 0 0, {0} 1 0, {0} 0 1 ] }}
    coordIndex [ 0 1 2 ]
  }}
}}
"""
# The scanner skips triangles beyond 1e18 m.
TOO_FAR = "1e19"


class FullPipe:
    """A pipe that takes no more."""

    def __init__(self):
        self.reader, self.writer = os.pipe()
        fcntl.fcntl(self.writer, fcntl.F_SETPIPE_SZ, PIPE_BYTES)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.reader)
        os.close(self.writer)

    def fill(self):
        """Opened again, because the server shares the flags of the end that it has."""
        end = os.open(f"/proc/self/fd/{self.writer}", os.O_WRONLY | os.O_NONBLOCK)
        with contextlib.suppress(BlockingIOError):
            while True:
                os.write(end, b".")
        os.close(end)

    def read(self, words, seconds=60):
        """Everything until the words."""
        text = b""
        end = time.monotonic() + seconds
        while words not in text and time.monotonic() < end:
            if select.select([self.reader], [], [], 0.1)[0]:
                text += os.read(self.reader, 65536)
        return text.decode()


def select_scene(client, name=b"room.wrl"):
    """The generation."""
    return client.call("selectScene", lambda e: e.string(name)).number("Q")


class BlockedTest(unittest.TestCase):
    """A server whose log or output is a full pipe."""

    def setUp(self):
        self.reference = Path(self.enterContext(tempfile.TemporaryDirectory()), "scanner.ior")
        self.pipe = self.enterContext(FullPipe())

    def start(self, **streams):
        """The process, when it is ready."""
        process = subprocess.Popen(
            [SERVER, "--scenes", DATA, "--scene", "room.wrl", "--threads", "1", "--ior",
             self.reference, "--rate", "1"], **streams)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        self.assertTrue(wait_until(self.reference.exists))
        return process

    def connect(self):
        """A client without an ORB."""
        return giop.Client(self.reference.read_text().strip())

    def check_end(self, process):
        """SIGTERM ends the server in time."""
        start = time.monotonic()
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(60), 0)
        self.assertLess(time.monotonic() - start, MAXIMUM_SECONDS)
        self.assertFalse(self.reference.exists())

    def test_a_log_that_is_not_read(self):
        """Clients are served."""
        self.pipe.fill()
        process = self.start(stdout=subprocess.DEVNULL, stderr=self.pipe.writer)
        with self.connect() as client:
            generations = [select_scene(client) for _ in range(100)]
        self.assertEqual(generations, sorted(set(generations)))
        self.check_end(process)

    def test_a_log_that_is_read_late(self):
        """The lines come then."""
        self.pipe.fill()
        process = self.start(stdout=subprocess.DEVNULL, stderr=self.pipe.writer)
        with self.connect() as client:
            select_scene(client)
            self.assertIn("a client selected the scene room.wrl",
                          self.pipe.read(b"selected the scene"))
        self.check_end(process)
        self.assertIn("ended", self.pipe.read(b"Z ended"))

    def test_an_output_that_is_not_read(self):
        """The reference is in the file, too."""
        self.pipe.fill()
        process = self.start(stdout=self.pipe.writer, stderr=subprocess.DEVNULL)
        with self.connect() as client:
            select_scene(client)
        self.check_end(process)


def get_problem(client):
    """Why the server makes no scans."""
    status = client.call("getStatus")
    status.string()
    for code in "QQQdQddBBII":
        status.number(code)
    return status.string()


class LimitTest(unittest.TestCase):
    """What clients cause."""

    def check_limit(self, log, kind, words, total):
        """The log has some of the lines per second, and the number of the others."""
        lines = re.findall(rf"^(.*)\.\d{{3}}Z (?:{words})", log, re.MULTILINE)
        left_out = sum(map(int, re.findall(rf"{kind}: (\d+) lines were left out", log)))
        self.assertEqual(len(lines) + left_out, total)
        self.assertGreater(left_out, 0)
        # The seconds of the limit begin at any time.
        self.assertLessEqual(max(collections.Counter(lines).values()), 2 * MAXIMUM_LINES)

    def test_selections_of_scenes(self):
        """The log has some per second, and the number of the others."""
        total = 150
        with Server("--rate", "1", "--no-map") as server:
            with server.connect() as client:
                for _ in range(total):
                    select_scene(client)
            self.assertEqual(server.stop()[0], 0)
            self.check_limit(server.read_log(), "scenes", "a client selected the scene", total)

    def test_broken_messages(self):
        """The same for the ORB's lines."""
        total = 150
        request = giop.request(b"LMS3D", "fetch")
        broken = request[:12] + b"\xff" * (len(request) - 12)
        with Server("--rate", "1", "--no-map") as server:
            host, port, _ = giop.parse_corbaloc(server.corbaloc)
            for _ in range(total):
                with socket.create_connection((host, port), 20) as connection:
                    connection.sendall(broken)
                    self.assertEqual(connection.recv(4), b"GIOP")
            self.assertEqual(server.stop()[0], 0)
            self.check_limit(server.read_log(), "omniORB", r"omniORB: \(\d+\) To endpoint", total)

    def test_problems_that_come_and_go(self):
        """A client selects a scene that can be scanned and one that cannot, in turn."""
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        (folder / "near.wrl").write_text(TRIANGLE.format(1))
        (folder / "far.wrl").write_text(TRIANGLE.format(TOO_FAR))
        with Server("--scenes", folder, "--scene", "near.wrl", "--rate", "1") as server:
            with server.connect() as client:
                client.call("setConfiguration", write_configuration)
                total = self.alternate(server, client)
            self.assertEqual(server.stop()[0], 0)
            self.check_limit(server.read_log(), "scans", "no scan: |scanning again", total)

    def alternate(self, server, client):
        """The number of changes until the log leaves out lines."""
        end = time.monotonic() + 60
        for total, scene in enumerate(itertools.cycle((b"far.wrl", b"near.wrl")), 1):
            select_scene(client, scene)
            self.assertTrue(wait_until(
                lambda has=scene == b"far.wrl": bool(get_problem(client)) == has, pause=0))
            if "scans: more lines in this second" in server.read_log():
                return total
            self.assertLess(time.monotonic(), end, "no line is left out")


if __name__ == "__main__":
    unittest.main()
