# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Says what to do if the package cannot be imported. Imports no other part of it."""

import sys
from pathlib import Path

_FOLDER = Path(__file__).resolve().parent


def check_vtk():
    """Raise ImportError if Python has another VTK than the one that the package was built for."""
    import vtkmodules
    from vtkmodules.vtkCommonCore import vtkVersion

    from ._version import VTK_VERSION

    found = vtkVersion.GetVTKVersion()
    if found != VTK_VERSION:
        raise ImportError(f"VTK {found} in {Path(vtkmodules.__file__).parent} is another version")


def explain(error):
    """What an ImportError means, and what to do."""
    try:
        from ._version import PYTHON, VTK_VERSION
    except ImportError:
        return (f"{_FOLDER} has the sources of lms3d without its compiled modules. In another "
                f"folder, {_start_python()}{_set_path()}, or install the Debian package of LMS3D")
    return (f"cannot load lms3d from {_FOLDER} into {sys.executable}: {error}. It was built for "
            f"{PYTHON} with VTK {VTK_VERSION}: {_start_python()}start {PYTHON} with "
            f"PYTHONPATH={_FOLDER.parent}")


def exit_interrupted():
    """End the process as the command line does after Ctrl-C."""
    print("lms3d: error: interrupted", file=sys.stderr)
    sys.exit(130)


def _root():
    """The folder of LMS3D's sources, or None if the package is installed."""
    return next((folder for folder in _FOLDER.parents
                 if (folder / "run").is_file() and (folder / "Plugins" / "Python").is_dir()), None)


def _start_python():
    """An advice for a build beside the sources; an installed package has no such script."""
    root = _root()
    return f"start Python by '{root}/run python', or " if root else ""


def _set_path():
    builds = [file for parts in ("build", "build/*") for libraries in ("lib*", "lib/*")
              for file in _glob(f"{parts}/{libraries}/python3*/*-packages/lms3d/_version.py")]
    return f"set PYTHONPATH to {builds[0].parents[1] if builds else 'the package of a build'}"


def _glob(pattern):
    root = _root()
    return sorted(root.glob(pattern)) if root else []
