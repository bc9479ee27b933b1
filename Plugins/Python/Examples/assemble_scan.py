#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Assembles a 3D scan from the telegrams of an LMS 200 and the angles of its platform.

    lms3d emulate room.wrl --position 0.3 -0.2 1 --link /tmp/lms200 --angles /tmp/angles.csv
    python3 assemble_scan.py /tmp/lms200 /tmp/angles.csv 360 > points.csv

Needs Python's standard library only. The points are in the frame of the sensor, metres.
"""

import math
import os
import select
import struct
import sys
import termios
import time

RATES = {9600: termios.B9600, 19200: termios.B19200, 38400: termios.B38400, 500000: termios.B500000}
COMMAND_OF_RATE = {38400: 0x40, 19200: 0x41, 9600: 0x42, 500000: 0x48}
NO_DISTANCE = 16375  # and all values above it, with 14 bits


def compute_crc(data):
    register = previous = 0
    for byte in data:
        register = register << 1 ^ (0x18005 if register & 0x8000 else 0)
        register ^= previous << 8 | byte
        previous = byte
    return struct.pack("<H", register)


class Device:
    """An LMS 200 on a serial port."""

    def __init__(self, port):
        self._port = os.open(port, os.O_RDWR | os.O_NOCTTY)
        self._bytes = b""

    def set_rate(self, rate):
        attributes = termios.tcgetattr(self._port)
        attributes[:4] = [0, 0, termios.CS8 | termios.CREAD | termios.CLOCAL, 0]
        attributes[4] = attributes[5] = RATES[rate]
        termios.tcsetattr(self._port, termios.TCSAFLUSH, attributes)
        self._bytes = b""

    def send(self, *payload):
        telegram = struct.pack("<BBH", 2, 0, len(payload)) + bytes(payload)
        os.write(self._port, telegram + compute_crc(telegram))

    def receive(self, code, seconds=3.0):
        """The data of the next telegram with a code, without its status byte, or None."""
        end = time.monotonic() + seconds
        while True:
            payload = self._take()
            if payload and payload[0] == code:
                return payload[1:-1]
            wait = end - time.monotonic()
            if payload is None:
                if wait <= 0 or not select.select([self._port], [], [], wait)[0]:
                    return None
                self._bytes += os.read(self._port, 4096)

    def ask(self, code, *payload):
        """The data of the answer to a command."""
        self.send(*payload)
        answer = self.receive(code)
        if answer is None:
            sys.exit(f"the device does not answer the command {payload[0]:02X}h")
        return answer

    def _take(self):
        """The next payload in the bytes that have arrived, or None."""
        while True:
            start = self._bytes.find(b"\x02\x80")
            self._bytes = self._bytes[start:]  # without a start, the last byte may be one
            if len(self._bytes) < 4:
                return None
            end = struct.unpack_from("<H", self._bytes, 2)[0] + 6
            if len(self._bytes) < end <= 812:
                return None
            if end <= 812 and compute_crc(self._bytes[:end - 2]) == self._bytes[end - 2:end]:
                payload, self._bytes = self._bytes[4:end - 2], self._bytes[end:]
                return payload
            self._bytes = self._bytes[1:]


def find_device(port):
    """The device, at the rate that it has."""
    device = Device(port)
    for rate in RATES:
        device.set_rate(rate)
        device.send(0x20, 0x25)  # stops a stream
        if device.receive(0xA0, 0.3):
            return device
    sys.exit(f"no device answers on {port}")


def set_up(device):
    """180 degrees by 0.5, millimetres up to 16 m, indices after the values, 500000 Bd."""
    device.ask(0xBB, 0x3B, 180, 0, 50, 0)
    device.ask(0xA0, 0x20, 0x00, *b"SICK_LMS")
    configuration = bytearray(device.ask(0xF4, 0x74))
    configuration[4:7] = 0x02, 0x03, 0x01
    device.ask(0xF7, 0x77, *configuration)
    device.ask(0xA0, 0x20, 0x25)
    device.ask(0xA0, 0x20, COMMAND_OF_RATE[500000])
    device.set_rate(500000)


def receive_fan(device):
    """The distances of a fan in metres, None without a distance; and its two indices."""
    data = device.receive(0xB0)
    if data is None:
        sys.exit("no measured values arrive")
    count = struct.unpack_from("<H", data)[0] & 0x3FF
    values = struct.unpack_from(f"<{count}H", data, 2)
    distances = [(value & 0x3FFF) / 1000 if value & 0x3FFF < NO_DISTANCE else None
                 for value in values]
    return distances, tuple(data[2 + 2 * count:])


def follow(path):
    """The lines of a file that grows, or of a pipe."""
    line = ""
    with open(path, encoding="ascii") as file:
        while True:
            line += file.readline()
            if line.endswith("\n"):
                yield line.rstrip().split(",")
                line = ""
            else:
                time.sleep(0.002)


def to_point(distance, beam, beta):
    """The point of a beam, in the frame of the sensor."""
    alpha, beta = math.radians(beam / 2 - 90), math.radians(beta)
    return (distance * math.cos(alpha) * math.cos(beta),
            -distance * math.cos(alpha) * math.sin(beta), distance * math.sin(alpha))


def main(port, angles, count):
    lines = follow(angles)
    next(lines)  # the names of the columns
    device = find_device(port)
    set_up(device)
    device.ask(0xA0, 0x20, 0x24)
    print("x,y,z,Range,Beam,Beta")
    for _ in range(int(count)):
        distances, indices = receive_fan(device)
        # The file has a line for each fan that was received, also by earlier hosts.
        beta = next(float(angle) for turn, telegram, _, angle in lines
                    if (int(turn), int(telegram)) == indices)
        for beam, distance in enumerate(distances):
            if distance is not None:
                point = to_point(distance, beam, beta)
                print(*(f"{value:.6f}" for value in point), distance, beam, beta, sep=",")
    device.send(0x20, 0x25)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit("usage: assemble_scan.py PORT ANGLES NUMBER_OF_FANS")
    main(*sys.argv[1:])
