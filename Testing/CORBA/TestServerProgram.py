# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d-server as a user starts it."""

import contextlib
import signal
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path

import giop
from server_process import (
    DATA, SERVER, Server, find_free_port, run_client, wait_until)


def run_server(*arguments):
    """The result of a server that does not start."""
    return subprocess.run([SERVER, *arguments], capture_output=True, text=True, timeout=60,
                          check=False)


def write_scene_of_many_nodes(path):
    """A small file that takes seconds to read: each transform contains the one before it twice."""
    lines = ["#VRML V2.0 utf8", "Shape { geometry Box { } }", "DEF N0 Group { }"]
    lines += [f"DEF N{i} Transform {{ rotation 0 0 1 {i} children [ USE N{i - 1} USE N{i - 1} ] }}"
              for i in range(1, 24)]
    path.write_text("\n".join(lines))


def write_scene_of_a_million_triangles(path):
    """A jagged field."""
    count = 708
    heights = " ".join(str(i * 7919 % 1009) for i in range(count ** 2))
    path.write_text("#VRML V2.0 utf8\nShape { geometry ElevationGrid { "
                    f"xDimension {count} zDimension {count} height [ {heights} ] }} }}")


def ask(client):
    """The result of one call."""
    try:
        client.call("getPose")
        return "answer"
    except giop.SystemException as problem:
        return str(problem)


def call_on(corbaloc, is_over, results):
    """A client that reconnects each time its connection ends."""
    while not is_over.is_set():
        with contextlib.suppress(OSError), giop.Client(corbaloc) as client:
            while True:
                results.add(ask(client))


class StartTest(unittest.TestCase):
    """Options, files and their errors."""

    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_help(self):
        """The text has every option."""
        finished = run_server("--help")
        self.assertEqual(finished.returncode, 0)
        for option in ("--scenes", "--rate", "--read-only", "--callbacks", "--tls-key", "--config"):
            self.assertIn(option, finished.stdout)

    def test_limits_of_a_scene(self):
        """A scene beyond them ends the start with code 1 and the name of the limit."""
        for option, limit in (("--scene-nodes", "MaximumNumberOfNodes"),
                              ("--scene-triangles", "MaximumNumberOfTriangles")):
            finished = run_server("--scenes", DATA, "--scene", "room.wrl", option, "1")
            self.assertEqual(finished.returncode, 1)
            self.assertIn(limit, finished.stderr)

    def test_wrong_options(self):
        """Code 2, and a message that names the option."""
        for arguments, word in (((), "--scenes"), (("--scenes", DATA, "--rate", "x"), "--rate"),
                                (("--scenes", DATA, "--endpoint", "giop:tcp::2810"), "--allow-remote")):
            finished = run_server(*arguments)
            self.assertEqual(finished.returncode, 2)
            self.assertIn(word, finished.stderr)

    def test_what_cannot_start(self):
        """Code 1, and a message with the reason."""
        with Server() as server:
            taken = server.corbaloc.split("@")[1].split("/")[0]
            finished = run_server("--scenes", DATA, "--endpoint", f"giop:tcp:{taken}")
            self.assertEqual(finished.returncode, 1)
            self.assertIn("is the endpoint in use?", finished.stderr)
        for arguments, word in (
                (("--connect-to", "foo"), "address mask"), (("-ORBfoo", "1"), "unknown option"),
                (("--endpoint", "giop:ssl:127.0.0.1:", "--tls-key", "/no/such.pem",
                  "--tls-authorities", "/no/such.pem"), "/no/such.pem")):
            finished = run_server("--scenes", DATA, *arguments)
            self.assertEqual(finished.returncode, 1)
            self.assertIn(word, finished.stderr)
            self.assertNotIn("in use", finished.stderr)
        for arguments, word in ((("--scenes", "/no/such/folder"), "cannot be read"),
                                (("--scenes", self.folder), "no file"),
                                (("--scenes", DATA, "--scene", "x.wrl"), "x.wrl"),
                                (("--scenes", DATA, "--ior", "/no/such/x.ior"), "x.ior")):
            finished = run_server(*arguments)
            self.assertEqual(finished.returncode, 1)
            self.assertIn(word, finished.stderr)

    def test_scenes_with_other_names(self):
        """The log names each file that is left out, in one line of ASCII."""
        room = (DATA / "room.wrl").read_bytes()
        for name in (b"room.wrl", "caf\xe9.wrl".encode(), b"two\nlines.wrl", b'a\\"\x1b.wrl',
                     140 * b"x" + b".wrl"):
            (self.folder / name.decode(errors="surrogateescape")).write_bytes(room)
        with Server("--scenes", self.folder) as server:
            for name in (r"caf\xc3\xa9.wrl", r"two\nlines.wrl", r'a\"\x1b.wrl',
                         140 * "x" + ".wrl"):
                line = ("Z a scene is left out: its name is longer than 128 characters or not plain "
                        f"ASCII: {name}\n")
                self.assertTrue(wait_until(lambda: line in server.read_log()), name)
            self.assertEqual(run_client(server.corbaloc, "scenes").stdout, "room.wrl\n")

    def test_files(self):
        """The configuration file is used, and the file of --ior exists as long as the server."""
        reference = self.folder / "scanner.ior"
        configuration = self.folder / "server.conf"
        configuration.write_text(f"ior = {reference}\nrate = 50\nposition = 0.5 0.5 1\nread-only\n")
        with Server("--config", configuration) as server:
            self.assertEqual(reference.read_text().strip(), server.reference)
            self.assertIn("rate 50 Hz, read-only", run_client(reference, "status").stdout)
            self.assertIn("NotPermitted", run_client(reference, "pose", "0", "0", "1").stderr)
            # The command line of Server() has a position too.
            self.assertIn("from 0.3 -0.2 1:", run_client(reference, "watch", "1").stdout)
            self.assertEqual(server.stop(signal.SIGINT)[0], 0)
            self.assertFalse(reference.exists())
            self.assertIn("SIGINT: ending", server.read_log())

    def test_end_of_its_terminal(self):
        """The server ends and removes its file. Under nohup it goes on."""
        reference = self.folder / "scanner.ior"
        with Server("--ior", reference) as server:
            self.assertEqual(server.stop(signal.SIGHUP)[0], 0)
            self.assertFalse(reference.exists())
            self.assertIn("SIGHUP: ending", server.read_log())
        before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
        self.addCleanup(signal.signal, signal.SIGHUP, before)
        with Server() as server:
            server.process.send_signal(signal.SIGHUP)
            self.assertEqual(run_client(server.corbaloc, "watch", "3").returncode, 0)
            self.assertEqual(server.stop()[0], 0)

    def test_few_open_files(self):
        """The log warns of too few connections."""
        finished = subprocess.run(
            ["sh", "-c", 'ulimit -n 256; exec "$0" "$@"', SERVER, "--scenes", DATA, "--scene", "x"],
            capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(finished.returncode, 1)
        self.assertIn("allows 256 open files", finished.stderr)

    def test_end_while_the_scene_is_read(self):
        """Code 0 at once, and no address is announced."""
        scene, reference = self.folder / "large.wrl", self.folder / "scanner.ior"
        write_scene_of_many_nodes(scene)
        with subprocess.Popen([SERVER, "--scenes", self.folder, "--ior", reference,
                               "--scene-nodes", "100000000"],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as server:
            try:
                self.assertIn("reading the scene large.wrl", server.stderr.readline())
                server.send_signal(signal.SIGTERM)
                output, log = server.communicate(timeout=60)
            finally:
                server.kill()
        self.assertEqual(server.returncode, 0)
        self.assertEqual(output, "")
        self.assertIn("SIGTERM: ending before the scene was read", log)
        self.assertEqual(list(self.folder.iterdir()), [scene])

    def test_end_while_the_search_tree_is_built(self):
        """The server does not finish the tree, which takes most of the time of the first scan."""
        write_scene_of_a_million_triangles(self.folder / "large.wrl")
        options = ("--scenes", self.folder, "--scene", "large.wrl", "--no-map")
        with Server(*options) as server:
            start = time.monotonic()
            self.assertIn("scan 1 ", run_client(server.corbaloc, "watch", "1").stdout)
            first_scan = time.monotonic() - start
        ends = []
        for _ in range(3):
            with Server(*options) as server:
                time.sleep(first_scan / 4)
                code, seconds = server.stop()
                self.assertEqual(code, 0)
                ends.append(seconds)
        # A complete tree would take three quarters of the time in each run.
        self.assertLess(min(ends), first_scan / 2)

    def test_clients_that_call_while_it_starts_and_ends(self):
        """They get either an answer or an exception that permits another try."""
        address = f"127.0.0.1:{find_free_port()}"
        results = set()
        is_over = threading.Event()
        clients = [threading.Thread(
            target=call_on, args=(f"corbaloc:iiop:1.2@{address}/LMS3D", is_over, results))
            for _ in range(4)]
        for client in clients:
            client.start()
        for _ in range(10):
            with Server("--no-map", "--endpoint", "giop:tcp:" + address) as server:
                time.sleep(0.1)
                self.assertEqual(server.stop()[0], 0)
        is_over.set()
        for client in clients:
            client.join()
        self.assertLessEqual(results, {"answer", "IDL:omg.org/CORBA/TRANSIENT:1.0"})
        self.assertIn("answer", results)

    def test_remote_is_logged(self):
        """The log warns of an endpoint that other machines can reach."""
        with Server("--allow-remote", "-ORBendPointPublish", "giop:tcp:192.0.2.1:2810") as server:
            self.assertIn("other machines can reach", server.read_log())
        with Server("--endpoint", "giop:tcp:0.0.0.0:", "--allow-remote") as server:
            self.assertEqual("other machines can reach" in server.read_log(),
                             "@127.0.0.1:" not in server.corbaloc)
        with Server() as server:
            self.assertNotIn("other machines", server.read_log())


if __name__ == "__main__":
    unittest.main()
