# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""References to listeners, and objects that forward each call, without an ORB."""

import contextlib
import socket
import struct
import threading

import giop

LISTENER = b"IDL:LMS3D/ScanListener:1.0"
LOCATE_REQUEST, LOCATE_REPLY = 3, 4
OBJECT_FORWARD, LOCATION_FORWARD = 2, 3
UNIX_SOCKET = 0x41545402


def make_profile(host, port, components=()):
    """The address of an object, as IIOP 1.0, or 1.1 with components: pairs of a tag and bytes."""
    profile = giop.Encoder(0)
    profile.number("B", 1).number("B", 1).number("B", 1 if components else 0)
    profile.string(host).number("H", port).octets(b"key")
    if components:
        profile.number("I", len(components))
    for tag, data in components:
        profile.number("I", tag).octets(data)
    return bytes(profile.bytes)


def make_unix_component(path):
    """omniORB's component for a Unix socket of this machine."""
    component = giop.Encoder(0).number("B", 1).string(socket.gethostname().encode())
    return UNIX_SOCKET, bytes(component.string(path.encode()).bytes)


def write_reference(encoder, profile):
    """Write a listener's reference with one address."""
    encoder.string(LISTENER).number("I", 1).number("I", giop.INTERNET_PROFILE).octets(profile)


def subscribe(client, profile):
    """The number of the subscription."""
    return client.call("subscribe", lambda e: write_reference(e, profile)).number("I")


def unsubscribe(client, number):
    """End the subscription."""
    client.call("unsubscribe", lambda e: e.number("I", number))


class Forwarder:
    """Forwards each call, and each question for the object's location, while the context lasts: to the
    object at `target`, by default to itself. With `closes` it closes the connection after each answer."""

    def __init__(self, closes=False, target=None):
        self.closes = closes
        self.count = 0
        self.socket = socket.create_server(("127.0.0.1", 0), backlog=64)
        self.port = self.socket.getsockname()[1]
        self.profile = make_profile(b"127.0.0.1", self.port)
        self.target = target or self.profile
        threading.Thread(target=self._accept, daemon=True).start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.shutdown(socket.SHUT_RDWR)
        self.socket.close()

    def _accept(self):
        with contextlib.suppress(OSError):
            while True:
                connection = self.socket.accept()[0]
                threading.Thread(target=self._serve, args=(connection,), daemon=True).start()

    def _serve(self, connection):
        with connection, contextlib.suppress(OSError):
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            while True:
                header = giop.receive(connection, 12)
                order = "<" if header[6] & 1 else ">"
                body = giop.receive(connection, struct.unpack(order + "I", header[8:])[0])
                self.count += 1
                connection.sendall(self._answer(header[7], giop.Decoder(body, order)))
                if self.closes:
                    return

    def _answer(self, kind, decoder):
        """The answer to a message of GIOP 1.0."""
        answer = giop.Encoder()
        if kind == LOCATE_REQUEST:
            answer.number("I", decoder.number("I")).number("I", OBJECT_FORWARD)
            write_reference(answer, self.target)
            return giop.message(LOCATE_REPLY, bytes(answer.bytes))
        for _ in range(decoder.number("I")):
            decoder.number("I")
            decoder.octets()
        number = decoder.number("I")
        if not decoder.number("B"):
            return b""
        answer.number("I", 0).number("I", number).number("I", LOCATION_FORWARD)
        write_reference(answer, self.target)
        return giop.message(giop.REPLY, bytes(answer.bytes))
