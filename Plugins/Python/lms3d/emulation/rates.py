# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The rate that a host has set on a pseudo-terminal."""

import fcntl
import struct
import sys
import termios

# Linux: the request TCGETS2, and where its structure has the output rate as a number.
_TCGETS2 = 0x802C542A
_TERMIOS2 = struct.Struct("=4I20B2I")

_FAST_RATE = 500000
# Hosts whose system has no 500000 Bd set another rate: 38400 with a divisor of their own (which a
# pseudo-terminal does not show), or a rate that their hardware takes for 500000.
_STAND_INS = (38400, 57600, 115200, 230400, 460800)


def read_rate(terminal):
    """The rate of a terminal, bits a second; any number is possible."""
    if sys.platform == "linux":
        answer = fcntl.ioctl(terminal, _TCGETS2, bytes(_TERMIOS2.size))
        return _TERMIOS2.unpack(answer)[-1]
    code = termios.tcgetattr(terminal)[5]
    return next((rate for rate in (9600, 19200, 38400)
                 if code == getattr(termios, f"B{rate}")), code)


def set_rate(terminal, code):
    """Set the rate of a terminal, a constant of termios."""
    attributes = termios.tcgetattr(terminal)
    attributes[4] = attributes[5] = code
    termios.tcsetattr(terminal, termios.TCSANOW, attributes)


def fits(host_rate, device_rate):
    """Whether host and device understand one another."""
    return host_rate == device_rate or device_rate == _FAST_RATE and host_rate in _STAND_INS
