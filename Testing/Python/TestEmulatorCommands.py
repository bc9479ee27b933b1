#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The commands of the LMS 200, without a terminal. TL: pages of SICK's telegram listing."""

import unittest

from lms200 import PASSWORD, Host, make_device, split
from lms3d.emulation.telegrams import frame

NOT_POSSIBLE = b"\x92"
DONE = b"\xa0\x00"
# Commands that are left out, and commands with wrong data.
LEFT_OUT = ((0x20, 0x29), (0x20, 0x2B), (0x20, 0x2C), (0x44,), (0x75,), (0x76,), (0xFF,), (0x00,))
INVALID = ((0x20,), (0x20, 0x24, 0), (0x20, 0x26), (0x20, 0x26, 1), (0x20, 0x26, 251),
           (0x20, 0x27, 1, 0, 2), (0x20, 0x27, 0, 0, 9, 0), (0x20, 0x27, 9, 0, 8, 0),
           (0x20, 0x27, 1, 0, 106, 1), (0x20, 0x28, 5, 1, 0), (0x30,), (0x30, 2), (0x30, 1, 0),
           (0x31, 0), (0x36,), (0x36, 1), (0x37, 1, 0), (0x3B, 180, 0), (0x74, 1), (0x10, 0))
INSTALLATION_ALONE = ((0x66, 1), (0x77, *bytes(34)), (0x7C, *bytes(84)))


class TestCommands(unittest.TestCase):
    def setUp(self):
        self.host = Host()

    def both_modes(self):
        """Runs a test in monitoring and in installation mode."""
        for prepare in (lambda host: None, Host.install):
            self.host = Host()
            prepare(self.host)
            with self.subTest(mode=self.host.device.state.mode):
                yield self.host

    def test_acknowledge_and_refuse(self):
        """TL 23, 24: within 60 ms; later than a driver that clears its input, and before one that
        asks again after 6 ms"""
        self.host.write(frame(b"\x31"))
        times = [round(time - 1.0, 6) for time, _ in self.host.run(0.5)]
        self.assertEqual(times, [0.004, 0.010])
        bad = frame(b"\x31")[:-1] + b"\x00"
        self.assertEqual(self.host.exchange(bad), b"\x15")
        self.assertEqual(self.host.exchange(frame(b"\x31", 3)), b"")

    def test_left_out_and_invalid(self):
        """TL 39: 92h"""
        for host in self.both_modes():
            for command in (*LEFT_OUT, *INVALID):
                self.assertEqual(host.ask(*command), NOT_POSSIBLE, bytes(command).hex(" "))

    def test_installation_alone(self):
        """TL 122"""
        for command in INSTALLATION_ALONE:
            self.assertEqual(self.host.ask(*command), NOT_POSSIBLE)
        self.host.install()
        self.assertEqual(self.host.ask(0x66, 1), b"\xe6\x01\x01")
        self.assertEqual(self.host.ask(0x7C, *range(84)), b"\xfc\x01" + bytes(range(84)))
        self.assertEqual(self.host.ask(0x7B), b"\xfb" + bytes(range(84)))

    def test_the_password(self):
        """20h 00h and 20h 30h: TL, table 6-4"""
        for password in (b"", b"SICK", b"sick_lms", PASSWORD + b"S"):
            self.assertEqual(self.host.ask(0x20, 0x00, *password), b"\xa0\x01")
            self.assertEqual(self.host.ask(0x20, 0x30, *password), b"\xa0\x01")
        self.assertEqual(self.host.ask(0x20, 0x30, *PASSWORD), DONE)
        self.assertEqual(self.host.ask(0x31)[8], 0x25)
        self.assertEqual(self.host.ask(0x20, 0x00, *PASSWORD), DONE)
        self.assertEqual(self.host.ask(0x31)[8], 0x00)

    def test_modes(self):
        """TL 41; all modes can follow one another (TL 122), and the status names the mode."""
        for command in ((0x10,), (0x24,), (0x25,), (0x26, 2), (0x27, 1, 0, 9, 0),
                        (0x28, 2, 1, 0, 9, 0), (0x2A,)):
            for host in self.both_modes():
                found = split(host.exchange(frame(bytes((0x20, *command))), 0.02))
                self.assertEqual(found[1][:-1], DONE)
                self.assertEqual(host.device.state.mode, command[0])

    def test_type(self):
        """3Ah, in both modes (TL 122): 21 characters; drivers search them for the type"""
        for host in self.both_modes():
            self.assertEqual(host.ask(0x3A), b"\xbaLMS200;301063;V02.30 ")
        old = Host(make_device(firmware="2.10"))
        self.assertEqual(old.ask(0x3A), b"\xbaLMS200;301063;V02.10 ")

    def test_errors(self):
        """32h and 35h, in both modes (TL 122): no error; two words"""
        for host in self.both_modes():
            self.assertEqual(host.ask(0x32), b"\xb2")
            self.assertEqual(host.ask(0x35), b"\xb5" + bytes(4))

    def test_variants(self):
        """TL 47, 66: 180 degrees by 0.25 are refused; the answer has what holds"""
        for host in self.both_modes():
            for angle, step in ((180, 100), (180, 50), (100, 100), (100, 50), (100, 25)):
                held = bytes((angle, 0, step, 0))
                self.assertEqual(host.ask(0x3B, *held), b"\xbb\x01" + held)
                for refused in ((180, 0, 25, 0), (90, 0, 50, 0), (180, 0, 0, 0), (180, 1, 50, 0)):
                    self.assertEqual(host.ask(0x3B, *refused), b"\xbb\x00" + held)

    def test_a_variant_stops_the_stream(self):
        self.host.ask(0x20, 0x25)
        self.host.exchange(frame(b"\x20\x24"))
        self.host.ask(0x3B, 180, 0, 100, 0)
        self.assertEqual(self.host.run(5.0), [])


class TestRates(unittest.TestCase):
    """TL 21, 87"""

    def setUp(self):
        self.host = Host()

    def test_the_answer_has_the_old_rate(self):
        for code, rate, word in ((0x40, 38400, 0x8019), (0x41, 19200, 0x8033),
                                 (0x48, 500000, 0x8001), (0x42, 9600, 0x8067)):
            old = self.host.device.rate
            self.host.write(frame(bytes((0x20, code))))
            rates = []
            while self.host.device.next_time() is not None:
                rates.append(self.host.device.take(self.host.device.next_time()).rate)
            self.assertEqual(rates, [old, old])
            self.host.now += 0.1
            self.assertEqual(self.host.device.rate, rate)
            self.assertEqual(int.from_bytes(self.host.ask(0x31)[116:118], "little"), word)

    def test_a_reset(self):
        """TL 38: 91h, and 90h with the type when the device is ready, at the rate of power-on"""
        for permanent, rate in ((0, 9600), (1, 38400)):
            host = Host()
            host.ask(0x20, 0x40)
            host.install()
            host.ask(0x66, permanent)
            host.write(frame(b"\x10"))
            sent = host.run(5.0)
            found = split(b"".join(data for _, data in sent))
            self.assertEqual(found, [6, b"\x91\x10", b"\x90LMS200;301063;V02.30 \x10"])
            self.assertGreater(sent[2][0] - sent[1][0], 0.1)
            self.assertEqual(host.device.rate, rate)
            self.assertEqual(host.ask(0x31)[8], 0x25)

    def test_no_command_during_a_reset(self):
        self.host.exchange(frame(b"\x10"), 1.0)
        self.assertEqual(split(self.host.exchange(frame(b"\x31"), 2.0))[0][0], 0x90)

    def test_a_command_without_a_host_takes_effect(self):
        """A host that closes its port does not keep the device at the old rate."""
        self.host.write(frame(b"\x20\x40"))
        self.host.device.skip(self.host.now + 0.1)
        self.assertEqual(self.host.device.rate, 38400)


class TestNewCommands(unittest.TestCase):
    """TL 24: a command breaks off what the device is sending, or is about to send."""

    def setUp(self):
        self.host = Host()

    def send_both(self, first, second, delay, seconds=0.5):
        """What follows the second command, which comes before the answer to the first one."""
        self.host.write(frame(first))
        self.assertLessEqual(len(self.host.run(delay)), 1)  # ACK at most
        self.host.write(frame(second))
        return self.host.run(seconds)

    def test_a_new_command_cancels_answers(self):
        found = split(b"".join(data for _, data in self.send_both(b"\x3a", b"\x31", 0.002)))
        self.assertEqual([6, 0xB1], [found[0], found[1][0]])
        self.assertEqual(len(found), 2)

    def test_a_change_of_rate_whose_answer_is_cancelled(self):
        """TL 87; some drivers ask again after 6 ms."""
        for delay in (0.001, 0.006):
            self.host = Host()
            sent = self.send_both(b"\x20\x40", b"\x31", delay)
            found = split(b"".join(data for _, data in sent))
            self.assertEqual([6, 0xB1], [found[0], found[1][0]])
            self.assertEqual(len(found), 2)
            self.assertEqual(found[1][116:118], b"\x19\x80")
            self.assertEqual(self.host.device.rate, 38400)

    def test_a_reset_whose_answer_is_cancelled(self):
        """TL 38: 90h with the type when the device is ready, at the rate of power-on"""
        for delay in (0.001, 0.006):
            self.host = Host()
            self.host.ask(0x20, 0x40)
            self.host.exchange(frame(b"\x20\x24"), 2.0)
            start = self.host.now + delay
            sent = self.send_both(b"\x10", b"\x31", delay, 5.0)
            self.assertEqual([(round(time - start, 6), split(data)) for time, data in sent],
                             [(2.0, [b"\x90LMS200;301063;V02.30 \x10"])])
            self.assertEqual(self.host.device.rate, 9600)
            self.assertEqual(self.host.ask(0x31)[8], 0x25)


if __name__ == "__main__":
    unittest.main()
