# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The check sum of a telegram (TL 107)."""

_POLYNOMIAL = 0x8005


def compute_crc(data):
    """The check sum of bytes, as two bytes, low byte first.

    Each step shifts the register, and adds the byte together with the byte before it.
    """
    register = previous = 0
    for byte in data:
        carry = register & 0x8000
        register = (register & 0x7FFF) << 1
        if carry:
            register ^= _POLYNOMIAL
        register ^= previous << 8 | byte
        previous = byte
    return register.to_bytes(2, "little")
