# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The state of the device: what its commands read and change, without any time."""

from dataclasses import dataclass, field
from typing import Optional

from .configuration import Configuration
from .variants import FANS, VARIANTS, Output, Variant

POWER_ON_RATE = 9600

# The rates, and their words in the status.
RATE_WORDS = {500000: 0x8001, 38400: 0x8019, 19200: 0x8033, 9600: 0x8067}

FIRMWARES = ("2.30", "2.10")
_OLD_FIRMWARE = "2.10"

# Operating modes: the sub-commands of 20h.
INSTALLATION = 0x00
DIAGNOSIS = 0x10
CONTINUOUS = 0x24
ON_REQUEST = 0x25

_LAST_BLOCK_SIZE = 84  # of the commands 7Bh and 7Ch


@dataclass
class State:
    """Everything that a command can change.

    fans: the fans that can be measured. stream: what the device sends without being
    requested, or None.
    """

    configuration: Configuration
    firmware: str = FIRMWARES[0]
    fans: tuple = FANS
    variant: Variant = Variant()
    mode: int = ON_REQUEST
    stream: Optional[Output] = None
    rate: int = POWER_ON_RATE
    is_rate_permanent: bool = False
    last_block: bytes = field(default=bytes(_LAST_BLOCK_SIZE))

    @property
    def type_name(self):
        """The device's type and version, 21 characters; drivers search it for the type."""
        return f"LMS200;301063;V{self.firmware:0>5} ".encode("ascii")

    @property
    def version(self):
        """The version of the firmware, 7 characters."""
        return f"V{self.firmware:0>5} ".encode("ascii")

    def can_be(self, variant):
        """Whether the device can have a variant."""
        return variant in VARIANTS and variant in self.fans

    @property
    def power_on_rate(self):
        """The rate after a reset."""
        return self.rate if self.is_rate_permanent else POWER_ON_RATE

    def restart(self):
        """What a reset changes, except the rate."""
        self.mode = ON_REQUEST
        self.stream = None


def make_state(unit, firmware, fans=FANS):
    """The state of a device after power-on, in the variant 180 degrees by 0.5 if it is possible."""
    known = [variant for variant in VARIANTS if variant in fans]
    return State(Configuration(unit, firmware == _OLD_FIRMWARE), firmware, fans,
                 Variant() if Variant() in known else known[-1])
