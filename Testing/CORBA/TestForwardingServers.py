# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A server that forwards each call to itself does not keep lms3d-client longer than its time limit. A
forward to a Unix socket is not followed.
"""

import contextlib
import os
import socket
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

from raw_listener import Forwarder, make_profile, make_unix_component
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


CLOSED_PORT = 1
RULE = "clientTransportRule"
UNIX = "* unix,ssl,tcp"


class UnixSocketTest(unittest.TestCase):
    """A server that forwards each call to a Unix socket, where another program of the machine listens."""

    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        path = str(self.folder / "socket")
        self.socket = self.enterContext(socket.socket(socket.AF_UNIX))
        self.socket.bind(path)
        self.socket.listen()
        self.socket.settimeout(1)
        target = make_profile(b"127.0.0.1", CLOSED_PORT, [make_unix_component(path)])
        self.server = self.enterContext(Forwarder(target=target))

    def follows(self, *options, **environment):
        """Whether the client connects to the socket."""
        with subprocess.Popen(
                [CLIENT, f"corbaloc:iiop:1.0@127.0.0.1:{self.server.port}/LMS3D", "status", *options],
                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                env={**os.environ, **environment}) as client:
            with contextlib.suppress(TimeoutError):
                self.socket.accept()[0].close()
                client.kill()
                return True
            _, errors = client.communicate(timeout=60)
            self.assertEqual(client.returncode, 1, errors)
            self.assertRegex(errors, r"^lms3d-client: \w+")
            self.assertGreater(self.server.count, 0)
            return False

    def test_a_unix_socket(self):
        """The client does not connect."""
        self.assertFalse(self.follows())

    def test_the_administrators_rule(self):
        """It replaces the client's: in the arguments, the environment or the configuration file."""
        self.assertTrue(self.follows(f"-ORB{RULE}", UNIX))
        self.assertTrue(self.follows(**{f"ORB{RULE}": UNIX}))
        file = self.folder / "omniORB.cfg"
        file.write_text(f"{RULE} = {UNIX}\n")
        self.assertTrue(self.follows(OMNIORB_CONFIG=str(file)))
        self.assertTrue(self.follows("-ORBconfigFile", str(file)))


if __name__ == "__main__":
    unittest.main()
