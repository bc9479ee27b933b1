# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Listeners that forward calls without end, do not answer, name other transports or forge lines of the
log disturb neither the server nor other clients."""

import contextlib
import re
import select
import socket
import tempfile
import unittest
from pathlib import Path

import giop
from raw_listener import (
    Forwarder, make_profile, make_unix_component, subscribe, unsubscribe)
from server_process import Server, wait_until

# Seconds until the server ends.
MAXIMUM_SECONDS = 8
MAXIMUM_LISTENERS = 16
# A port without a listening socket.
CLOSED_PORT = 1
LINE = re.compile(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z [ -~]{1,1010}")


class ListenerTest(unittest.TestCase):
    """A server with callbacks for each test."""

    def setUp(self):
        self.server = self.enterContext(Server("--callbacks"))
        self.client = self.enterContext(self.server.connect())
        self.threads = self.server.count_threads()

    def check_end(self):
        """SIGTERM ends the server in time."""
        code, seconds = self.server.stop()
        self.assertEqual(code, 0)
        self.assertLess(seconds, MAXIMUM_SECONDS)

    def wait_for_log(self, words, count=1, seconds=60):
        """Until the log has the words so often."""
        self.assertTrue(wait_until(lambda: self.server.read_log().count(words) >= count, seconds),
                        self.server.read_log())


class ForwardTest(ListenerTest):
    """Each answer of the listener forwards the call to the listener itself."""

    def test_it_is_dropped(self):
        """A forward does not renew the time of a call, not even with a new connection."""
        for closes in (False, True):
            with self.subTest(closes=closes), Forwarder(closes) as listener:
                subscribe(self.client, listener.profile)
                self.wait_for_log(f"is dropped: giop:tcp:127.0.0.1:{listener.port}")
                self.assertGreaterEqual(listener.count, 3)
        self.check_end()

    def test_the_server_ends(self):
        """In the middle of the calls."""
        with contextlib.ExitStack() as stack:
            listeners = [stack.enter_context(Forwarder(closes)) for closes in (False, True) * 4]
            for listener in listeners:
                subscribe(self.client, listener.profile)
            self.assertTrue(wait_until(lambda: all(listener.count for listener in listeners)))
            self.check_end()

    def test_the_limit_counts_current_calls(self):
        """A client that subscribes and unsubscribes in a loop gets no further threads."""
        # The calls may end before the second subscriptions.
        self.assertTrue(any(self.count_refused() for _ in range(10)))
        # The places are free again.
        with Forwarder() as listener:
            unsubscribe(self.client, self.subscribe_when_free(listener))
        self.check_end()

    def count_refused(self):
        """Listeners that subscribe again, just after as many were unsubscribed during a call."""
        refused = 0
        with contextlib.ExitStack() as stack:
            listeners = [stack.enter_context(Forwarder()) for _ in range(MAXIMUM_LISTENERS)]
            numbers = [self.subscribe_when_free(listener) for listener in listeners]
            self.assertTrue(wait_until(lambda: all(listener.count for listener in listeners)))
            for number in numbers:
                # The server may have dropped it.
                with contextlib.suppress(giop.UserException):
                    unsubscribe(self.client, number)
            for listener in listeners:
                try:
                    unsubscribe(self.client, subscribe(self.client, listener.profile))
                except giop.UserException as problem:
                    self.assertIn("LimitExceeded", str(problem))
                    refused += 1
            self.assertLessEqual(self.server.count_threads(),
                                 self.threads + MAXIMUM_LISTENERS + 10)
        return refused

    def subscribe_when_free(self, listener):
        """The number of the subscription, when there is a place."""
        numbers = []

        def try_once():
            with contextlib.suppress(giop.UserException):
                numbers.append(subscribe(self.client, listener.profile))
            return numbers

        self.assertTrue(wait_until(try_once))
        return numbers[0]


class SilentTest(ListenerTest):
    """A listener that does not answer."""

    def test_unsubscribe_answers_during_a_call(self):
        """It does not wait for the end of the call. A slow machine may need more tries."""
        self.assertTrue(any(self.answers_during_a_call() for _ in range(10)))
        self.check_end()

    def answers_during_a_call(self):
        """Whether the answer comes while the call goes on: the server closes its connection after."""
        with socket.create_server(("127.0.0.1", 0)) as listener:
            listener.settimeout(60)
            port = listener.getsockname()[1]
            number = subscribe(self.client, make_profile(b"127.0.0.1", port))
            with listener.accept()[0] as connection:
                header = giop.receive(connection, 12)
                giop.receive(connection, int.from_bytes(
                    header[8:], "little" if header[6] & 1 else "big"))
                with contextlib.suppress(giop.UserException):  # dropped after three calls
                    unsubscribe(self.client, number)
                    return not select.select([connection], [], [], 0)[0]
        return False


class AddressTest(ListenerTest):
    """Addresses that the server must not use, or must not write as they are."""

    def setUp(self):
        super().setUp()
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def test_a_unix_socket(self):
        """The subscription is refused, and the server does not connect."""
        path = str(self.folder / "socket")
        with socket.socket(socket.AF_UNIX) as other:
            other.bind(path)
            other.listen()
            other.settimeout(1)
            profile = make_profile(b"127.0.0.1", CLOSED_PORT, [make_unix_component(path)])
            with self.assertRaisesRegex(giop.UserException, "InvalidArgument"):
                subscribe(self.client, profile)
            with self.assertRaises(TimeoutError):
                other.accept()
        self.wait_for_log(f"neither TCP nor TLS: giop:unix:{path}")
        self.check_end()

    def test_a_forward_to_a_unix_socket(self):
        """The server does not connect after a forward either."""
        path = str(self.folder / "socket")
        target = make_profile(b"127.0.0.1", CLOSED_PORT, [make_unix_component(path)])
        with socket.socket(socket.AF_UNIX) as other, Forwarder(target=target) as listener:
            other.bind(path)
            other.listen()
            other.settimeout(1)
            subscribe(self.client, listener.profile)
            self.wait_for_log(f"is dropped: giop:tcp:127.0.0.1:{listener.port}")
            self.assertGreater(listener.count, 0)
            with self.assertRaises(TimeoutError):
                other.accept()
        self.check_end()

    def test_a_host_that_forges_lines(self):
        """The log has printable characters only, and its lines are not too long."""
        hosts = (b"a\n2026-01-01T00:00:00.000Z forged", b"\x1b[2J\xff", b"x" * 60000)
        for host in hosts:
            subscribe(self.client, make_profile(host, CLOSED_PORT))
        # The system's lookup of a name may take long.
        self.wait_for_log("is dropped", len(hosts), 90)
        self.check_end()
        log = self.server.read_log()
        for line in log.splitlines():
            self.assertRegex(line, LINE)
            self.assertIsNotNone(LINE.fullmatch(line), line)
        self.assertIn(r"giop:tcp:[a\n2026-01-01T00:00:00.000Z forged]:1", log)
        self.assertIn(r"giop:tcp:\x1b[2J\xff:1", log)

    def test_refusals_are_limited(self):
        """The log counts the lines that it leaves out."""
        profile = make_profile(b"127.0.0.1", CLOSED_PORT, [make_unix_component("/no/such")])
        for _ in range(200):
            with self.assertRaises(giop.UserException):
                subscribe(self.client, profile)
        self.check_end()
        log = self.server.read_log()
        written = log.count("a subscription is refused")
        left_out = sum(map(int, re.findall(r"listeners: (\d+) lines were left out", log)))
        self.assertEqual(written + left_out, 200)
        self.assertGreater(left_out, 0)


if __name__ == "__main__":
    unittest.main()
