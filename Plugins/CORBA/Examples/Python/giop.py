# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A small client for CORBA's wire protocol, without an ORB: GIOP 1.0 and the necessary parts of CDR.

Chapter 9 of the OMG's CORBA 3.3, part 2, defines the formats. Byte orders are written as in struct:
"<" is little-endian, ">" big-endian.
"""

import re
import socket
import struct

REQUEST, REPLY, CLOSE_CONNECTION, MESSAGE_ERROR = 0, 1, 5, 6
NO_EXCEPTION, USER_EXCEPTION, SYSTEM_EXCEPTION = 0, 1, 2
INTERNET_PROFILE = 0


class Encoder:
    """Encodes CDR. Alignment counts from the start of the GIOP message."""

    def __init__(self, start=12, order="<"):
        self.start, self.order = start, order
        self.bytes = bytearray()

    def number(self, code, value):
        """Append one number of struct's code, aligned to its size."""
        size = struct.calcsize("<" + code)
        self.bytes += bytes(-(self.start + len(self.bytes)) % size)
        self.bytes += struct.pack(self.order + code, value)
        return self

    def octets(self, value):
        """Append a sequence of octets."""
        self.number("I", len(value))
        self.bytes += value
        return self

    def string(self, value):
        """Append a string of bytes and its terminating zero."""
        return self.octets(value + b"\0")


class Decoder:
    """Decodes CDR in the byte order of the message."""

    def __init__(self, data, order="<", start=12):
        self.data, self.order, self.start, self.at = data, order, start, 0

    def number(self, code):
        """Return one number of struct's code."""
        return self.numbers(code, 1)[0]

    def numbers(self, code, count):
        """Return several consecutive numbers."""
        size = struct.calcsize("<" + code)
        self.at += -(self.start + self.at) % size
        values = struct.unpack_from(f"{self.order}{count}{code}", self.data, self.at)
        self.at += size * count
        return values

    def octets(self):
        """Return a sequence of octets."""
        length = self.number("I")
        self.at += length
        return self.data[self.at - length:self.at]

    def string(self):
        """Return a string without its terminating zero."""
        return self.octets()[:-1].decode()


class SystemException(Exception):
    """A CORBA system exception. Its argument is the name, such as IDL:omg.org/CORBA/MARSHAL:1.0."""


class UserException(Exception):
    """An exception of the IDL. Its argument is the repository id."""


def parse_corbaloc(corbaloc):
    """Return host, port and key of "corbaloc:iiop:1.2@127.0.0.1:2810/LMS3D"."""
    found = re.fullmatch(r"corbaloc:iiop:1\.2@([\d.]+):(\d+)/(\w+)", corbaloc)
    if not found:
        raise ValueError(f"{corbaloc!r} is neither an IOR nor a corbaloc of a scanner")
    host, port, key = found.groups()
    return host, int(port), key.encode()


def _open_encapsulation(data):
    """Decode CDR within CDR. Its first byte is its byte order."""
    return Decoder(data[1:], "<" if data[0] else ">", 1)


def parse_ior(ior):
    """Return host, port and key of an IOR, which is CDR in hexadecimal digits."""
    reference = _open_encapsulation(bytes.fromhex(ior[len("IOR:"):]))
    reference.string()  # the type
    for _ in range(reference.number("I")):
        tag, profile = reference.number("I"), reference.octets()
        if tag == INTERNET_PROFILE:
            address = _open_encapsulation(profile)
            address.numbers("B", 2)  # the version
            return address.string(), address.number("H"), address.octets()
    raise ValueError("the IOR has no internet address")


def parse_reference(reference):
    """Return host, port and key of an IOR or a corbaloc."""
    return parse_ior(reference) if reference.startswith("IOR:") else parse_corbaloc(reference)


def message(kind, body, order="<"):
    """Return a complete GIOP 1.0 message."""
    return b"GIOP" + struct.pack(order + "4BI", 1, 0, order == "<", kind, len(body)) + body


def request(key, operation, arguments=b"", start_arguments=None, number=1, order="<"):
    """Return a request. `start_arguments` writes arguments into the encoder, instead of ready bytes."""
    encoder = Encoder(order=order)
    encoder.number("I", 0).number("I", number).number("B", 1)
    encoder.octets(key).string(operation.encode()).octets(b"")
    encoder.bytes += arguments
    if start_arguments:
        start_arguments(encoder)
    return message(REQUEST, bytes(encoder.bytes), order)


def receive(connection, count):
    """Return exactly `count` bytes, or raise ConnectionError."""
    data = bytearray()
    while len(data) < count:
        part = connection.recv(count - len(data))
        if not part:
            raise ConnectionError(f"closed after {len(data)} of {count} bytes")
        data += part
    return bytes(data)


class Client:
    """A connection to one object."""

    def __init__(self, reference, timeout=20, order="<"):
        host, port, self.key = parse_reference(reference)
        self.order = order
        self.connection = socket.create_connection((host, port), timeout)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.connection.close()

    def call(self, operation, arguments=None):
        """Call an operation and return the reply's body as a Decoder. `arguments` writes into an Encoder."""
        self.connection.sendall(
            request(self.key, operation, start_arguments=arguments, order=self.order))
        return self.read_reply()

    def read_reply(self):
        """Return the body of the next reply, or raise its exception."""
        header = receive(self.connection, 12)
        magic, little, kind = header[:4], header[6], header[7]
        order = "<" if little & 1 else ">"
        body = receive(self.connection, struct.unpack(order + "I", header[8:])[0])
        if magic != b"GIOP" or kind != REPLY:
            raise ConnectionError(f"expected a reply, got a message of type {kind}")
        decoder = Decoder(body, order)
        for _ in range(decoder.number("I")):
            decoder.number("I")
            decoder.octets()
        decoder.number("I")
        status = decoder.number("I")
        if status == SYSTEM_EXCEPTION:
            raise SystemException(decoder.string())
        if status == USER_EXCEPTION:
            raise UserException(decoder.string())
        return decoder

    def fetch(self):
        """Call the paper's operation."""
        reply = self.call("fetch")
        return reply.numbers("f", reply.number("I"))
