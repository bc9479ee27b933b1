# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The check sum of a telegram (TL 107).

Each step shifts the register of 16 bits by one, with feedback, and adds the byte together with the
byte before it. All of that is linear: so the check sum is the sum (exclusive or) of one number for
each bit that is set, which depends on the bit's place and on how many bytes follow it.
"""

import numpy as np

_POLYNOMIAL = 0x8005
# More than a telegram of a host has (TL 22); 401 values with a sub-range and indices take 819 bytes.
_MAXIMUM_SIZE = 1024


def _shift(registers):
    return registers << 1 & 0xFFFF ^ np.where(registers & 0x8000, _POLYNOMIAL, 0)


def _make_table():
    """The numbers of the bits of the longest telegram, in their order."""
    values = 0x80 >> np.arange(8)
    rows = [values]
    current, before = _shift(values), values << 8
    for _ in range(1, _MAXIMUM_SIZE):
        rows.append(current ^ before)
        current, before = _shift(current), _shift(before)
    return np.array(rows, np.uint16)[::-1].ravel()


_TABLE = _make_table()


def compute_crc(data):
    """The check sum of bytes, as two bytes, low byte first."""
    bits = np.unpackbits(np.frombuffer(data, np.uint8))
    numbers = bits * _TABLE[len(_TABLE) - len(bits):]
    return int(np.bitwise_xor.reduce(numbers)).to_bytes(2, "little")
