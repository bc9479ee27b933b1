#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Fetches a scan by the paper's interface with nothing but Python's standard library.

Usage: lms3d_giop.py IOR_FILE

It prints range (metres), alpha and beta (degrees) of each beam, a line each. Instead of an ORB it has
the few bytes of GIOP 1.2 that a call of fetch() takes (the OMG's CORBA 3.3, part 2, chapter 9), so that
it tells what the server really sends.
"""

import argparse
import array
import collections
import pathlib
import socket
import struct
import sys

MAGIC = b"GIOP"
HEADER_SIZE = 12
LITTLE_ENDIAN, MORE_FRAGMENTS = 1, 2
REQUEST, REPLY, FRAGMENT = 0, 1, 7
RESPONSE_EXPECTED = 3
NO_EXCEPTION, SYSTEM_EXCEPTION = 0, 2
INTERNET_PROFILE = 0
TIME_LIMIT = 10.0

Address = collections.namedtuple("Address", "host port key")


class GIOPError(Exception):
    """What came is no answer to what was asked, or an exception of the server's."""


class Decoder:
    """Reads CDR: each number at a multiple of its own size from the begin of the message."""

    def __init__(self, data, is_little, position=0):
        self.data = data
        self.order = "<" if is_little else ">"
        self.position = position

    @classmethod
    def encapsulated(cls, data):
        """Of an encapsulation, whose first byte tells the order of its bytes."""
        return cls(data, data[:1] == b"\1", 1)

    def align(self, size):
        self.position += -self.position % size

    def take(self, size):
        end = self.position + size
        if end > len(self.data):
            raise GIOPError(f"{len(self.data)} bytes end before byte {end}")
        taken = self.data[self.position:end]
        self.position = end
        return taken

    def number(self, code):
        size = struct.calcsize(self.order + code)
        self.align(size)
        return struct.unpack(self.order + code, self.take(size))[0]

    def octets(self):
        return self.take(self.number("I"))

    def string(self):
        return self.octets()[:-1].decode("latin-1")

    def floats(self):
        """A sequence<float>."""
        count = self.number("I")
        self.align(4)
        values = array.array("f", self.take(4 * count))
        if (self.order == "<") != (sys.byteorder == "little"):
            values.byteswap()
        return values


def parse_ior(text):
    """The address that is in an IOR, which is CDR in hexadecimal digits."""
    if not text.startswith("IOR:"):
        raise GIOPError("an IOR begins with IOR:")
    ior = Decoder.encapsulated(bytes.fromhex(text[len("IOR:"):]))
    ior.string()  # the repository identifier
    for _ in range(ior.number("I")):
        tag, profile = ior.number("I"), ior.octets()
        if tag == INTERNET_PROFILE:
            inner = Decoder.encapsulated(profile)
            inner.take(2)  # the version of IIOP
            return Address(inner.string(), inner.number("H"), inner.octets())
    raise GIOPError("the IOR has no address of the internet")


def make_request(key, operation, is_little=True):
    """The message that calls an operation without parameters on the object with that key."""
    order = "<" if is_little else ">"
    name = operation.encode() + b"\0"
    body = struct.pack(order + "IB3xH2xI", 1, RESPONSE_EXPECTED, 0, len(key)) + key
    body += bytes(-len(body) % 4) + struct.pack(order + "I", len(name)) + name
    body += bytes(-len(body) % 4) + struct.pack(order + "I", 0)  # no service contexts
    flags = LITTLE_ENDIAN if is_little else 0
    return MAGIC + struct.pack(order + "4BI", 1, 2, flags, REQUEST, len(body)) + body


def _receive_exactly(connection, size):
    data = bytearray()
    while len(data) < size:
        part = connection.recv(size - len(data))
        if not part:
            raise GIOPError(f"the server closed the connection after {len(data)} of {size} bytes")
        data += part
    return bytes(data)


def _receive_message(connection):
    header = _receive_exactly(connection, HEADER_SIZE)
    _, _, flags, kind = header[4:8]
    if header[:4] != MAGIC:
        raise GIOPError(f"no GIOP: {header}")
    size = struct.unpack("<I" if flags & LITTLE_ENDIAN else ">I", header[8:])[0]
    return kind, flags, header, _receive_exactly(connection, size)


def receive_reply(connection):
    """A decoder at the result of a reply, put together from its fragments."""
    kind, flags, header, body = _receive_message(connection)
    if kind != REPLY:
        raise GIOPError(f"message {kind} came in place of a reply")
    message = bytearray(header + body)
    while flags & MORE_FRAGMENTS:
        kind, flags, _, body = _receive_message(connection)
        if kind != FRAGMENT:
            raise GIOPError(f"message {kind} came in place of a fragment")
        message += body[4:]  # without the number of the request
    reply = Decoder(bytes(message), flags & LITTLE_ENDIAN, HEADER_SIZE)
    reply.number("I")  # the number of the request
    status = reply.number("I")
    for _ in range(reply.number("I")):  # service contexts
        reply.number("I")
        reply.octets()
    reply.align(8)
    if status == SYSTEM_EXCEPTION:
        raise GIOPError(f"{reply.string()}, minor code {reply.number('I')}")
    if status != NO_EXCEPTION:
        raise GIOPError(f"a reply of status {status}")
    return reply


def connect(address):
    """A socket to a server, which gives up after a time."""
    return socket.create_connection((address.host, address.port), TIME_LIMIT)


def fetch(address, is_little=True):
    """Call fetch(): r, alpha, beta of each beam."""
    with connect(address) as connection:
        connection.sendall(make_request(address.key, "fetch", is_little))
        return receive_reply(connection).floats()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("ior_file", type=pathlib.Path, help="the file of lms3d-server --ior")
    parser.add_argument("--big-endian", action="store_true", help="ask in the other order of bytes")
    options = parser.parse_args()
    try:
        address = parse_ior(options.ior_file.read_text().strip())
        values = fetch(address, not options.big_endian)
    except (GIOPError, OSError, ValueError) as problem:
        sys.exit(f"{parser.prog}: {problem}")
    for i in range(0, len(values), 3):
        print(*values[i:i + 3], sep="\t")


if __name__ == "__main__":
    main()
