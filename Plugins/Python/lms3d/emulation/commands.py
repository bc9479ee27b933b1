# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""What each command does to the state, and the answer (TL 122). There are no times here."""

from dataclasses import dataclass
from typing import Optional

from .measured_values import encode_words
from .state import DIAGNOSIS, INSTALLATION, ON_REQUEST
from .status import encode_status
from .variants import Output, Variant

_PASSWORD = b"SICK_LMS"
_MAXIMUM_MEANS = 250

_DONE = b"\x00"
_WRONG_PASSWORD = b"\x01"
_ACCEPTED = b"\x01"
_REJECTED = b"\x00"

_RATES = {0x40: 38400, 0x41: 19200, 0x42: 9600, 0x48: 500000}


@dataclass(frozen=True)
class Reply:
    """The answer to a command.

    code, data: of the answer; without a code there is none. output: measured values that were
    requested. rate: the rate after the answer. is_reset: whether the device starts again after the
    answer. is_slow: whether the device writes its permanent memory first.
    """

    code: Optional[int] = None
    data: bytes = b""
    output: Optional[Output] = None
    rate: Optional[int] = None
    is_reset: bool = False
    is_slow: bool = False


NOT_ALLOWED = Reply(0x92)  # unknown, or not possible now (TL 39)


def execute(state, payload):
    """Execute a command and return its Reply."""
    handler = _HANDLERS.get(payload[0])
    reply = handler(state, payload[1:]) if handler else None
    return reply or NOT_ALLOWED


def _reset(state, data):
    if not data:
        state.restart()
        return Reply(0x91, is_reset=True)
    return None


def _switch(state, data):
    """20h: switch to another mode or rate."""
    sub_command, rest = data[:1], data[1:]
    if not sub_command:
        return None
    code = sub_command[0]
    if code in (INSTALLATION, 0x30):
        return _enter_installation(state, rest, is_test=code != INSTALLATION)
    if code in _STREAMS:
        return _start_stream(state, code, rest)
    if rest:
        return None
    if code in _RATES:
        return Reply(0xA0, _DONE, rate=_RATES[code])
    if code in (ON_REQUEST, DIAGNOSIS):
        state.mode, state.stream = code, None
        return Reply(0xA0, _DONE)
    return None


def _enter_installation(state, password, is_test):
    if password != _PASSWORD:
        return Reply(0xA0, _WRONG_PASSWORD)
    if not is_test:
        state.mode, state.stream = INSTALLATION, None
    return Reply(0xA0, _DONE)


def _start_stream(state, code, data):
    output = _read_output(state, *_STREAMS[code], data)
    if output is None:
        return None
    state.mode, state.stream = code, output
    return Reply(0xA0, _DONE)


# Sub-commands of 20h for a stream, and commands for a single telegram. The code of the telegrams,
# and their parameters: n is a number of scans, r a sub-range, and p, without data, a partial scan.
_STREAMS = {0x24: (0xB0, ""), 0x26: (0xB6, "n"), 0x27: (0xB7, "r"), 0x28: (0xBF, "nr"),
            0x2A: (0xB0, "p")}
_REQUESTS = {0x36: (0xB6, "n"), 0x37: (0xB7, "r"), 0x3F: (0xBF, "nr")}
_SINGLE_SCANS = {b"\x01": "", b"\x08": "p"}


def _read_output(state, code, parameters, data):
    """The Output that a command requests, or None if its data are not valid."""
    values = {"is_partial": "p" in parameters}
    if "n" in parameters:
        if not data or not 2 <= data[0] <= _MAXIMUM_MEANS:
            return None
        values["means"], data = data[0], data[1:]
    if "r" in parameters:
        first, last = (int.from_bytes(data[i:i + 2], "little") for i in (0, 2))
        if len(data) < 4 or not 1 <= first <= last <= state.variant.count:
            return None
        values["first"], values["last"], data = first, last, data[4:]
    output = Output(code, **values)
    return output if not data and output.fan(state.variant) in state.fans else None


def _request_scan(state, data):
    parameters = _SINGLE_SCANS.get(data)
    if parameters is None:
        return None
    output = _read_output(state, 0xB0, parameters, b"")
    return output and Reply(output=output)


def _requester(code):
    def request(state, data):
        output = _read_output(state, *_REQUESTS[code], data)
        return output and Reply(output=output)

    return request


def _reader(code, encode):
    """The handler of a command without data that reads something."""
    return lambda state, data: None if data else Reply(code, encode(state))


def _set_variant(state, data):
    """3Bh: stops a stream, too."""
    if len(data) != 4:
        return None
    wanted = Variant(*(int.from_bytes(data[i:i + 2], "little") for i in (0, 2)))
    is_known = state.can_be(wanted)
    if is_known:
        state.variant = wanted
    if state.stream:
        state.mode, state.stream = ON_REQUEST, None
    return Reply(0xBB, (_ACCEPTED if is_known else _REJECTED)
                 + encode_words(state.variant.angle, state.variant.step))


def _keep_rate(state, data):
    """66h: whether the rate stays after power-off."""
    if state.mode != INSTALLATION or data not in (b"\x00", b"\x01"):
        return None
    state.is_rate_permanent = data == b"\x01"
    return Reply(0xE6, _ACCEPTED + data, is_slow=True)


def _configure(state, data):
    """77h"""
    if state.mode != INSTALLATION:
        return None
    result = _ACCEPTED if state.configuration.change(data) else _REJECTED
    return Reply(0xF7, result + bytes(state.configuration), is_slow=True)


def _write_last_block(state, data):
    """7Ch"""
    if state.mode != INSTALLATION or len(data) != len(state.last_block):
        return None
    state.last_block = bytes(data)
    return Reply(0xFC, _ACCEPTED + state.last_block, is_slow=True)


_HANDLERS = {
    0x10: _reset,
    0x20: _switch,
    0x30: _request_scan,
    0x31: _reader(0xB1, encode_status),
    0x32: _reader(0xB2, lambda state: b""),  # no errors
    0x35: _reader(0xB5, lambda state: encode_words(0, 0)),
    **{code: _requester(code) for code in _REQUESTS},
    0x3A: _reader(0xBA, lambda state: state.type_name),
    0x3B: _set_variant,
    0x66: _keep_rate,
    0x74: _reader(0xF4, lambda state: bytes(state.configuration)),
    0x77: _configure,
    0x7B: _reader(0xFB, lambda state: state.last_block),
    0x7C: _write_last_block,
}
