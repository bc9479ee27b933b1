# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writing results: the format is chosen by the ending, and no half-written file is left."""

import os
import shutil
from contextlib import contextmanager
from pathlib import Path

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter

from .execution import write
from .problems import Problem, UsageProblem

# What each result can be written as.
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

CSV_ARRAYS = ("Range", "Alpha", "Beta", "BeamId", "CellId")


def check_targets(targets, scene=None, **inputs):
    """Make sure, before the work starts, that every result can be written where it shall go.

    `targets` are pairs of a result (a key of ENDINGS) and a path; `scene`, if there is one, and
    whatever else is read, are paths that no result may replace.
    """
    if scene is not None:
        inputs["scene"] = scene
    taken = {Path(path).resolve(): name for name, path in inputs.items()}
    for result, path in targets:
        _check_ending(result, path)
        check_place(result, path)
        other = taken.setdefault(Path(path).resolve(), result)
        if other != result:
            raise UsageProblem(f"'{path}' is both {other} and {result}: choose two names")


def _check_ending(result, path):
    if Path(path).suffix.lower() not in ENDINGS[result]:
        raise UsageProblem(f"cannot write the {result} to '{path}': the ending must be "
                           + " or ".join(ENDINGS[result]))


def check_place(result, path):
    """Make sure that a result, however it is called, can take its place."""
    folder = Path(path).resolve().parent
    if not folder.is_dir():
        raise Problem(f"cannot write the {result} to '{path}': there is no folder '{folder}'")
    if not os.access(folder, os.W_OK):
        raise Problem(f"cannot write the {result} to '{path}': no right to write there")
    if Path(path).is_dir():
        raise Problem(f"cannot write the {result} to '{path}': that is a folder")


def save(data, path):
    """Write a data object; the file appears under its name only when it is complete."""
    with _temporary(Path(path).resolve()) as temporary:
        _SAVERS[Path(path).suffix.lower()](data, temporary, f"cannot write '{path}'")


def save_text(text, path):
    """Write a text; the file appears under its name only when it is complete."""
    with _temporary(Path(path).resolve()) as temporary:
        with writing(path):
            temporary.write_text(text, encoding="utf-8")


@contextmanager
def writing(path):
    """A block that writes `path`: what the system has against it becomes a Problem."""
    try:
        yield
    except OSError as error:
        raise Problem(f"cannot write '{path}': {error.strerror}") from error


@contextmanager
def _temporary(path):
    """A name beside `path` that becomes `path` if the block ends well, and vanishes if not."""
    temporary = path.with_name(f".{path.stem}.{os.getpid()}{path.suffix}")
    try:
        yield temporary
        with writing(path):
            os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def _saver(writer_class, prepare=lambda writer: None):
    """A function that saves through one of VTK's writers."""

    def save_data(data, path, failure):
        writer = writer_class()
        writer.SetInputDataObject(data)
        writer.SetFileName(str(path))
        prepare(writer)
        write(writer, failure)
        if shutil.disk_usage(path.parent).free == 0:  # not every writer notices
            raise Problem(f"{failure}: no space left on the device")

    return save_data


def _save_csv(scan, path, failure):
    """One line a return, numbers in full (VTK's own table writer keeps six digits)."""
    arrays = scan.GetPointData()
    columns = list(vtk_to_numpy(scan.GetPoints().GetData()).T)
    columns += [vtk_to_numpy(arrays.GetArray(name)) for name in CSV_ARRAYS]
    rows = zip(*(column.astype(str) for column in columns))
    try:
        with open(path, "w", encoding="ascii") as file:
            file.write(",".join(("x", "y", "z") + CSV_ARRAYS) + "\n")
            file.writelines(",".join(row) + "\n" for row in rows)
    except OSError as error:
        raise Problem(f"{failure}: {error.strerror}") from error


# VTK appends binary data to the file by default, which is no XML: some versions of its parser,
# Debian 12's among them, refuse to read it again.
_SAVERS = {
    ".vtp": _saver(vtkXMLPolyDataWriter, vtkXMLPolyDataWriter.SetDataModeToBinary),
    ".vti": _saver(vtkXMLImageDataWriter, vtkXMLImageDataWriter.SetDataModeToBinary),
    ".ply": _saver(vtkPLYWriter),
    ".stl": _saver(vtkSTLWriter, vtkSTLWriter.SetFileTypeToBinary),
    ".png": _saver(vtkPNGWriter),
    ".csv": _save_csv,
}
