# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes results. The file ending chooses the format; a failed write leaves no incomplete file."""

import errno
import os
import shutil
import sys
from contextlib import closing, contextmanager, redirect_stdout
from pathlib import Path

from .formats import FILE_WRITERS, encode
from .interruption import interruptible
from .libraries import check_library
from .problems import Problem, UsageProblem

# The formats that are folders.
BAG_ENDINGS = (".db3", ".mcap")

# The formats of each result.
ENDINGS = {
    "scan": (".vtp", ".ply", ".csv", ".pcd", ".ptx", ".e57", ".las", ".laz", *BAG_ENDINGS),
    "range image": (".vti",),
    "map": (".vtp", ".ply", ".stl"),
    "fused map": (".vtp", ".ply", ".stl"),
    "picture": (".png",),
    "map with errors": (".vtp",),
    "scene points": (".vtp",),
    "series of scans": (".pvd", *BAG_ENDINGS),
    "series of maps": (".pvd",),
}

# In place of a path: the standard output, with one format for each result.
STREAM = "-"
STREAM_ENDINGS = {
    "scan": ".csv",
    "range image": ".vti",
    "map": ".ply",
    "fused map": ".ply",
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
            if Path(path).suffix.lower() in BAG_ENDINGS:
                check_new(result, path)
            check_writable(result, path)
            _check_format(result, path)
        other = taken.setdefault(Path(path).resolve(), result)
        if other != result:
            raise UsageProblem(f"'{path}' is both {other} and {result}: choose two names")


def check_apart(result, path, **inputs):
    """Raise UsageProblem if a result that is written in place is a file that is read, by any name.

    Some inputs may be None; the others exist.
    """
    for name, each in inputs.items():
        if each and os.path.exists(path) and os.path.samefile(path, each):
            raise UsageProblem(f"'{path}' is both {name} and {result}: choose two names")


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


def _check_format(result, path):
    """Raise Problem if the format's library is missing, or needs a file and gets a device."""
    ending = Path(path).suffix.lower()
    check_library(ending, f"cannot write the {result} to '{path}'")
    if ending in FILE_WRITERS and _is_device(path):
        raise Problem(f"cannot write the {result} to '{path}': {ending} can only be written to a "
                      "file")


def check_new(result, path):
    """Raise Problem if something has the name of a result that is a folder."""
    if os.path.lexists(path):
        raise Problem(f"cannot write the {result} to '{path}': it exists; delete it, or choose "
                      "another name")


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


class ResultFiles:
    """Writes results. Their files get their names together, after the last one is complete.

    A context manager. If its block fails, no file changes. If one file cannot get its name at the
    end, the files before it keep theirs. Only files wait: the standard output, devices and pipes get
    their bytes at once.
    """

    def __init__(self):
        self._files = []

    def __enter__(self):
        return self

    def __exit__(self, failure, *_):
        with interruptible(lambda: None):  # Ctrl-C waits until all files have their names
            try:
                if failure is None:
                    self._publish()
            finally:
                for temporary, *_ in self._files:
                    if not temporary.is_dir():
                        temporary.unlink(missing_ok=True)

    def save(self, data, path, result=None, shown=None):
        """Write a data object.

        If the path is STREAM, `result` (a key of STREAM_ENDINGS) chooses the format. `shown` is the
        name of the file in messages, by default the path.
        """
        shown = "the standard output" if path == STREAM else f"'{shown or path}'"
        ending = STREAM_ENDINGS[result] if path == STREAM else Path(path).suffix.lower()
        if ending in FILE_WRITERS:
            self._save_file(data, Path(path).resolve(), FILE_WRITERS[ending], shown)
            return
        with _writing(shown), closing(encode(data, ending, f"cannot write {shown}")) as pieces, \
                self._opened(path, shown) as file:
            for piece in pieces:
                view = memoryview(piece)
                while view:
                    view = view[file.write(view):]

    def _save_file(self, data, path, write, shown):
        """Let a library write to a new file, which it opens by its name."""
        with _writing(shown):
            self._temporary(path, shown).close()
            write(data, self._files[-1][0], f"cannot write {shown}")

    def add(self, temporary, path):
        """Let a complete file or folder get its name with the others; its owner deletes a folder.

        It has to be in the same file system.
        """
        self._files.append((temporary, path, f"'{path}'"))

    def _opened(self, path, shown):
        """A binary file to write to: the standard output, a device or a pipe, or a new file.

        It has no buffer: after Ctrl-C, closing a file with a buffer could wait for a reader again.
        """
        if path == STREAM:
            return open(_STDOUT, "wb", buffering=0, closefd=False)
        if _is_device(path):
            return open(path, "wb", buffering=0)
        return self._temporary(Path(path).resolve(), shown)

    def _temporary(self, path, shown):
        """A new file beside `path`, which gets this name."""
        temporary = path.with_name(f".{path.stem}.{os.getpid()}{path.suffix}")
        # Before the file is made, because Ctrl-C may come just after that.
        self._files.append((temporary, path, shown))
        try:
            return open(temporary, "xb", buffering=0)
        except FileExistsError:
            self._files.pop()
            raise Problem(f"cannot write {shown}: delete '{temporary}' first") from None

    def _publish(self):
        for temporary, path, shown in self._files:
            with _writing(shown):
                _check_replaceable(path)
                if path.exists():
                    shutil.copymode(path, temporary)
        for temporary, path, shown in self._files:
            with _writing(shown):
                os.replace(temporary, path)


def save(data, path, result=None, shown=None):
    """Write one data object, as ResultFiles.save does."""
    with ResultFiles() as files:
        files.save(data, path, result, shown)


def _check_replaceable(path):
    if path.is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))


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


def sort_targets(targets):
    """Sort (result, path) so that what ResultFiles writes at once comes last.

    Nothing takes it back if a file cannot be written.
    """
    return sorted(targets, key=lambda target: target[1] == STREAM or _is_device(target[1]))


def _is_device(path):
    """Whether a path names a device or a pipe, which no file may replace."""
    return Path(path).exists() and not Path(path).is_file()
