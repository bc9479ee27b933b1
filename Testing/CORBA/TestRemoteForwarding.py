# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A server that forwards each call to itself keeps a source no longer than its time limit. A source
follows no forward to a Unix socket.
"""

import socket
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from raw_listener import Forwarder, make_profile, make_unix_component

_CLOSED_PORT = 1

_LOOK = """
import sys
from lms3d.remote import RemoteScanner

print(RemoteScanner(sys.argv[1]).returns)
"""


class RemoteForwardingTest(unittest.TestCase):
    """Calls without end, with one connection and with a new one each time."""

    def test_the_end_of_the_process(self):
        """It waits for the thread of the source."""
        for closes in (False, True):
            with self.subTest(closes=closes), Forwarder(closes) as server:
                start = time.monotonic()
                finished = subprocess.run(
                    [sys.executable, "-c", _LOOK,
                     f"corbaloc:iiop:1.0@127.0.0.1:{server.port}/LMS3D"],
                    capture_output=True, text=True, timeout=60, check=False)
                self.assertLess(time.monotonic() - start, 15)
                self.assertEqual(finished.returncode, 1)
                self.assertIn("nothing to show", finished.stderr)
                self.assertGreater(server.count, 1)

    def test_a_unix_socket(self):
        """The source does not connect to it."""
        path = str(Path(self.enterContext(tempfile.TemporaryDirectory()), "socket"))
        target = make_profile(b"127.0.0.1", _CLOSED_PORT, [make_unix_component(path)])
        with socket.socket(socket.AF_UNIX) as other, Forwarder(target=target) as server:
            other.bind(path)
            other.listen()
            other.settimeout(0)
            subprocess.run(
                [sys.executable, "-c", _LOOK,
                 f"corbaloc:iiop:1.0@127.0.0.1:{server.port}/LMS3D"],
                capture_output=True, text=True, timeout=60, check=False)
            self.assertGreater(server.count, 0)
            with self.assertRaises(BlockingIOError):
                other.accept()


if __name__ == "__main__":
    unittest.main()
