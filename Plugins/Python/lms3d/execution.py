# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Running VTK algorithms: with a progress bar, and with errors that reach the user."""

import sys

from vtkmodules.vtkCommonMisc import vtkErrorCode

from .messages import VTKMessages

_BAR_WIDTH = 30
_CLEAR_LINE = "\r\033[K"


class ProgressBar:
    """One line on the terminal that follows an algorithm's progress while a block runs.

    `share` are the start and the end of what the algorithm does of a longer work. Nothing is drawn
    where the stream is no terminal, and the line is gone at the end.
    """

    def __init__(self, label, algorithm, stream=None, share=(0.0, 1.0)):
        self._label = label
        self._share = share
        self._algorithm = algorithm
        self._stream = stream or sys.stderr
        self._percent = None
        self._observer = None

    def __enter__(self):
        if self._stream.isatty():
            self._observer = self._algorithm.AddObserver("ProgressEvent", self._follow)
        return self

    def __exit__(self, *_):
        if self._observer is not None:
            self._algorithm.RemoveObserver(self._observer)
            self._write(_CLEAR_LINE)

    def _follow(self, algorithm, _event):
        start, end = self._share
        percent = round(100 * (start + (end - start) * min(max(algorithm.GetProgress(), 0.0), 1.0)))
        if percent != self._percent:
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
    """Bring an algorithm up to date, for a `time` where one is given; `label` stands before the bar.

    Raises Problem, `failure` followed by VTK's own words, if VTK reports an error. Of an algorithm
    that `keeps_parts` an error counts if it sets an error code; the caller tells of the others.
    """
    job = algorithm.Update if time is None else lambda: algorithm.UpdateTimeStep(time)
    _run(algorithm, job, label, failure, keeps_parts, share)


def write(writer, failure):
    """Let a VTK writer write its file; raises Problem if it could not."""
    _run(writer, writer.Write, "writing", failure)


def _run(algorithm, job, label, failure, keeps_parts=False, share=(0.0, 1.0)):
    with VTKMessages() as messages, ProgressBar(label, algorithm, share=share):
        job()
    code = algorithm.GetErrorCode()
    failed = code != vtkErrorCode.NoError
    if keeps_parts and not failed:
        return
    messages.report(failure, vtkErrorCode.GetStringFromErrorCode(code) if failed else "")
