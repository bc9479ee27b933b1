# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The platform's angle of each fan that a host has received, as lines of text."""

import os
import select
from collections import deque
from contextlib import suppress

from ..messages import say
from ..problems import Problem

_HEADER = "turn,telegram,time,angle\n"
_MAXIMUM_LINES = 100_000  # that wait for a reader


class AngleLines:
    """Writes lines to a descriptor when they find room, so that a slow reader stops nothing.

    time_offset: added to the times of the records.
    """

    def __init__(self, descriptor, name, time_offset=0.0):
        self._descriptor = descriptor
        self._name = name
        self._time_offset = time_offset
        self._lines = deque([_HEADER])
        self._has_lost = False
        self.flush()

    def add(self, record):
        """Write the line of a FanRecord, or keep it until there is room."""
        if len(self._lines) < _MAXIMUM_LINES:
            self._lines.append(f"{record.turn},{record.telegram},"
                               f"{record.time + self._time_offset:.6f},{record.angle!r}\n")
        elif not self._has_lost:
            self._has_lost = True
            say(f"warning: {self._name} is not read; lines of angles are lost")
        self.flush()

    def finish(self):
        """Write the rest at the end; says how many lines are lost because they were not read."""
        with suppress(Problem):  # the reader may have ended with the command
            self.flush()
        if self._lines:
            say(f"warning: {self._name} was not read; the last {len(self._lines):,} lines of angles "
                "are lost")

    def flush(self):
        """Write the lines for which there is room."""
        while self._lines and select.select([], [self._descriptor], [], 0)[1]:
            try:
                # A pipe is ready only if it has room for more than a line.
                os.write(self._descriptor, self._lines[0].encode("ascii"))
            except OSError as error:
                raise Problem(
                    f"cannot write the angles to {self._name}: {error.strerror}") from error
            self._lines.popleft()
