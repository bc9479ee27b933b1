# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments and messages for a scanner, without an ORB."""

import struct

import giop

CANCEL_REQUEST = 2
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


def write_device(encoder, noise=0.0, array=b"", mounting=0, status=0):
    """The argument of setDevice(): a device that is ideal except for these properties."""
    for value in (0, noise, 0):
        encoder.number("d", value)
    encoder.number("i", 0).number("d", 0).number("d", 0).number("I", 1)
    encoder.number("d", 1).number("d", 0).string(array).number("I", mounting)
    for _ in range(4):
        encoder.number("d", 0)
    encoder.number("B", status)


def part(kind, number, body=b"", is_last=True, order="<"):
    """A message about a request of GIOP 1.2, or a part of one."""
    flags = (order == "<") + (0 if is_last else 2)
    return (b"GIOP" + struct.pack(order + "4B2I", 1, 2, flags, kind, 4 + len(body), number) + body)


def _fragments():
    """A request whose argument has two megabytes, nearly all of them in the second part."""
    header = giop.Encoder().number("I", 3).number("I", 0)
    header.octets(b"LMS3D").string(b"_is_a").number("I", 0)
    header.bytes += bytes(-(16 + len(header.bytes)) % 8)
    argument = struct.pack("<I", 2000001) + b"x" * 2000000 + b"\0"
    return (part(giop.REQUEST, 1, bytes(header.bytes) + argument[:8], is_last=False)
            + part(FRAGMENT, 1, argument[8:]))


# Two megabytes, in one message and in fragments.
LONG_ARGUMENTS = (
    giop.request(b"LMS3D", "_is_a", start_arguments=lambda e: e.string(b"x" * 2000000)), _fragments())
