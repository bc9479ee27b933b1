# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Collects VTK's errors and warnings, and reports them to the user as plain sentences."""

import re
import sys

from vtkmodules.util.misc import calldata_type
from vtkmodules.vtkCommonCore import VTK_STRING, vtkLogger, vtkOutputWindow

from .problems import Problem

# "ERROR: In file.cxx, line 12\nvtkClass (0x55d0): text", with or without the object.
_VTK_PREFIX = re.compile(
    r"(?:Generic )?(?:ERROR|Error|Warning): In [^\n]*, line \d+\n"
    r"(?:\w+ \((?:0x)?[0-9a-fA-F]+\): )?"
)

# The executive's own error, which follows the error of the algorithm.
_ECHO = re.compile(r"Algorithm \w+ ?\(?\w*\)? ?returned failure for request")


def say(text):
    """Print a message for the user to the error stream."""
    print(f"lms3d: {text}", file=sys.stderr)


class VTKMessages:
    """Collects VTK's errors and warnings while a ``with`` block runs, instead of printing them.

    Includes objects that an algorithm uses internally: VTK sends every message without an observer
    to its output window.
    """

    def __init__(self):
        self.errors = []
        self.warnings = []
        self._window = vtkOutputWindow.GetInstance()
        self._display_mode = self._window.GetDisplayMode()
        self._verbosity = vtkLogger.GetCurrentVerbosityCutoff()
        self._observers = []

    def __enter__(self):
        self._window.SetDisplayModeToNever()
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        self._observers = [
            self._window.AddObserver("ErrorEvent", self._collector(self.errors)),
            self._window.AddObserver("WarningEvent", self._collector(self.warnings)),
        ]
        return self

    def __exit__(self, *_):
        for observer in self._observers:
            self._window.RemoveObserver(observer)
        self._window.SetDisplayMode(self._display_mode)
        vtkLogger.SetStderrVerbosity(self._verbosity)

    @staticmethod
    def _collector(sentences):
        @calldata_type(VTK_STRING)
        def collect(_window, _event, text):
            sentence = " ".join(_VTK_PREFIX.sub("", text).split())
            if sentence not in sentences:
                sentences.append(sentence)

        return collect

    def report(self, failure, reason=""):
        """Raise Problem, beginning with `failure`, if there were errors; else print the warnings.

        A `reason` counts as an error. It is the message if VTK reported none.
        """
        if self.errors or reason:
            causes = self.warnings + [text for text in self.errors if not _ECHO.match(text)]
            raise Problem(f"{failure}: {'; '.join(causes) or reason or 'VTK gave no reason'}")
        for text in self.warnings:
            say(f"warning: {text}")
