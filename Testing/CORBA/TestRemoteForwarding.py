# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A server that forwards each call to itself keeps a source no longer than its time limit."""

import subprocess
import sys
import time
import unittest

from raw_listener import Forwarder

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


if __name__ == "__main__":
    unittest.main()
