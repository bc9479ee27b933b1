# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A symbolic link with a fixed name to a pseudo-terminal, whose own name changes."""

import os
from contextlib import contextmanager
from pathlib import Path

from ..messages import say
from ..problems import Problem

_PSEUDO_TERMINALS = Path("/dev/pts")


def check_link(path):
    """Raise Problem if a link cannot be made, or if it would replace another file."""
    path = Path(path)
    if not path.parent.is_dir():
        raise Problem(f"cannot make the link '{path}': there is no folder '{path.parent}'")
    if not os.access(path.parent, os.W_OK):
        raise Problem(f"cannot make the link '{path}': the folder '{path.parent}' is not writable")
    if not os.path.lexists(path):
        return
    # Only a link to a pseudo-terminal may be replaced: an earlier run can have left it.
    if not path.is_symlink() or Path(os.readlink(path)).parent != _PSEUDO_TERMINALS:
        raise Problem(f"cannot make the link '{path}': something else has this name")
    if path.exists():
        say(f"warning: '{path}' is a link to {os.readlink(path)}, which is open; it is replaced")


@contextmanager
def linked(path, target):
    """A block while `path` is a link to `target`; without a path it does nothing.

    An old link is replaced in one step. If another program has replaced the link, it stays.
    """
    if path is None:
        yield
        return
    path = Path(path)
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        os.symlink(target, temporary)
        os.replace(temporary, path)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise Problem(f"cannot make the link '{path}': {error.strerror}") from error
    try:
        yield
    finally:
        if path.is_symlink() and os.readlink(path) == target:
            path.unlink(missing_ok=True)
