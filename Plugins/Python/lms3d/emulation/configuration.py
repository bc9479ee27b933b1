# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The configuration of the device, which the commands 74h and 77h read and write (TL 31, 96)."""

from .measured_values import DISTANCE_BITS, UNITS_PER_METRE

_SIZE = 34
_OLD_SIZE = 32  # before firmware V2.30
MINIMUM_SIZE = 7  # of a new configuration

_STOP_THRESHOLD = 2
_AVAILABILITY = 4
_MEASURING_MODE = 5
_UNIT = 6
_HAS_INDICES = 2  # bit of the availability

_DEFAULTS = {_STOP_THRESHOLD: 0x70, 9: 2, 10: 2, 12: 2, 30: 2, 31: 2, 32: 2}


class Configuration:
    """The bytes of the configuration, and what some of them mean."""

    def __init__(self, unit, is_old=False):
        self._bytes = bytearray(_DEFAULTS.get(i, 0) for i in range(_SIZE))
        self._bytes[_UNIT] = unit
        self._size = _OLD_SIZE if is_old else _SIZE

    def __bytes__(self):
        return bytes(self._bytes[:self._size])

    @property
    def has_indices(self):
        """Whether the mirror's turn and the number of the telegram follow the measured values."""
        return bool(self._bytes[_AVAILABILITY] & _HAS_INDICES)

    @property
    def measuring_mode(self):
        """A key of DISTANCE_BITS."""
        return self._bytes[_MEASURING_MODE]

    @property
    def unit(self):
        """A key of UNITS_PER_METRE."""
        return self._bytes[_UNIT]

    def change(self, data):
        """Take new bytes; returns whether they are valid. Missing bytes keep their values (TL 25).

        Bytes beyond the configuration are ignored.
        """
        if (len(data) < MINIMUM_SIZE or data[_MEASURING_MODE] not in DISTANCE_BITS
                or data[_UNIT] not in UNITS_PER_METRE):
            return False
        known = data[:self._size]
        self._bytes[:len(known)] = known
        return True
