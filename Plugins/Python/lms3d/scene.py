# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reading scenes and maps: any surface that VTK can read, chosen by the ending of the file name."""

from dataclasses import dataclass
from pathlib import Path

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter
from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter, vtkGeometryFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import (
    vtkXMLMultiBlockDataReader,
    vtkXMLPolyDataReader,
    vtkXMLUnstructuredGridReader,
)

from . import vtkVRMLImporterSource
from .execution import update
from .messages import say
from .problems import Problem, UsageProblem

READERS = {
    ".wrl": vtkVRMLImporterSource,
    ".vrml": vtkVRMLImporterSource,
    ".vtp": vtkXMLPolyDataReader,
    ".stl": vtkSTLReader,
    ".ply": vtkPLYReader,
    ".obj": vtkOBJReader,
    ".vtu": vtkXMLUnstructuredGridReader,
    ".vtm": vtkXMLMultiBlockDataReader,
}

UP_AXES = {
    "file": "axes as in the file, z is up",
    "y": "turned from y-up to z-up",
}

_MESSAGES_SHOWN = 10


@dataclass(frozen=True)
class Scene:
    """A scene in memory, in metres, z up."""

    path: Path
    up_axis: str
    data: vtkDataObject
    surface: vtkPolyData

    @property
    def triangles(self):
        """Number of triangles, each polygon of n corners counted as n - 2."""
        return sum(
            cells.GetNumberOfConnectivityIds() - 2 * cells.GetNumberOfCells()
            for cells in (self.surface.GetPolys(), self.surface.GetStrips())
        )

    def __str__(self):
        return f"{self.path.name}: {self.triangles:,} triangles, {UP_AXES[self.up_axis]}"


def check_readable(path, what="scene", endings=tuple(READERS)):
    """Raise UsageProblem for an ending that is none of those, Problem where there is no file."""
    if Path(path).is_dir():
        raise Problem(f"cannot read {what} '{path}': that is a folder")
    if Path(path).suffix.lower() not in endings:
        raise UsageProblem(f"cannot read {what} '{path}': the ending is not one of "
                           + " ".join(endings))
    if not Path(path).is_file():
        raise Problem(f"cannot read {what} '{path}': no such file")


def read_data(path, what, up_axis="file"):
    """Read what VTK finds in a file; with up_axis "y" its y axis becomes the z axis."""
    reader = READERS[Path(path).suffix.lower()]()
    reader.SetFileName(str(path))
    algorithm = reader if up_axis == "file" else _turned(reader)
    update(algorithm, "reading", f"cannot read {what} '{path}'")
    _pass_on_messages(reader)
    return algorithm.GetOutputDataObject(0)


def read_scene(path, up_axis="file"):
    """Read a scene; with up_axis "y" the file's y axis becomes the scene's z axis."""
    check_readable(path)
    data = read_data(path, "scene", up_axis)
    scene = Scene(Path(path), up_axis, data, _surface(data))
    if scene.triangles <= 0:
        raise Problem(f"nothing to scan in '{path}': the file holds no triangles")
    return scene


def _turned(reader):
    """The reader, or a filter behind it, whose output is turned from y-up to z-up."""
    if isinstance(reader, vtkVRMLImporterSource):
        reader.SetUpAxisToY()
        return reader
    y_to_z = vtkTransform()
    y_to_z.RotateX(90)
    turn = vtkTransformFilter()
    turn.SetTransform(y_to_z)
    turn.SetInputConnection(reader.GetOutputPort())
    return turn


def _pass_on_messages(reader):
    """Tell what else of a VRML file was not read; the reader warns of the first thing itself."""
    if not isinstance(reader, vtkVRMLImporterSource):
        return
    count = reader.GetNumberOfMessages()
    for i in range(1, min(count, _MESSAGES_SHOWN)):
        say(f"warning: {reader.GetMessage(i)}")
    if count > _MESSAGES_SHOWN:
        say(f"warning: {count - _MESSAGES_SHOWN} more messages about this file")


def _surface(data):
    """The polygons of any data object."""
    if isinstance(data, vtkPolyData):
        return data
    composite = isinstance(data, vtkCompositeDataSet)
    extract = vtkCompositeDataGeometryFilter() if composite else vtkGeometryFilter()
    extract.SetInputDataObject(data)
    update(extract, "reading", "cannot extract the surface of the scene")
    return extract.GetOutput()
