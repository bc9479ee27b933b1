# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes results. The file ending chooses the format; a failed write leaves no incomplete file."""

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

CSV_ARRAYS = ("Range", "Alpha", "Beta", "BeamId", "CellId")


def check_targets(targets, scene=None, **inputs):
    """Check that every result can be written, before the work starts.

    `targets` are pairs of a result (a key of ENDINGS) and a path. `scene` and `inputs` are paths of
    files that are read; no result may replace them.
    """
    if scene is not None:
        inputs["scene"] = scene
    taken = {Path(path).resolve(): name for name, path in inputs.items()}
    for result, path in targets:
        _check_ending(result, path)
        check_writable(result, path)
        other = taken.setdefault(Path(path).resolve(), result)
        if other != result:
            raise UsageProblem(f"'{path}' is both {other} and {result}: choose two names")


def _check_ending(result, path):
    if Path(path).suffix.lower() not in ENDINGS[result]:
        raise UsageProblem(f"cannot write the {result} to '{path}': the ending must be "
                           + " or ".join(ENDINGS[result]))


def check_writable(result, path):
    """Raise Problem if a result cannot be written to a path; the message contains its name."""
    folder = Path(path).resolve().parent
    if not folder.is_dir():
        raise Problem(f"cannot write the {result} to '{path}': there is no folder '{folder}'")
    if not os.access(folder, os.W_OK):
        raise Problem(f"cannot write the {result} to '{path}': no permission to write there")
    if Path(path).is_dir():
        raise Problem(f"cannot write the {result} to '{path}': that is a folder")


def save(data, path):
    """Write a data object. The file gets its name only when it is complete."""
    with _temporary(Path(path).resolve()) as temporary:
        _SAVERS[Path(path).suffix.lower()](data, temporary, f"cannot write '{path}'")


def save_text(text, path):
    """Write a text. The file gets its name only when it is complete."""
    with _temporary(Path(path).resolve()) as temporary:
        with writing(path):
            temporary.write_text(text, encoding="utf-8")


@contextmanager
def writing(path):
    """A block that writes `path`: turns an OSError into a Problem."""
    try:
        yield
    except OSError as error:
        raise Problem(f"cannot write '{path}': {error.strerror}") from error


@contextmanager
def _temporary(path):
    """A temporary file beside `path`: renamed to it after the block, deleted if the block fails."""
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
        if shutil.disk_usage(path.parent).free == 0:  # not every writer reports it
            raise Problem(f"{failure}: no space left on the device")

    return save_data


def _save_csv(scan, path, failure):
    """One line for each return, with all digits (VTK's own table writer keeps six)."""
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


# By default VTK appends binary data to the file, which is not valid XML: some XML parsers, such as
# the one in Debian 12, refuse to read it.
_SAVERS = {
    ".vtp": _saver(vtkXMLPolyDataWriter, vtkXMLPolyDataWriter.SetDataModeToBinary),
    ".vti": _saver(vtkXMLImageDataWriter, vtkXMLImageDataWriter.SetDataModeToBinary),
    ".ply": _saver(vtkPLYWriter),
    ".stl": _saver(vtkSTLWriter, vtkSTLWriter.SetFileTypeToBinary),
    ".png": _saver(vtkPNGWriter),
    ".csv": _save_csv,
}
