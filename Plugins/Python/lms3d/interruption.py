# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C while VTK works.

Python runs its signal handler only between two steps of its own. A VTK algorithm is one such step,
unless it calls an observer in Python. If the handler raised KeyboardInterrupt in an observer, VTK
would end the process at once, without any cleaning up. So the handler of `interruptible` aborts the
algorithm, and KeyboardInterrupt follows when VTK has returned.
"""

import signal
import threading
from contextlib import contextmanager


@contextmanager
def interruptible(stop):
    """A block in which Ctrl-C calls `stop`; KeyboardInterrupt is raised when the block ends.

    Yields a list that has an item after Ctrl-C. Does nothing outside the main thread, or if the
    program has a handler of its own.
    """
    interruptions = []
    if (threading.current_thread() is not threading.main_thread()
            or signal.getsignal(signal.SIGINT) is not signal.default_int_handler):
        yield interruptions
        return

    def interrupt(*_):
        interruptions.append(True)
        stop()

    signal.signal(signal.SIGINT, interrupt)
    try:
        yield interruptions
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
        if interruptions:
            raise KeyboardInterrupt


@contextmanager
def abortable(algorithm):
    """A block in which Ctrl-C aborts an algorithm and its inputs, when they next report progress.

    KeyboardInterrupt is raised when the block ends.
    """
    algorithms = _with_inputs(algorithm)

    def set_abort(value):
        for each in algorithms:
            each.SetAbortExecute(value)

    with interruptible(lambda: set_abort(1)) as interruptions:
        # Python handles signals when it enters the observer. VTK clears the flag when the next
        # algorithm starts, so the observer sets it again.
        def follow(caller, _event):
            if interruptions:
                caller.SetAbortExecute(1)

        observers = [each.AddObserver("ProgressEvent", follow) for each in algorithms]
        try:
            yield
        finally:
            for each, observer in zip(algorithms, observers):
                each.RemoveObserver(observer)
            if interruptions:
                set_abort(0)  # for a next update


def _with_inputs(algorithm):
    """The algorithm and all algorithms before it."""
    found = [algorithm]
    for each in found:
        for port in range(each.GetNumberOfInputPorts()):
            for i in range(each.GetNumberOfInputConnections(port)):
                producer = each.GetInputAlgorithm(port, i)
                if producer not in found:
                    found.append(producer)
    return found
