# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The status of the device, which the command 31h reads: 152 bytes."""

from .state import RATE_WORDS
from .variants import TURNS_PER_SECOND

_SIZE = 153  # with the code of the answer, from which TL counts

_VERSION = 1
_MODE = 8
_VARIANT = 18
_MOTOR_PERIODS = 67
_MEASURING_MODE = 102
_ANGLE = 107
_STEP = 109
_RESTART_MODE = 111
_RATE = 116
_EVALUATIONS = 118
_PERMANENT_RATE = 119
_UNIT = 122
_BOOT_VERSION = 124

_SCANNER_TYPE = 0  # LMS 200
_MOTOR_PERIOD = 1_000_000 // TURNS_PER_SECOND // 90  # microseconds of 1/90 of a turn
_BOOT = b"V02.00 "


def encode_status(state):
    """The data of the answer to 31h."""
    status = bytearray(_SIZE)

    def put(index, data):
        status[index:index + len(data)] = data

    put(_VERSION, state.version)
    put(_MODE, bytes((state.mode,)))
    put(_VARIANT, bytes((_SCANNER_TYPE,)))
    put(_MOTOR_PERIODS, _MOTOR_PERIOD.to_bytes(2, "little"))
    put(_MEASURING_MODE, bytes((state.configuration.measuring_mode,)))
    put(_ANGLE, state.variant.angle.to_bytes(2, "little"))
    put(_STEP, state.variant.step.to_bytes(2, "little"))
    configuration = bytes(state.configuration)
    put(_RESTART_MODE, configuration[10:12])
    put(_RATE, RATE_WORDS[state.rate].to_bytes(2, "little"))
    put(_EVALUATIONS, configuration[9:10])
    put(_PERMANENT_RATE, bytes((state.is_rate_permanent,)))
    put(_UNIT, bytes((state.configuration.unit,)))
    put(_BOOT_VERSION, _BOOT)
    return bytes(status[1:])
