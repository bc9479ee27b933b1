#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Client and server: a pvserver reads, scans and maps with the same bits as pvpython alone.

Starts pvserver and pvpython with ClientScan.py. LMS3D_PVSERVER, LMS3D_PVPYTHON and, for
TestServerOfTwo, LMS3D_MPIEXEC name the programs. LMS3D_PLUGIN is the plugin's file, LMS3D_DATA_DIR the
folder of room.wrl.
"""

import functools
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

SCRIPT = Path(__file__).with_name("ClientScan.py")


class Server:
    """A pvserver on a free port. It waits for one client and exits with it."""

    def __init__(self, *launcher):
        self.process = subprocess.Popen(
            [*launcher, os.environ["LMS3D_PVSERVER"], "--server-port=0"],
            stdout=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True)

    def __enter__(self):
        for line in self.process.stdout:
            if line.startswith("Accepting connection"):
                self.port = int(line.rpartition(":")[2])
                return self
        raise RuntimeError(f"pvserver ended with {self.process.wait()}")

    def __exit__(self, failure, *_):
        if failure:
            self.process.terminate()
        self.process.wait(timeout=30)
        self.process.stdout.close()


def results(*port):
    """The arrays that a client receives."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "results.npz"
        subprocess.run([os.environ["LMS3D_PVPYTHON"], str(SCRIPT), str(file), *map(str, port)],
                       check=True, timeout=120)
        with np.load(file) as found:
            return dict(found)


@functools.cache
def alone():
    """The arrays without a server."""
    return results()


class ServerTest(unittest.TestCase):
    """The same client with and without a server."""

    def check(self, *launcher, processes):
        with Server(*launcher) as server:
            served = results(server.port)
        self.assertTrue(served.pop("remote"))
        self.assertEqual(served.pop("processes"), processes)
        self.assertEqual(set(served), set(alone()) - {"remote", "processes"})
        for name, values in served.items():
            with self.subTest(name):
                np.testing.assert_array_equal(values, alone()[name])


class TestServer(ServerTest):
    """A server of one process."""

    def test_client_alone_has_everything(self):
        self.assertFalse(alone()["remote"])
        self.assertEqual(alone()["room.Triangles"].size, 3 * 804)
        for name in ("scan", "doorway"):
            self.assertEqual(alone()[f"{name}.Range"].shape, (361 * 360,))
        self.assertGreater(alone()["map.Triangles"].size, 3 * 500)

    def test_one_process(self):
        self.check(processes=1)


class TestServerOfTwo(ServerTest):
    """A server of two processes under MPI."""

    def test_two_processes(self):
        self.check(os.environ["LMS3D_MPIEXEC"], "-n", "2", processes=2)


if __name__ == "__main__":
    unittest.main()
