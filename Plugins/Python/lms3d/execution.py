# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs VTK algorithms: shows their progress, and raises their errors as Problem.

Ctrl-C aborts an algorithm and raises KeyboardInterrupt.
"""

import sys

from vtkmodules.vtkCommonMisc import vtkErrorCode

from .interruption import abortable
from .messages import VTKMessages

_BAR_WIDTH = 30
_CLEAR_LINE = "\r\033[K"


class ProgressBar:
    """Shows progress in one line of the terminal while a ``with`` block runs.

    `share` are the start and the end of the bar's part that the block fills, 0 to 1. Draws nothing
    if the stream is not a terminal. Clears the line at the end.
    """

    def __init__(self, label, share=(0.0, 1.0), stream=None):
        self._label = label
        self._share = share
        self._stream = stream or sys.stderr
        self._is_shown = self._stream.isatty()
        self._percent = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self._percent is not None:
            self._write(_CLEAR_LINE)

    def show(self, done):
        """Show how much of the block's work is done, 0 to 1."""
        start, end = self._share
        percent = round(100 * (start + (end - start) * min(max(done, 0.0), 1.0)))
        if self._is_shown and percent != self._percent:
            self._percent = percent
            self._write("\r" + self.line(percent))

    def line(self, percent):
        """The bar as text, for example ``scanning   [#####.....] 50 %``."""
        filled = round(_BAR_WIDTH * percent / 100)
        return f"{self._label:<13} [{'#' * filled:.<{_BAR_WIDTH}}] {percent:3d} %"

    def _write(self, text):
        self._stream.write(text)
        self._stream.flush()


def update(algorithm, label, failure, keeps_parts=False, time=None, share=(0.0, 1.0)):
    """Update an algorithm, for a `time` if given; `label` is the text before the progress bar.

    Raises Problem, `failure` followed by VTK's message, if VTK reports an error. If the algorithm
    `keeps_parts`, its output can be used in spite of errors: then only an error code raises
    Problem, and the caller reports the other errors.
    """
    job = algorithm.Update if time is None else lambda: algorithm.UpdateTimeStep(time)
    _run(algorithm, job, label, failure, keeps_parts, share)


def write(writer, failure):
    """Run a VTK writer; raises Problem, beginning with `failure`, if VTK reports an error."""
    _run(writer, writer.Write, "writing", failure)


def _run(algorithm, job, label, failure, keeps_parts=False, share=(0.0, 1.0)):
    with VTKMessages() as messages, ProgressBar(label, share) as bar, abortable(algorithm):
        observer = algorithm.AddObserver(
            "ProgressEvent", lambda *_: bar.show(algorithm.GetProgress()))
        try:
            job()
        finally:
            algorithm.RemoveObserver(observer)
    code = algorithm.GetErrorCode()
    failed = code != vtkErrorCode.NoError
    if keeps_parts and not failed:
        return
    messages.report(failure, vtkErrorCode.GetStringFromErrorCode(code) if failed else "")
