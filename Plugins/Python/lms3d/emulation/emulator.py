# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Joins a device with its terminal."""

import select
import time

from .rates import fits

# A pseudo-terminal does not announce a host, so it is looked for that often. Drivers wait a few
# milliseconds for an answer.
_PAUSE = 0.005
_MAXIMUM_WAIT = 0.5


class Emulator:
    """A device on a terminal. fans: number of fans that hosts have received.

    stop: a descriptor that becomes readable when the emulator must end. lines: AngleLines or None.
    """

    def __init__(self, device, terminal, stop, lines=None):
        self._device = device
        self._terminal = terminal
        self._stop = stop
        self._lines = lines
        self.fans = 0

    def run(self):
        """Serve hosts until the end."""
        has_host = self._terminal.has_host()
        while True:
            must_end, has_news = self._wait(has_host)
            if must_end:
                return
            now = time.monotonic()
            if has_news:
                # A host that was here for a moment only may have left a command.
                self._receive(now)
            if has_host:
                self._terminal.flush()
                self._send()
            else:
                self._device.skip(now)
            if self._lines:
                self._lines.flush()
            if has_news:
                has_host = self._terminal.has_host()

    def _wait(self, has_host):
        """Wait until there is something to do.

        Returns whether the emulator must end, and whether bytes may have arrived or the host may have
        come or gone.
        """
        if not has_host:
            return bool(select.select([self._stop], [], [], _PAUSE)[0]), True
        due = self._device.next_time()
        wait = _MAXIMUM_WAIT if due is None else due - time.monotonic()
        writers = [self._terminal] if self._terminal.is_behind else []
        ready = select.select([self._stop, self._terminal], writers, [],
                              min(max(wait, 0.0), _MAXIMUM_WAIT))[0]
        return self._stop in ready, self._terminal in ready

    def _receive(self, now):
        data = self._terminal.read()
        # At another rate a device receives noise.
        if data and fits(self._terminal.rate, self._device.rate):
            self._device.receive(data, now)

    def _send(self):
        """Send what is due, and prepare what is due soon."""
        while True:
            sending = self._device.take(time.monotonic())
            if sending is None:
                return
            if (fits(self._terminal.rate, sending.rate) and self._terminal.write(sending.data)
                    and sending.fan):
                self.fans += 1
                self._device.confirm(sending.fan)
                if self._lines:
                    self._lines.add(sending.fan)
