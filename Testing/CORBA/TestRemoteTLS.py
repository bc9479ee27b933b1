# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A source with TLS, which omniORB's environment or its configuration file sets."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from server_process import BEAMS, Server
from TestTLS import make_authority, make_certificate

_LOOK = """
import sys
from lms3d.remote import RemoteScanner

print(RemoteScanner(sys.argv[1]).returns)
"""


class RemoteTLSTest(unittest.TestCase):
    """One server, and sources with and without a certificate."""

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        make_authority(cls.folder, "lab")
        for holder in ("server", "window"):
            make_certificate(cls.folder, holder, "lab")
        cls.server = cls.enterClassContext(Server(
            "--endpoint", "giop:ssl:127.0.0.1:", "--tls-key", cls.folder / "server.both.pem",
            "--tls-authorities", cls.folder / "lab.pem"))

    def look(self, **environment):
        """A process that shows one scan."""
        return subprocess.run([sys.executable, "-c", _LOOK, self.server.corbaloc],
                              env={**os.environ, **environment}, capture_output=True, text=True,
                              timeout=60, check=False)

    def assert_seen(self, finished):
        """A complete scan, and no other output."""
        self.assertEqual((finished.stdout, finished.stderr), (f"{BEAMS}\n", ""))

    def test_by_environment(self):
        """One variable per setting."""
        self.assert_seen(self.look(ORBsslCAFile=f"{self.folder}/lab.pem",
                                   ORBsslKeyFile=f"{self.folder}/window.both.pem",
                                   ORBsslKeyPassword="none"))

    def test_by_configuration_file(self):
        """All of them in one file."""
        configuration = self.folder / "omniORB.cfg"
        configuration.write_text(f"sslCAFile = {self.folder}/lab.pem\n"
                                 f"sslKeyFile = {self.folder}/window.both.pem\n"
                                 "sslKeyPassword = none\n")
        self.assert_seen(self.look(OMNIORB_CONFIG=str(configuration)))

    def test_without_a_certificate(self):
        """Neither with an authority alone, nor without anything."""
        for environment in ({"ORBsslCAFile": f"{self.folder}/lab.pem"}, {}):
            finished = self.look(**environment)
            self.assertEqual(finished.returncode, 1)
            self.assertIn("nothing to show", finished.stderr)


if __name__ == "__main__":
    unittest.main()
