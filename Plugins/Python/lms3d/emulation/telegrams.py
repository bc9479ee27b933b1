# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Telegrams: frames around payloads, and payloads found in a stream of bytes (TL 21 to 24).

A payload is a code and its data, and from the device also a status byte.
"""

from .crc import compute_crc

ACKNOWLEDGE = b"\x06"
REFUSE = b"\x15"  # bad check sum
ALL_IS_WELL = 0x10  # the status byte of a device without any fault, of the type LMS 2xx (TL 106)

MAXIMUM_SIZE = 812  # bytes of a telegram (TL 22)
FRAME_SIZE = 6
MAXIMUM_GAP = 0.5  # seconds within a telegram

_START = 0x02
_HEADER_SIZE = 4
_FROM_DEVICE = 0x80  # added to the address


def frame(payload, address=0):
    """The telegram of a payload, as a host sends it."""
    telegram = bytes((_START, address)) + len(payload).to_bytes(2, "little") + payload
    return telegram + compute_crc(telegram)


def frame_answer(code, data=b"", address=0):
    """The telegram of an answer."""
    return frame(bytes((code,)) + data + bytes((ALL_IS_WELL,)), _FROM_DEVICE + address)


class TelegramReader:
    """Finds the telegrams to one address in bytes that arrive in pieces, with noise between them.

    A telegram that is complete within the beginning of another one is found, because a byte of
    noise can look like a beginning.
    """

    def __init__(self, address=0):
        self._address = address
        self._bytes = b""
        self._last_time = 0.0

    def clear(self):
        """Forget the beginning of a telegram."""
        self._bytes = b""

    def read(self, data, now):
        """The payloads of the telegrams that are complete now; None is one with a bad check sum."""
        if now - self._last_time > MAXIMUM_GAP:
            self._bytes = b""
        self._last_time = now
        self._bytes += data
        payloads = []
        while self._take(payloads):
            pass
        return payloads

    def _take(self, payloads):
        """Take what comes first: a telegram or noise. False if more bytes have to arrive."""
        beginning = len(self._bytes)
        has_bad = False
        for start in range(len(self._bytes)):
            if self._bytes[start] != _START:
                continue
            end = self._find_end(start)
            if end is None:
                continue
            if end > len(self._bytes):
                beginning = min(beginning, start)
            elif compute_crc(self._bytes[start:end - 2]) == self._bytes[end - 2:end]:
                if self._bytes[start + 1] == self._address:
                    payloads.append(self._bytes[start + _HEADER_SIZE:end - 2])
                self._bytes = self._bytes[end:]
                return True
            elif self._bytes[start + 1] == self._address and not has_bad:
                # Noise before a good telegram is not refused, so this waits for the loop's end.
                has_bad = beginning == len(self._bytes)
        if has_bad:
            payloads.append(None)
        self._bytes = self._bytes[beginning:]
        return False

    def _find_end(self, start):
        """The end of the telegram that would start here; behind the last byte if that is open.

        None if there can be no telegram.
        """
        header = self._bytes[start:start + _HEADER_SIZE]
        if len(header) < _HEADER_SIZE:
            return len(self._bytes) + 1
        length = int.from_bytes(header[2:], "little")
        if not 1 <= length <= MAXIMUM_SIZE - FRAME_SIZE:
            return None
        return start + length + FRAME_SIZE
