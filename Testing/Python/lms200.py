# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""An LMS 200 without a terminal, and fans that it can measure, for tests of the emulator."""

import numpy as np

from lms3d.emulation.crc import compute_crc
from lms3d.emulation.device import Device
from lms3d.emulation.fan import Fan
from lms3d.emulation.measured_values import MILLIMETRES
from lms3d.emulation.state import make_state
from lms3d.emulation.telegrams import FRAME_SIZE, frame

ACKNOWLEDGE = 0x06
PASSWORD = b"SICK_LMS"


class Ramp:
    """Fans whose range grows by 1 mm from beam to beam, from 1 m on."""

    def __init__(self):
        self.confirmed = 0
        self.times = []

    def measure(self, variant, part, time, means):
        self.times.append(time)
        ranges = 1.0 + np.arange(variant.count) / 1000
        return Fan(ranges if part is None else ranges[part::variant.parts], 10.0 * self.confirmed)

    def confirm(self, _record):
        self.confirmed += 1


def make_device(unit=MILLIMETRES, firmware="2.30", fans=None, **options):
    """A device at the time 0."""
    return Device(make_state(unit, firmware), fans or Ramp(), 0.0, **options)


def split(data):
    """The payloads in bytes of the device, and single bytes such as ACK; checks their frames."""
    found = []
    while data:
        if data[0] != 0x02:
            found.append(data[0])
            data = data[1:]
            continue
        end = int.from_bytes(data[2:4], "little") + FRAME_SIZE
        assert data[1] == 0x80 and compute_crc(data[:end - 2]) == data[end - 2:end], data.hex(" ")
        found.append(data[4:end - 2])
        data = data[end:]
    return found


class Host:
    """Talks to a device, with a clock that it moves."""

    def __init__(self, device=None):
        self.device = device or make_device()
        self.now = 1.0

    def write(self, data):
        self.device.receive(data, self.now)

    def run(self, seconds):
        """What the device sends in a time: pairs of times and bytes."""
        end = self.now + seconds
        sent = []
        while True:
            due = self.device.next_time()
            if due is None or due > end:
                break
            self.now = max(self.now, due)
            sending = self.device.take(self.now)
            if sending:
                sent.append((self.now, sending.data))
                if sending.fan:
                    self.device.confirm(sending.fan)
        self.now = end
        return sent

    def send(self, data, seconds):
        """What the device sends in a time after bytes: pairs of times and bytes."""
        self.write(data)
        return self.run(seconds)

    def exchange(self, data, seconds=0.5):
        """The bytes that the device sends after bytes."""
        return b"".join(data for _, data in self.send(data, seconds))

    def ask(self, *payload):
        """The payload of the answer to a command; checks ACK and the status byte."""
        found = split(self.exchange(frame(bytes(payload))))
        assert len(found) == 2 and found[0] == ACKNOWLEDGE and found[1][-1] == 0x10, found
        return found[1][:-1]

    def install(self):
        """Switch to the installation mode."""
        assert self.ask(0x20, 0x00, *PASSWORD) == b"\xa0\x00"

    def configure(self, **changes):
        """Change bytes of the configuration: availability, mode, unit."""
        self.install()
        configuration = bytearray(self.ask(0x74)[1:])
        for name, value in changes.items():
            configuration[{"availability": 4, "mode": 5, "unit": 6}[name]] = value
        assert self.ask(0x77, *configuration)[:2] == b"\xf7\x01"
        assert self.ask(0x20, 0x25) == b"\xa0\x00"
