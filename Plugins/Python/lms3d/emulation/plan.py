# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the device is going to send, and when."""

from dataclasses import dataclass
from typing import Callable, Optional

from .fan import FanRecord


@dataclass(frozen=True)
class Sending:
    """Bytes for the host.

    rate: of the device at that time; the host receives nothing at another rate. fan: the record, if
    the bytes have measured values.
    """

    data: bytes
    rate: int
    fan: Optional[FanRecord] = None


@dataclass
class Planned:
    """Something that is due at a time.

    make: returns the bytes, and the record of a fan or None. Casting a fan takes a while, so make
    is called up to `lead` seconds before the time. then: called after that, with the time.
    """

    due: float
    make: Callable
    then: Optional[Callable] = None
    lead: float = 0.0
    made: Optional[tuple] = None


class SendingQueue:
    """Planned bytes, in the order of their times."""

    def __init__(self):
        self._planned = []

    def plan(self, planned):
        """Add something that is due after all others."""
        self._planned.append(planned)

    def clear(self):
        """Cancel everything."""
        self._planned.clear()

    def next_time(self):
        """When `take` has something to do next, or None."""
        if not self._planned:
            return None
        first = self._planned[0]
        return first.due if first.made else first.due - first.lead

    def take(self, now, send):
        """Prepare what is due soon, and return a Sending if it is due now, otherwise None.

        send: a function that returns the Sending of bytes, and the record of a fan or None.
        """
        if not self._planned or now < self.next_time():
            return None
        first = self._planned[0]
        if not first.made:
            first.made = first.make()
        if now < first.due:
            return None
        del self._planned[0]
        sending = send(*first.made)
        if first.then:
            first.then(now)
        return sending

    def skip(self, now):
        """Drop what is due, and do what follows it."""
        while self._planned and self._planned[0].due <= now:
            first = self._planned.pop(0)
            if first.then:
                first.then(now)
