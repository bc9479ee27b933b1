# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes results. The file ending chooses the format; a failed write leaves no incomplete file."""

import os
import shutil
import sys
from contextlib import closing, contextmanager, redirect_stdout
from pathlib import Path

from .formats import encode
from .problems import Problem, UsageProblem

# The formats of each result.
ENDINGS = {
    "scan": (".vtp", ".ply", ".csv"),
    "range image": (".vti",),
    "map": (".vtp", ".ply", ".stl"),
    "picture": (".png",),
    "map with errors": (".vtp",),
    "scene points": (".vtp",),
    "series of scans": (".pvd",),
    "series of maps": (".pvd",),
}

# In place of a path: the standard output, with one format for each result.
STREAM = "-"
STREAM_ENDINGS = {
    "scan": ".csv",
    "range image": ".vti",
    "map": ".ply",
    "picture": ".png",
    "map with errors": ".vtp",
    "scene points": ".vtp",
}
_BINARY_ENDINGS = (".ply", ".png")
_STDOUT = 1  # the descriptor, also while prints go elsewhere


def check_targets(targets, scene=None, **inputs):
    """Check that every result can be written, before the work starts.

    `targets` are pairs of a result (a key of ENDINGS) and a path. `scene` and `inputs` are paths of
    files that are read; no result may replace them.
    """
    if scene is not None:
        inputs["scene"] = scene
    taken = {Path(path).resolve(): name for name, path in inputs.items()}
    for result, path in targets:
        if path == STREAM:
            _check_stream(result)
        else:
            _check_ending(result, path)
            check_writable(result, path)
        other = taken.setdefault(Path(path).resolve(), result)
        if other != result:
            raise UsageProblem(f"'{path}' is both {other} and {result}: choose two names")


def _check_stream(result):
    if result not in STREAM_ENDINGS:
        raise UsageProblem(f"cannot write the {result} to the standard output: it is several "
                           "files; give a file name that ends in " + " or ".join(ENDINGS[result]))
    if STREAM_ENDINGS[result] in _BINARY_ENDINGS and os.isatty(_STDOUT):
        raise UsageProblem(f"cannot write the {result} to a terminal: the format "
                           f"{STREAM_ENDINGS[result]} is binary")


def _check_ending(result, path):
    if Path(path).suffix.lower() not in ENDINGS[result]:
        raise UsageProblem(f"cannot write the {result} to '{path}': the ending must be "
                           + " or ".join(ENDINGS[result]))


def check_writable(result, path):
    """Raise Problem if a result cannot be written to a path; the message contains its name."""
    folder = Path(path).resolve().parent
    if not folder.is_dir():
        raise Problem(f"cannot write the {result} to '{path}': there is no folder '{folder}'")
    if Path(path).is_dir():
        raise Problem(f"cannot write the {result} to '{path}': that is a folder")
    if not os.access(path if _is_device(path) else folder, os.W_OK):
        raise Problem(f"cannot write the {result} to '{path}': no permission to write there")


@contextmanager
def reports(targets):
    """A block whose prints go to the error stream if a result goes to the standard output."""
    if any(path == STREAM for _, path in targets):
        with redirect_stdout(sys.stderr):
            yield
    else:
        yield


def save(data, path, result=None, shown=None):
    """Write a data object. A file gets its name only when it is complete.

    If the path is STREAM, `result` (a key of STREAM_ENDINGS) chooses the format. `shown` is the
    name of the file in messages, by default the path.
    """
    shown = "the standard output" if path == STREAM else f"'{shown or path}'"
    ending = STREAM_ENDINGS[result] if path == STREAM else Path(path).suffix.lower()
    with _writing(shown), closing(encode(data, ending, f"cannot write {shown}")) as pieces, \
            _opened(path) as file:
        for piece in pieces:
            view = memoryview(piece)
            while view:
                view = view[file.write(view):]


def replace(temporary, path):
    """Give a complete file its name, and the permissions of the file that it replaces."""
    if path.exists():
        shutil.copymode(path, temporary)
    os.replace(temporary, path)


def writing(path):
    """A block that writes `path`: turns an OSError or a MemoryError into a Problem."""
    return _writing(f"'{path}'")


@contextmanager
def _writing(shown):
    try:
        yield
    except OSError as error:
        raise Problem(f"cannot write {shown}: {error.strerror}") from error
    except MemoryError as error:
        raise Problem(f"cannot write {shown}: not enough memory") from error


@contextmanager
def _opened(path):
    """A binary file to write to: the standard output, a device or a pipe, or a new file.

    It has no buffer: after Ctrl-C, closing a file with a buffer could wait for a reader again.
    """
    if path == STREAM:
        with open(_STDOUT, "wb", buffering=0, closefd=False) as file:
            yield file
    elif _is_device(path):
        with open(path, "wb", buffering=0) as file:
            yield file
    else:
        with _temporary(Path(path).resolve()) as file:
            yield file


@contextmanager
def _temporary(path):
    """A temporary file beside `path`: renamed to it after the block, deleted if the block fails."""
    temporary = path.with_name(f".{path.stem}.{os.getpid()}{path.suffix}")
    try:
        file = open(temporary, "xb", buffering=0)
    except FileExistsError:
        raise Problem(f"cannot write '{path}': delete '{temporary}' first") from None
    try:
        with file:
            yield file
        replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def _is_device(path):
    """Whether a path names a device or a pipe, which no file may replace."""
    return Path(path).exists() and not Path(path).is_file()
