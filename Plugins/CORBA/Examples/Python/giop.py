# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""CORBA's wire protocol by hand: GIOP 1.0 and what a client of the scanner needs of CDR, without an ORB.

The formats are those of chapter 9 of the OMG's CORBA 3.3, part 2. Orders of bytes are struct's: "<" is
little-endian, ">" big-endian.
"""

import re
import socket
import struct

REQUEST, REPLY, CLOSE_CONNECTION, MESSAGE_ERROR = 0, 1, 5, 6
NO_EXCEPTION, USER_EXCEPTION, SYSTEM_EXCEPTION = 0, 1, 2
INTERNET_PROFILE = 0


class Encoder:
    """CDR; alignment counts from the start of the GIOP message."""

    def __init__(self, start=12, order="<"):
        self.start, self.order = start, order
        self.bytes = bytearray()

    def number(self, code, value):
        """One number of struct's code, aligned to its size."""
        size = struct.calcsize("<" + code)
        self.bytes += bytes(-(self.start + len(self.bytes)) % size)
        self.bytes += struct.pack(self.order + code, value)
        return self

    def octets(self, value):
        """A sequence of octets."""
        self.number("I", len(value))
        self.bytes += value
        return self

    def string(self, value):
        """A string of bytes, with the zero that ends it."""
        return self.octets(value + b"\0")


class Decoder:
    """The reverse of Encoder, in the byte order that the message tells."""

    def __init__(self, data, order="<", start=12):
        self.data, self.order, self.start, self.at = data, order, start, 0

    def number(self, code):
        """One number of struct's code."""
        return self.numbers(code, 1)[0]

    def numbers(self, code, count):
        """Several numbers without a gap."""
        size = struct.calcsize("<" + code)
        self.at += -(self.start + self.at) % size
        values = struct.unpack_from(f"{self.order}{count}{code}", self.data, self.at)
        self.at += size * count
        return values

    def octets(self):
        """A sequence of octets."""
        length = self.number("I")
        self.at += length
        return self.data[self.at - length:self.at]

    def string(self):
        """A string without its zero."""
        return self.octets()[:-1].decode()


class SystemException(Exception):
    """A CORBA system exception; its argument is the name, as IDL:omg.org/CORBA/MARSHAL:1.0."""


class UserException(Exception):
    """An exception of the IDL; its argument is the repository id."""


def parse_corbaloc(corbaloc):
    """Host, port and key of "corbaloc:iiop:1.2@127.0.0.1:2810/LMS3D"."""
    found = re.fullmatch(r"corbaloc:iiop:1\.2@([\d.]+):(\d+)/(\w+)", corbaloc)
    if not found:
        raise ValueError(f"{corbaloc!r} is neither an IOR nor a corbaloc of a scanner")
    host, port, key = found.groups()
    return host, int(port), key.encode()


def _open_encapsulation(data):
    """CDR within CDR, whose first byte tells its order."""
    return Decoder(data[1:], "<" if data[0] else ">", 1)


def parse_ior(ior):
    """Host, port and key of an IOR, which is CDR in hexadecimal digits."""
    reference = _open_encapsulation(bytes.fromhex(ior[len("IOR:"):]))
    reference.string()  # the type
    for _ in range(reference.number("I")):
        tag, profile = reference.number("I"), reference.octets()
        if tag == INTERNET_PROFILE:
            address = _open_encapsulation(profile)
            address.numbers("B", 2)  # the version
            return address.string(), address.number("H"), address.octets()
    raise ValueError("the IOR names no address of the internet")


def parse_reference(reference):
    """Host, port and key of an IOR or a corbaloc."""
    return parse_ior(reference) if reference.startswith("IOR:") else parse_corbaloc(reference)


def message(kind, body, order="<"):
    """A whole GIOP 1.0 message."""
    return b"GIOP" + struct.pack(order + "4BI", 1, 0, order == "<", kind, len(body)) + body


def request(key, operation, arguments=b"", start_arguments=None, number=1, order="<"):
    """A request; `start_arguments` is called with the encoder in place of ready bytes."""
    encoder = Encoder(order=order)
    encoder.number("I", 0).number("I", number).number("B", 1)
    encoder.octets(key).string(operation.encode()).octets(b"")
    encoder.bytes += arguments
    if start_arguments:
        start_arguments(encoder)
    return message(REQUEST, bytes(encoder.bytes), order)


def receive(connection, count):
    """Exactly so many bytes, or ConnectionError."""
    data = bytearray()
    while len(data) < count:
        part = connection.recv(count - len(data))
        if not part:
            raise ConnectionError(f"closed after {len(data)} of {count} bytes")
        data += part
    return bytes(data)


class Client:
    """One connection to one object."""

    def __init__(self, reference, timeout=20, order="<"):
        host, port, self.key = parse_reference(reference)
        self.order = order
        self.connection = socket.create_connection((host, port), timeout)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.connection.close()

    def call(self, operation, arguments=None):
        """The reply's body as a Decoder; `arguments` writes into an Encoder."""
        self.connection.sendall(
            request(self.key, operation, start_arguments=arguments, order=self.order))
        return self.read_reply()

    def read_reply(self):
        """The next reply, its exceptions raised."""
        header = receive(self.connection, 12)
        magic, little, kind = header[:4], header[6], header[7]
        order = "<" if little & 1 else ">"
        body = receive(self.connection, struct.unpack(order + "I", header[8:])[0])
        if magic != b"GIOP" or kind != REPLY:
            raise ConnectionError(f"no reply but a message of type {kind}")
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
        """The paper's operation."""
        reply = self.call("fetch")
        return reply.numbers("f", reply.number("I"))
