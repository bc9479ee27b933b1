# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The server with TLS, with certificates of the test."""

import subprocess
import tempfile
import unittest
from pathlib import Path

from server_process import Server, run_client


def openssl(*arguments, folder):
    """A command of openssl, as in Documentation/corba-security.md."""
    subprocess.run(["openssl", *arguments], cwd=folder, check=True, capture_output=True)


def make_authority(folder, name):
    """name.pem and name.key of an authority."""
    openssl("req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", f"/CN={name}",
            "-keyout", f"{name}.key", "-out", f"{name}.pem", folder=folder)


def make_certificate(folder, name, authority):
    """name.both.pem: a key and its certificate."""
    openssl("req", "-newkey", "rsa:2048", "-nodes", "-subj", f"/CN={name}",
            "-keyout", f"{name}.key", "-out", f"{name}.csr", folder=folder)
    openssl("x509", "-req", "-in", f"{name}.csr", "-CA", f"{authority}.pem",
            "-CAkey", f"{authority}.key", "-CAcreateserial", "-days", "2", "-out", f"{name}.pem",
            folder=folder)
    both = (folder / f"{name}.pem").read_text() + (folder / f"{name}.key").read_text()
    (folder / f"{name}.both.pem").write_text(both)


class TLSTest(unittest.TestCase):
    """One server, and clients with good, foreign and no certificates."""

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        for authority, holders in (("lab", ("server", "robot")), ("stranger", ("intruder",))):
            make_authority(cls.folder, authority)
            for holder in holders:
                make_certificate(cls.folder, holder, authority)
        cls.server = cls.enterClassContext(Server(
            "--endpoint", "giop:ssl:127.0.0.1:", "--tls-key", cls.folder / "server.both.pem",
            "--tls-authorities", cls.folder / "lab.pem"))

    def ask(self, holder, *options, authority="lab"):
        """The client's answer with this certificate."""
        return run_client(
            self.server.corbaloc, "status", "-ORBsslCAFile", self.folder / f"{authority}.pem",
            "-ORBsslKeyFile", self.folder / f"{holder}.both.pem", "-ORBsslKeyPassword", "none",
            *options)

    def test_a_good_certificate(self):
        """The corbaloc says that TLS is needed."""
        self.assertTrue(self.server.corbaloc.startswith("corbaloc:ssliop:1.2@127.0.0.1:"))
        self.assertIn("scene room.wrl", self.ask("robot").stdout)

    def test_a_foreign_certificate(self):
        """A certificate of another authority is refused, and other clients are still served."""
        finished = self.ask("intruder")
        self.assertEqual(finished.returncode, 1)
        # While connecting, or at the first call: TLS 1.3 reports it then.
        self.assertRegex(finished.stderr, "TRANSIENT|COMM_FAILURE")
        self.assertIn("scene room.wrl", self.ask("robot").stdout)

    def test_a_foreign_server(self):
        """A client that trusts another authority does not connect to this server."""
        self.assertEqual(self.ask("robot", authority="stranger").returncode, 1)

    def test_what_a_refusal_looks_like(self):
        """As in Documentation/corba-security.md: only the trace names the reason."""
        trace = ("-ORBtraceLevel", "10")
        authority = ("-ORBsslCAFile", self.folder / "lab.pem")
        for ask, reason in (
                (lambda: self.ask("intruder", *trace), "alert unknown ca"),
                (lambda: self.ask("robot", *trace, authority="stranger"), "certificate verify failed"),
                (lambda: run_client(self.server.corbaloc, "status", *authority, *trace),
                 "alert certificate required")):
            with self.subTest(reason):
                # An alert of the server is lost if the client sends at the same time.
                for _ in range(20):
                    finished = ask()
                    self.assertEqual(finished.returncode, 1)
                    self.assertIn("no server answers there", finished.stderr)
                    # omniORB 4.3 does not print alerts.
                    has_alerts = "Version: 4.2" in finished.stderr
                    shown = reason if has_alerts or "alert" not in reason else "Error in network"
                    if shown in finished.stderr:
                        break
                self.assertIn(shown, finished.stderr)

    def test_no_certificate(self):
        """Neither TLS without a key nor plain TCP."""
        finished = run_client(self.server.corbaloc, "status", "-ORBsslCAFile",
                              self.folder / "lab.pem")
        self.assertEqual(finished.returncode, 1)
        plain = self.server.corbaloc.replace("ssliop", "iiop")
        self.assertEqual(run_client(plain, "status", "-ORBclientCallTimeOutPeriod", "3000").returncode, 1)
        self.assertIn("scene room.wrl", self.ask("robot").stdout)


if __name__ == "__main__":
    unittest.main()
