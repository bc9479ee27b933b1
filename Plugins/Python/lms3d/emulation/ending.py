# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The ends of a command that runs until it is stopped: Ctrl-C, SIGTERM, a closed terminal."""

import os
import signal
import sys
from contextlib import contextmanager

_SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


@contextmanager
def stop_descriptor():
    """A block with a descriptor that becomes readable when the command must end."""
    reader, writer = os.pipe()
    os.set_blocking(writer, False)
    old = {}

    def stop(*_):
        try:
            os.write(writer, b"x")
        except BlockingIOError:  # enough signals have come
            pass

    try:
        for each in _SIGNALS:
            # A command that nohup has started ignores SIGHUP.
            if signal.getsignal(each) is not signal.SIG_IGN:
                old[each] = signal.signal(each, stop)
        yield reader
    finally:
        for each, handler in old.items():
            signal.signal(each, handler)
        os.close(reader)
        os.close(writer)


@contextmanager
def closed_terminal():
    """A block whose prints may fail, because the command's terminal has been closed."""
    try:
        yield
    except OSError:
        # What is left in the buffer must not fail at the end of the program.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
