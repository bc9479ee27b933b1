# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A running `lms3d emulate`, and a host on its port, for tests."""

import os
import re
import select
import subprocess
import sys
import termios
import time

from command_line import POSE, ROOM
from lms200 import split
from lms3d.emulation.telegrams import frame

RATES = {rate: getattr(termios, f"B{rate}")
         for rate in (9600, 19200, 38400, 57600, 115200, 230400, 460800, 500000)}


class EmulatorProcess:
    """A process; a context manager, which ends it. Without arguments it has the room."""

    def __init__(self, *arguments, **options):
        words = arguments or (ROOM, *POSE)
        self.process = subprocess.Popen(
            [sys.executable, "-m", "lms3d", "emulate", *map(str, words)],
            **{"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True, **options})
        self.lines = []
        if options.get("stderr") is None:
            self.lines = self._read_lines()

    def _read_lines(self):
        """The lines up to the one with the port."""
        lines = []
        for line in self.process.stdout:
            lines.append(line.rstrip("\n"))
            if line.startswith("port "):
                break
        return lines

    @property
    def port(self):
        """The name of the pseudo-terminal."""
        return re.match(r"port +(/dev/\S+?)(,|$)", self.lines[-1])[1]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.terminate()
        self.finish()

    def finish(self):
        """The exit code and what it prints at the end."""
        rest, _ = self.process.communicate(timeout=60)
        return self.process.returncode, rest

    def seconds(self):
        """The processor time that the main thread has taken."""
        with open(f"/proc/{self.process.pid}/schedstat", encoding="ascii") as file:
            return int(file.read().split()[0]) * 1e-9


class PortHost:
    """A host that has the port open; a context manager. It finds the port as it is."""

    def __init__(self, port):
        self.file = os.open(port, os.O_RDWR | os.O_NOCTTY)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.file)

    def set_rate(self, rate):
        attributes = termios.tcgetattr(self.file)
        attributes[4] = attributes[5] = RATES[rate]
        termios.tcsetattr(self.file, termios.TCSAFLUSH, attributes)

    def write(self, data):
        os.write(self.file, data)

    def read(self, seconds, is_enough=lambda data: False):
        """The bytes that arrive in a time, or until there are enough."""
        data, end = b"", time.monotonic() + seconds
        while not is_enough(data):
            wait = end - time.monotonic()
            if wait <= 0 or not select.select([self.file], [], [], wait)[0]:
                break
            data += os.read(self.file, 65536)
        return data

    def ask(self, *payload, seconds=5.0):
        """The answer to a command without ACK and status, or None."""
        self.write(frame(bytes(payload)))

        def is_whole(data):
            return len(data) > 5 and len(data) >= 7 + int.from_bytes(data[3:5], "little")

        data = self.read(seconds, is_whole)
        return split(data)[1][:-1] if data else None

    def read_telegrams(self, count, seconds=10.0):
        """A number of telegrams, with the times of their arrival."""
        found, data, end = [], b"", time.monotonic() + seconds
        while len(found) < count and time.monotonic() < end:
            data += self.read(0.5, len)
            now = time.monotonic()
            while len(data) > 4 and len(data) >= int.from_bytes(data[2:4], "little") + 6:
                size = int.from_bytes(data[2:4], "little") + 6
                found.append((now, split(data[:size])[0]))
                data = data[size:]
        return found[:count]  # the last bytes can have more than one

    def go_to(self, rate):
        """Switch device and host to a rate."""
        code = {9600: 0x42, 19200: 0x41, 38400: 0x40, 500000: 0x48}[rate]
        assert self.ask(0x20, code) == b"\xa0\x00"
        time.sleep(0.05)
        self.set_rate(rate)

    def start_stream(self):
        """Start a stream; reads its answer."""
        assert self.ask(0x20, 0x24) == b"\xa0\x00"
