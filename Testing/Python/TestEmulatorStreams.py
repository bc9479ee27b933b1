#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Streams of the emulated LMS 200: their telegrams and times. TL: pages of SICK's telegram listing."""

import unittest

import numpy as np

from lms200 import Host, make_device, split
from lms3d.emulation.telegrams import frame

TURN = 1 / 75


class TestStreams(unittest.TestCase):
    """The sub-commands 24h to 2Ah of 20h (TL 19, 127)."""

    def stream(self, rate, variant, command, seconds=4.0, **options):
        host = Host(make_device(**options))
        host.ask(0x20, {9600: 0x42, 19200: 0x41, 38400: 0x40, 500000: 0x48}[rate])
        host.ask(0x3B, variant[0], 0, variant[1], 0)
        sent = host.send(frame(bytes(command)), seconds)
        self.answer_time = sent[1][0]
        return [time for time, _ in sent[2:]], [split(data)[0] for _, data in sent[2:]]

    def streaming_host(self, code=0x42):
        """A host that receives a stream, at 9600 Bd or the rate of a sub-command of 20h."""
        host = Host()
        host.ask(0x20, code)
        host.write(frame(b"\x20\x24"))
        host.run(3.0)
        return host

    def test_intervals(self):
        for rate, variant, hertz in ((9600, (180, 50), 75 / 58), (19200, (180, 50), 2.5),
                                     (38400, (180, 50), 4.6875), (500000, (180, 50), 37.5),
                                     (500000, (180, 100), 75), (38400, (100, 25), 4.6875)):
            with self.subTest(rate=rate, variant=variant):
                times, _ = self.stream(rate, variant, (0x20, 0x24))
                np.testing.assert_allclose(np.diff(times), 1 / hertz, atol=1e-9)

    def test_wake_ups(self):
        """A fan is cast when its last mirror turn begins; at 75 a second this is one time for both."""
        for step, wake_ups in ((100, 1), (50, 2)):
            with self.subTest(step=step):
                host = Host()
                host.ask(0x20, 0x48)
                host.ask(0x3B, 180, 0, step, 0)
                host.write(frame(b"\x20\x24"))
                host.run(0.1)
                sent = 0
                for _ in range(50 * wake_ups):
                    host.now = host.device.next_time() + 1e-5
                    while host.device.take(host.now):
                        sent += 1
                self.assertEqual(sent, 50)

    def test_the_pace_of_the_mirror(self):
        times, _ = self.stream(38400, (180, 50), (0x20, 0x24), is_paced_by_line=False)
        np.testing.assert_allclose(np.diff(times), 2 * TURN, atol=1e-9)

    def test_the_first_scan_begins_after_the_answer(self):
        for variant, turns in (((180, 100), 1), ((180, 50), 2), ((100, 25), 4)):
            times, _ = self.stream(500000, variant, (0x20, 0x24))
            self.assertGreaterEqual(times[0] - self.answer_time, turns * TURN - 1e-9)

    def test_codes_of_streams(self):
        for command, head in (((0x20, 0x26, 2), b"\xb6\x02\x69\x41"),
                              ((0x20, 0x27, 2, 0, 3, 0), b"\xb7\x02\x00\x03\x00\x02\x40"),
                              ((0x20, 0x28, 9, 2, 0, 2, 0), b"\xbf\x09\x02\x00\x02\x00\x01\x40")):
            _, payloads = self.stream(38400, (180, 50), command)
            self.assertGreater(len(payloads), 3)
            for payload in payloads:
                self.assertTrue(payload.startswith(head))

    def test_all_parts_come_round(self):
        for rate in (9600, 38400, 500000):
            for step, parts in ((50, (0, 2)), (25, (0, 1, 2, 3))):
                _, payloads = self.stream(rate, (100, step), (0x20, 0x2A), 6.0)
                found = [payload[2] >> 3 & 3 for payload in payloads]
                self.assertEqual(set(found[:len(parts)]), set(parts))

    def test_an_answer_comes_between_scans(self):
        host = self.streaming_host()
        found = split(host.exchange(frame(b"\x31"), 2.0))
        self.assertEqual((found[0], found[1][0], found[2][0]), (6, 0xB1, 0xB0))

    def test_sleep_loses_scans(self):
        """After the computer has slept, no scans come in a heap."""
        host = self.streaming_host()
        host.now += 100.0
        self.assertLessEqual(len(host.run(0.7)), 2)

    def test_it_goes_on_after_a_refused_telegram(self):
        """TL 23: NAK answers a bad check sum; the mode stays."""
        host = self.streaming_host()
        found = split(host.exchange(frame(b"\x31")[:-1] + b"\x00", 4.0))
        self.assertEqual(found[0], 0x15)
        self.assertGreater(len(found), 4)
        self.assertEqual({payload[0] for payload in found[1:]}, {0xB0})

    def test_commands_do_not_make_the_line_faster(self):
        """After a command a stream begins anew, but not before the line has carried the last scan:
        732 bytes at 9600 Bd take 57.2 turns of the mirror (TL 19, 127; table 10-17)."""
        for pause in (0.08, 0.1, 0.5):
            with self.subTest(pause):
                host = self.streaming_host()
                start = host.now
                times = []
                while host.now < start + 40.0:
                    host.write(frame(b"\x3a"))
                    times += [time for time, data in host.run(pause) if len(data) == 732]
                self.assertGreater(len(times), 4)
                self.assertLessEqual(len(times) / 40.0, 1.293)
                self.assertGreaterEqual(min(np.diff(times)), 732 * 10 / 9600)

    def check_where_it_goes_on(self, sent, count, rate):
        """The line is free when it carries a fan of the stream. After a command, the first fan of the
        stream is of the first scan, two turns of the mirror, that begins when the line is free.

        sent: times and bytes from the start of the stream on. count: of those before the first fan
        of the stream that follows the command.
        """
        free = 0.0
        for i, (time, data) in enumerate(sent):
            if i == count:
                self.assertEqual(len(data), 732)
                self.assertGreaterEqual(time - 2 * TURN, free - 1e-9)
                self.assertLessEqual(time - 2 * TURN, free + TURN + 1e-9)
            elif len(data) == 732 and i != count - 1:  # that may be the requested fan
                self.assertGreaterEqual(time, free - 1e-9)
            free = max(free, time) + (len(data) * 10 / rate if rate else 0.0)
        self.assertGreater(len(sent), count + 2)

    def test_it_goes_on_when_the_line_is_free(self):
        """After a requested fan, an answer, the same rate again, or NAK"""
        commands = {frame(b"\x30\x01"): 2, frame(b"\x31"): 2, frame(b"\x3a"): 2,
                    frame(b"\x31")[:-1] + b"\x00": 1}
        for code, rate in ((0x42, 9600), (0x41, 19200), (0x40, 38400), (0x48, 500000), (0x48, None)):
            for command, answers in {**commands, frame(bytes((0x20, code))): 2}.items():
                for delay in (0.0, 0.1, 0.37, 0.76):
                    host = Host(make_device(is_paced_by_line=rate is not None))
                    host.ask(0x20, code)
                    sent = host.send(frame(b"\x20\x24"), 2.0 + delay)
                    with self.subTest(rate=rate, command=command.hex(), delay=delay):
                        count = len(sent) + answers
                        self.check_where_it_goes_on(sent + host.send(command, 5.0), count, rate)

    def test_a_requested_fan_occupies_the_line(self):
        """732 bytes at 9600 Bd take 0.7625 s."""
        host = self.streaming_host()
        host.run(0.6)
        start = host.now
        times = [time for time, data in host.send(frame(b"\x30\x01"), 4.0) if len(data) == 732]
        self.assertLess(times[0] - start, 0.06)
        self.assertGreaterEqual(times[1] - times[0], 0.7625 + 2 * TURN)

    def break_off_a_change(self, host, command, delay):
        """What follows a command that comes before the answer to a change to 38400 Bd."""
        host.write(frame(b"\x20\x40"))
        host.run(delay)
        start = host.now
        sent = host.send(command, 5.0)
        self.assertAlmostEqual(sent[0][0], start + 0.004)  # ACK, or NAK
        self.assertEqual(len(sent[0][1]), 1)
        return sent

    def test_a_command_breaks_off_a_change_of_rate(self):
        """TL 24, 87: one stream goes on, at the new rate, and after the answer to the command."""
        bad = frame(b"\x31")[:-1] + b"\x00"
        for command, heads in ((frame(b"\x31"), [6, 0xB1]), (frame(b"\x20\x40"), [6, 0xA0]),
                               (frame(b"\x30\x01"), [6]), (bad, [0x15])):
            for code in (0x40, 0x42):
                for delay in (0.0, 0.001, 0.006):
                    with self.subTest(command=command.hex(), code=code, delay=delay):
                        sent = self.break_off_a_change(self.streaming_host(code), command, delay)
                        found = [payload if isinstance(payload, int) else payload[0]
                                 for _, data in sent for payload in split(data)]
                        fans = len(found) - len(heads)
                        self.assertGreater(fans, 15)
                        self.assertEqual(found, heads + [0xB0] * fans)
                        steps = np.diff([time for time, data in sent if len(data) == 732])
                        self.assertGreaterEqual(steps[0], 732 * 10 / 38400)
                        np.testing.assert_allclose(steps[1:], 1 / 4.6875, atol=1e-9)

    def test_a_command_breaks_off_a_change_of_rate_and_ends_the_stream(self):
        """3Bh, 20h 25h, and 10h, whose last telegram is 90h"""
        for command, heads in ((b"\x3b\xb4\x00\x64\x00", [0xBB]), (b"\x20\x25", [0xA0]),
                               (b"\x10", [0x91, 0x90])):
            for delay in (0.0, 0.001, 0.006):
                with self.subTest(command=command.hex(), delay=delay):
                    sent = self.break_off_a_change(self.streaming_host(), frame(command), delay)
                    self.assertEqual([split(data)[0][0] for _, data in sent[1:]], heads)


if __name__ == "__main__":
    unittest.main()
