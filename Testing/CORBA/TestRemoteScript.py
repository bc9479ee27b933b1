# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""pvpython and pvbatch follow a server, as Documentation/corba.md describes.

They run FollowServer.py. Needs a display. LMS3D_PVPYTHON and LMS3D_PVBATCH are the programs,
LMS3D_REMOTE_PLUGIN the plugin's file.
"""

import os
import subprocess
import unittest
from pathlib import Path

from server_process import Server

SCRIPT = Path(__file__).with_name("FollowServer.py")


class RemoteScriptTest(unittest.TestCase):
    """One script in both programs."""

    def follow(self, program):
        with Server() as server:
            finished = subprocess.run(
                [program, "--dr", SCRIPT, os.environ["LMS3D_REMOTE_PLUGIN"], server.corbaloc],
                capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        lines = [line.split() for line in finished.stdout.splitlines()]
        numbers = [int(number) for number, _ in lines]
        self.assertEqual(len(numbers), 8)
        self.assertEqual(numbers, sorted(set(numbers)), "each Refresh() gives a newer scan")
        self.assertEqual([float(x) for _, x in lines], 6 * [0.3] + 2 * [1.25])

    def test_pvpython(self):
        self.follow(os.environ["LMS3D_PVPYTHON"])

    def test_pvbatch(self):
        self.follow(os.environ["LMS3D_PVBATCH"])


if __name__ == "__main__":
    unittest.main()
