# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The server in a real naming service, omniNames."""

import datetime
import os
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import unittest

from server_process import Server, find_free_port, run_client, wait_until

# The system's program, or the one that "./run test" unpacks.
OMNINAMES = shutil.which("omniNames") or os.environ["LMS3D_OMNINAMES"]


def is_open(port):
    """Whether a program listens at the port."""
    with socket.socket() as connection:
        return connection.connect_ex(("127.0.0.1", port)) == 0


class NamingTest(unittest.TestCase):
    """A naming service for each test."""

    def setUp(self):
        folder = self.enterContext(tempfile.TemporaryDirectory())
        self.port = find_free_port()
        self.names = subprocess.Popen(
            [OMNINAMES, "-start", str(self.port), "-always", "-datadir", folder,
             "-errlog", os.path.join(folder, "err"), "-ORBendPoint", f"giop:tcp:127.0.0.1:{self.port}"])
        self.addCleanup(self.names.wait)
        self.addCleanup(self.names.kill)
        self.assertTrue(wait_until(lambda: is_open(self.port)))
        self.service = f"corbaloc:iiop:1.2@127.0.0.1:{self.port}/NameService"

    def look_up(self, name):
        """The output of a client that uses the naming service."""
        return run_client(f"corbaname:iiop:1.2@127.0.0.1:{self.port}#{name}", "status")

    def test_is_there_as_long_as_the_server(self):
        """The name is bound while the server runs."""
        with Server("--naming-service", self.service) as server:
            self.assertIn("registered with the naming service as LMS3D.Scanner", server.read_log())
            self.assertIn("scene room.wrl", self.look_up("LMS3D.Scanner").stdout)
            self.assertEqual(server.stop()[0], 0)
        self.assertIn("names no object", self.look_up("LMS3D.Scanner").stderr)

    def test_the_orbs_own_service_and_another_name(self):
        """The service is named by -ORBInitRef."""
        with Server("--naming", "--name", "Robot.Laser", "-ORBInitRef",
                    f"NameService={self.service}"):
            self.assertIn("scene room.wrl", self.look_up("Robot.Laser").stdout)

    def test_ways_to_write_a_name(self):
        """Names with escaped characters, with the service's key, and wrong ones."""
        with Server("--naming-service", self.service, "--name", "My robot.Laser#2"):
            self.assertIn("scene room.wrl", self.look_up("My%20robot.Laser%232").stdout)
            self.assertIn("scene room.wrl", run_client(
                f"corbaname:iiop:1.2@127.0.0.1:{self.port}/NameService#My%20robot.Laser%232",
                "status").stdout)
            for name in ("", "My%20robot", "My%2", "%zz", "a.b.c", "/"):
                finished = self.look_up(name)
                self.assertEqual(finished.returncode, 1)
                self.assertIn("names no object", finished.stderr)

    def test_a_server_that_was_killed_is_replaced(self):
        """A new server replaces the stale name, and the name stays."""
        with Server("--naming-service", self.service) as first:
            first.process.kill()
            first.process.wait()
            self.assertIn("TRANSIENT", self.look_up("LMS3D.Scanner").stderr)
            with Server("--naming-service", self.service) as second:
                self.assertIn("scene room.wrl", self.look_up("LMS3D.Scanner").stdout)
                with Server("--naming-service", self.service):
                    self.assertEqual(second.stop()[0], 0)
                    self.assertIn("scene room.wrl", self.look_up("LMS3D.Scanner").stdout)

    def test_ends_although_it_hangs(self):
        """The server ends soon and logs that the name stays."""
        with Server("--naming-service", self.service) as server:
            self.names.send_signal(signal.SIGSTOP)
            os.waitpid(self.names.pid, os.WUNTRACED)
            code, seconds = server.stop()
            self.assertEqual(code, 0)
            # Without a limit, a call may take five seconds.
            self.assertLess(seconds, 4)
            self.assertIn("the name stays in the naming service", server.read_log())

    def test_scans_although_it_hangs(self):
        """The first scan begins before the server stops waiting for the naming service."""
        with socket.create_server(("127.0.0.1", 0)) as silent:
            service = f"corbaloc:iiop:1.2@127.0.0.1:{silent.getsockname()[1]}/NameService"
            with Server("--rate", "0.01", "--naming-service", service) as server:
                line = re.search("^(.*)Z not registered", server.read_log(), re.MULTILINE)
                end = datetime.datetime.fromisoformat(line[1] + "+00:00").timestamp()
                with server.connect() as client:
                    header = client.call(
                        "waitForScan", lambda e: e.number("Q", 0).number("Q", 0).number("I", 10000))
                number, _, _, start = header.numbers("Q", 4)
                self.assertEqual(number, 1)
                self.assertLess(start * 1e-9, end)

    def test_serves_without_it(self):
        """The log says so, and the server works otherwise."""
        with Server("--naming-service", "corbaloc:iiop:1.2@127.0.0.1:1/NameService") as server:
            self.assertIn("not registered with the naming service", server.read_log())
            self.assertIn("scene room.wrl", run_client(server.corbaloc, "status").stdout)
            self.assertEqual(server.stop()[0], 0)


if __name__ == "__main__":
    unittest.main()
