# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Programs whose standard output cannot be written, as on a full disk."""

import subprocess
import unittest

from server_process import CLIENT, PAPER_CLIENT, SERVER, Server


def run_on_full_disk(*arguments):
    """The result of a program that writes to a full disk."""
    with open("/dev/full", "w", encoding="ascii") as full:
        return subprocess.run(arguments, stdout=full, stderr=subprocess.PIPE, text=True, timeout=60,
                              check=False)


class FullDiskTest(unittest.TestCase):
    """Code 1 and one line that says why."""

    def check(self, program, *arguments):
        finished = run_on_full_disk(program, *arguments)
        name = program.rpartition("/")[2]
        self.assertEqual(finished.stderr, f"{name}: the standard output cannot be written\n")
        self.assertEqual(finished.returncode, 1)

    def test_clients_report_it(self):
        with Server("--callbacks") as server:
            # Without a count, watch and listen would run as long as the server.
            for command in ("status", "scenes", "fetch", "watch", "listen"):
                with self.subTest(command):
                    self.check(CLIENT, server.corbaloc, command)
            self.check(PAPER_CLIENT, server.corbaloc)

    def test_help_reports_it(self):
        self.check(CLIENT, "--help")
        self.check(SERVER, "--help")
        self.check(SERVER, "--version")


if __name__ == "__main__":
    unittest.main()
