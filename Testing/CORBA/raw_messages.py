# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments and messages for a scanner, without an ORB."""

import struct

import giop

FRAGMENT = 7


def write_wait(after, timeout):
    """The arguments of waitForScan()."""
    return lambda encoder: encoder.number("Q", after).number("Q", 0).number("I", timeout)


def write_configuration(encoder, method=0):
    """The argument of setConfiguration(): five by five beams without a map."""
    for start, stop, count in ((-90, 90, 5), (0, 360, 5)):
        encoder.number("d", start).number("d", stop).number("I", count)
    encoder.number("d", 0).number("d", 80).number("I", method)
    encoder.number("B", 0).number("d", 0.01)


def _part(kind, is_last, body):
    """A message of GIOP 1.2, or one of its fragments."""
    flags = 1 if is_last else 3
    return b"GIOP" + struct.pack("<4BI", 1, 2, flags, kind, len(body)) + body


def _fragments():
    """A request whose argument has two megabytes, nearly all of them in the second part."""
    header = giop.Encoder().number("I", 1).number("I", 3).number("I", 0)
    header.octets(b"LMS3D").string(b"_is_a").number("I", 0)
    header.bytes += bytes(-(12 + len(header.bytes)) % 8)
    argument = struct.pack("<I", 2000001) + b"x" * 2000000 + b"\0"
    return (_part(giop.REQUEST, False, bytes(header.bytes) + argument[:8])
            + _part(FRAGMENT, True, struct.pack("<I", 1) + argument[8:]))


# Two megabytes, in one message and in fragments.
LONG_ARGUMENTS = (
    giop.request(b"LMS3D", "_is_a", start_arguments=lambda e: e.string(b"x" * 2000000)), _fragments())
