# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's errors and warnings as plain sentences."""

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

# What the executive adds to an error that the algorithm has explained before.
_ECHO = re.compile(r"Algorithm \w+ ?\(?\w*\)? ?returned failure for request")


def say(text):
    """Tell the user something that is neither output nor a reason to stop."""
    print(f"lms3d: {text}", file=sys.stderr)


class VTKMessages:
    """Collects what VTK reports while a ``with`` block runs, in place of printing it.

    Every object counts, also those that an algorithm hides inside: VTK hands whatever nobody
    else observes to its output window.
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
        """Raise Problem, `failure` first, if there were errors; else pass on the warnings.

        A `reason` is an error too, named where VTK found no words of its own.
        """
        if self.errors or reason:
            causes = self.warnings + [text for text in self.errors if not _ECHO.match(text)]
            raise Problem(f"{failure}: {'; '.join(causes) or reason or 'VTK gave no reason'}")
        for text in self.warnings:
            say(f"warning: {text}")
