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

    Nothing is drawn where the stream is no terminal, and the line is gone at the end.
    """

    def __init__(self, label, algorithm, stream=None):
        self._label = label
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
        percent = round(100 * min(max(algorithm.GetProgress(), 0.0), 1.0))
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


def update(algorithm, label, failure, keeps_parts=False):
    """Bring an algorithm up to date; `label` stands before the bar.

    Raises Problem, `failure` followed by VTK's own words, if VTK reports an error. Of an algorithm
    that `keeps_parts` an error counts if it sets an error code; the caller tells of the others.
    """
    _run(algorithm, algorithm.Update, label, failure, keeps_parts)


def write(writer, failure):
    """Let a VTK writer write its file; raises Problem if it could not."""
    _run(writer, writer.Write, "writing", failure)


def _run(algorithm, job, label, failure, keeps_parts=False):
    with VTKMessages() as messages, ProgressBar(label, algorithm):
        job()
    code = algorithm.GetErrorCode()
    failed = code != vtkErrorCode.NoError
    if keeps_parts and not failed:
        return
    messages.report(failure, vtkErrorCode.GetStringFromErrorCode(code) if failed else "")
