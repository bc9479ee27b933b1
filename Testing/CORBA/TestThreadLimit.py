# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A server whose threads run out serves the clients that it has, and ends."""

import resource
import unittest

import giop
from raw_listener import Forwarder, subscribe
from server_process import BEAMS, Server, wait_until

# Seconds until the server ends.
MAXIMUM_SECONDS = 8
# A thread reserves as much address space for its stack, bytes.
STACK = 1 << 30


class ThreadLimitTest(unittest.TestCase):
    """A server with large stacks, so that a limit of its address space concerns its threads alone."""

    def setUp(self):
        before = resource.getrlimit(resource.RLIMIT_STACK)
        resource.setrlimit(resource.RLIMIT_STACK, (STACK, before[1]))
        self.addCleanup(resource.setrlimit, resource.RLIMIT_STACK, before)
        self.server = self.enterContext(Server("--callbacks"))
        self.client = self.enterContext(self.server.connect())

    def forbid_threads(self):
        """A further stack does not fit, but other memory does."""
        maximum = self.server.measure_address_space() + STACK // 2
        resource.prlimit(self.server.process.pid, resource.RLIMIT_AS, (maximum, maximum))

    def test_the_server_ends(self):
        """Its end needs no new thread."""
        self.assertEqual(len(self.client.fetch()), 3 * BEAMS)
        self.forbid_threads()
        with Forwarder() as listener:
            with self.assertRaisesRegex(giop.SystemException, "NO_RESOURCES"):
                subscribe(self.client, listener.profile)
        self.assertTrue(wait_until(lambda: "there is no thread for it" in self.server.read_log()))
        self.assertEqual(len(self.client.fetch()), 3 * BEAMS)
        code, seconds = self.server.stop()
        self.assertEqual(code, 0)
        self.assertLess(seconds, MAXIMUM_SECONDS)


if __name__ == "__main__":
    unittest.main()
