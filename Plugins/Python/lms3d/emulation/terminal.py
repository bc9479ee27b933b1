# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A pseudo-terminal: the side of the device. A host opens its name like a serial port."""

import os
import select
import termios

from .rates import read_rate, set_rate

_PIECE = 1024
_BITS = termios.CS8 | termios.CREAD | termios.CLOCAL
_RATE_BITS = getattr(termios, "CBAUD", 0)


class Terminal:
    """Sends whole telegrams, without waiting for the host. A context manager.

    name: of the port that a host opens.
    """

    def __init__(self):
        self._master, slave = os.openpty()
        self.name = os.ttyname(slave)
        try:
            set_rate(self._master, termios.B9600)
            self._make_raw()
            os.set_blocking(self._master, False)
        finally:
            # While this process has the port open, it does not see that the host has left.
            os.close(slave)
        self._rest = b""
        self._had_host = False
        self._poll = select.poll()
        self._poll.register(self._master, 0)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self._master)

    @property
    def rate(self):
        """The rate that the host has set."""
        return read_rate(self._master)

    def fileno(self):
        """The descriptor, for select."""
        return self._master

    def has_host(self):
        """Whether a host has the port open. After it has left, the port is as new."""
        has_host = not any(event & select.POLLHUP for _, event in self._poll.poll(0))
        if self._had_host and not has_host:
            self._make_raw()
            self._rest = b""
        self._had_host = has_host
        return has_host

    def read(self):
        """What the host has sent; nothing if there is nothing, or no host."""
        try:
            return os.read(self._master, _PIECE)
        except OSError:  # EAGAIN, or EIO without a host
            return b""

    def write(self, data):
        """Send a whole telegram; returns False if it is lost, because the host reads too slowly.

        If a part of it found room, the rest follows before the next telegram.
        """
        self.flush()
        if self._rest:
            return False
        done = self._try(data)
        if done:
            self._rest = data[done:]
        return done > 0

    @property
    def is_behind(self):
        """Whether the rest of a telegram waits for room."""
        return bool(self._rest)

    def flush(self):
        """Send the rest of a telegram, as far as there is room."""
        self._rest = self._rest[self._try(self._rest):]

    def _try(self, data):
        """The number of bytes that found room."""
        try:
            return os.write(self._master, data) if data else 0
        except OSError:
            return 0

    def _make_raw(self):
        """Bytes pass unchanged and without echo; what the host has not read is lost.

        The rate stays, as that of an ordinary port does.
        """
        _, _, control, _, *rates, characters = termios.tcgetattr(self._master)
        control = control & ~(termios.CSIZE | termios.PARENB | termios.CSTOPB) | _BITS
        termios.tcflush(self._master, termios.TCOFLUSH)
        for each in (rates, [termios.B9600] * 2):
            try:
                termios.tcsetattr(self._master, termios.TCSAFLUSH,
                                  [0, 0, control, 0, *each, characters])
                return
            except termios.error:  # a rate without a name
                control &= ~_RATE_BITS
