# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""An LMS 200 without a terminal: bytes go in, bytes with their times come out.

All methods take the time, seconds of a clock that never goes back, so no test needs a clock.
"""

import math

from .commands import execute
from .fan import FanRecord
from .measured_values import encode_count, encode_output, encode_ranges
from .plan import Planned, Sending, SendingQueue
from .telegrams import ACKNOWLEDGE, REFUSE, TelegramReader, frame_answer
from .variants import BITS_PER_BYTE, TURNS_PER_SECOND, interval

# Seconds. The device may take 60 ms (TL 24). Some drivers clear their input after they have
# written, and others send a command again after 6 ms.
ACKNOWLEDGE_DELAY = 0.004
ANSWER_DELAY = 0.010
SLOW_ANSWER_DELAY = 0.4  # for the permanent memory
# A driver that receives the end of the reset with its beginning loses one of both.
RESET_TIME = 2.0

# A fan is cast when the last of its mirror turns begins. In a stream this is often the moment when the
# telegram before it is sent, so the process wakes up once for both.
CAST_LEAD = 1 / TURNS_PER_SECOND

_POWER_ON = 0x90


class Device:
    """The device.

    fans: measures; see platform.Stepped. is_paced_by_line: whether the rate limits the number of
    telegrams; otherwise only the mirror does.
    """

    def __init__(self, state, fans, now, is_paced_by_line=True):
        self.state = state
        self._fans = fans
        self._start = now
        self._is_paced_by_line = is_paced_by_line
        self._reader = TelegramReader()
        self._queue = SendingQueue()
        self._telegrams = 0
        self._ready_time = now
        self._line_free_time = now
        self._unfinished = None  # a Reply whose answer has not been sent

    @property
    def rate(self):
        """The rate at which the device sends and receives."""
        return self.state.rate

    def receive(self, data, now):
        """Take bytes that the host has sent at the device's rate."""
        if now < self._ready_time:
            return
        for payload in self._reader.read(data, now):
            self._break_off(now)
            if now < self._ready_time:  # what was broken off is a reset, which has begun
                return
            if payload is None:
                self._plan_bytes(now + ACKNOWLEDGE_DELAY, REFUSE, self._plan_stream)
            else:
                self._execute(payload, now)

    def next_time(self):
        """When `take` has something to do next, or None."""
        return self._queue.next_time()

    def take(self, now):
        """The next Sending that is due now, or None."""
        return self._queue.take(now, lambda data, fan: self._send(data, fan, now))

    def confirm(self, record):
        """Say that the host has received the telegram of a fan: the platform may turn."""
        self._fans.confirm(record)

    def skip(self, now):
        """Do what is due without sending anything: no host is there."""
        self._reader.clear()
        self._queue.skip(now)

    def _break_off(self, now):
        """Cancel what has not been sent (TL 24). What a cancelled answer announces happens now.

        The stream goes on after the answer to the new command, which may have changed it.
        """
        self._queue.clear()
        if self._unfinished:
            self._finish(now)

    def _send(self, data, fan, now):
        """The Sending of bytes, which the line carries after those that were sent before."""
        if self._is_paced_by_line:
            self._line_free_time = (max(self._line_free_time, now)
                                    + len(data) * BITS_PER_BYTE / self.rate)
        return Sending(data, self.rate, fan)

    def _execute(self, payload, now):
        reply = execute(self.state, payload)
        self._plan_bytes(now + ACKNOWLEDGE_DELAY, ACKNOWLEDGE)
        if reply.output:
            self._plan_request(reply.output, now)
            return
        self._unfinished = reply
        due = now + (SLOW_ANSWER_DELAY if reply.is_slow else ANSWER_DELAY)
        self._plan_bytes(due, frame_answer(reply.code, reply.data), self._go_on)

    def _go_on(self, now):
        """What follows the answer to a command."""
        self._finish(now)
        self._plan_stream(now)

    def _finish(self, now):
        """Change the rate or reset the device, if the answer announces it."""
        reply, self._unfinished = self._unfinished, None
        if reply.rate is not None:
            self.state.rate = reply.rate
        if reply.is_reset:
            self.state.rate = self.state.power_on_rate
            self._reader.clear()
            self._ready_time = now + RESET_TIME
            self._plan_bytes(self._ready_time, frame_answer(_POWER_ON, self.state.type_name))

    def _plan_bytes(self, due, data, then=None):
        self._queue.plan(Planned(due, lambda: (data, None), then))

    # --- Measured values --------------------------------------------------------------------------
    # Their times are numbers of mirror turns since the start, so that no rounding adds up.

    def _time(self, turn):
        return self._start + turn / TURNS_PER_SECOND

    def _turn(self, time):
        return (time - self._start) * TURNS_PER_SECOND

    def _plan_request(self, output, now):
        """Plan the measured values of a request.

        The mirror turns always, so the first turn may have begun already.
        """
        turns = output.turns(self.state.variant)
        first = math.floor(self._turn(now + ACKNOWLEDGE_DELAY))
        if self._time(first + turns) < now + ANSWER_DELAY:
            first += 1
        self._plan_output(output, first, self._plan_stream)

    def _plan_stream(self, now):
        """Plan the next telegram of a stream, after all others have been sent.

        Its scan is the first one that begins when the line is free.
        """
        if self.state.stream:
            first = math.ceil(self._turn(max(now, self._line_free_time)))
            self._plan_output(self.state.stream, first, lambda now: self._continue(first, now))

    def _continue(self, first, now):
        """Plan the telegram after the one whose scan began at the mirror turn `first`."""
        output, variant = self.state.stream, self.state.variant
        size = output.size(variant, self.state.configuration.has_indices)
        step = interval(output, variant, size, self.rate if self._is_paced_by_line else None)
        # More than one step if the computer has slept.
        late = self._turn(now) - (first + output.turns(variant))
        following = first + step * max(math.ceil(late / step), 1)
        self._plan_output(output, following, lambda later: self._continue(following, later))

    def _plan_output(self, output, first, then):
        def finish(now):
            self._telegrams += 1
            then(now)

        due = self._time(first + output.turns(self.state.variant))
        self._queue.plan(Planned(due, lambda: self._measure(output, first), finish, CAST_LEAD))

    def _measure(self, output, first):
        """The telegram of a scan that began at a mirror turn, and its record."""
        configuration = self.state.configuration
        variant = output.fan(self.state.variant)
        part = first % variant.parts if output.is_partial else None
        fan = self._fans.measure(variant, part, self._time(first), output.means or 1)
        ranges = fan.ranges
        if output.has_borders:
            ranges = ranges[output.first - 1:output.last]
        values = encode_ranges(ranges, configuration.unit, configuration.measuring_mode)
        record = FanRecord(first % 256, self._telegrams % 256, self._time(first), fan.angle)
        indices = (record.turn, record.telegram) if configuration.has_indices else ()
        count = encode_count(len(values), configuration.unit, part, variant.parts)
        return frame_answer(output.code, encode_output(output, values, count, indices)), record
