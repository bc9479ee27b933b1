# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A server that forwards each call to itself does not keep lms3d-client longer than its time limit."""

import subprocess
import time
import unittest

from raw_listener import Forwarder
from server_process import CLIENT


class ForwardingServerTest(unittest.TestCase):
    """Calls without end."""

    def run_client(self, server, *options):
        """The seconds until the client fails."""
        start = time.monotonic()
        finished = subprocess.run(
            [CLIENT, f"corbaloc:iiop:1.0@127.0.0.1:{server.port}/LMS3D", "status", *options],
            capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(finished.returncode, 1, finished.stderr)
        self.assertRegex(finished.stderr, r"^lms3d-client: \w+")
        self.assertGreater(server.count, 1)
        return time.monotonic() - start

    def test_the_time_limit(self):
        """15 seconds, as the guide says."""
        with Forwarder() as server:
            self.assertLess(self.run_client(server), 20)

    def test_new_connections(self):
        """They do not renew the time."""
        with Forwarder(closes=True) as server:
            self.assertLess(
                self.run_client(server, "-ORBclientCallTimeOutPeriod", "3000"), 10)


if __name__ == "__main__":
    unittest.main()
