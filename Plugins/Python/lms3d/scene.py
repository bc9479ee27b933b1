# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads scenes and maps: VRML, glTF, and what VTK reads. The file ending chooses the reader."""

from dataclasses import dataclass
from pathlib import Path

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
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
from .gltf import read_gltf
from .mesh_files import check_mesh_file
from .messages import say
from .problems import Problem, UsageProblem

READERS = {
    ".wrl": vtkVRMLImporterSource,
    ".vrml": vtkVRMLImporterSource,
    ".wrz": vtkVRMLImporterSource,
    ".vtp": vtkXMLPolyDataReader,
    ".stl": vtkSTLReader,
    ".ply": vtkPLYReader,
    ".obj": vtkOBJReader,
    ".vtu": vtkXMLUnstructuredGridReader,
    ".vtm": vtkXMLMultiBlockDataReader,
    ".glb": vtkTrivialProducer,
    ".gltf": vtkTrivialProducer,
}

UP_AXES = {
    "file": "axes as in the file, z is up",
    "y": "turned from y-up to z-up",
    "z": "axes as in the file, z is up",
}

# The formats that fix the axis that is up.
_UP_AXIS_OF_FORMAT = {".glb": "y", ".gltf": "y"}

# The limits of the VRML reader: its property, and how many of the property's units make one here.
LIMITS = {
    "nodes": ("MaximumNumberOfNodes", 1),
    "triangles": ("MaximumNumberOfTriangles", 1),
    "memory": ("MaximumMemory", 10**6),
    "size": ("MaximumFileSize", 10**6),
}

_MESSAGES_SHOWN = 10


@dataclass(frozen=True)
class Message:
    """Something in a file that was not read; `lost` if geometry is lost."""

    lost: bool
    text: str

    def __str__(self):
        return f"{'error' if self.lost else 'warning'}: {self.text}"


@dataclass(frozen=True)
class Scene:
    """A scene in memory: metres, z up."""

    path: Path
    up_axis: str
    data: vtkDataObject
    surface: vtkPolyData
    messages: tuple = ()

    @property
    def triangles(self):
        """Number of triangles; a polygon of n corners counts as n - 2."""
        return sum(
            cells.GetNumberOfConnectivityIds() - 2 * cells.GetNumberOfCells()
            for cells in (self.surface.GetPolys(), self.surface.GetStrips())
        )

    def report_losses(self):
        """Print the first messages of the reader, losses first."""
        lost = sum(message.lost for message in self.messages)
        if lost:
            say(f"warning: {self.path} is incomplete: {lost} of its parts are lost")
        worst_first = sorted(self.messages, key=lambda message: not message.lost)
        for message in worst_first[:_MESSAGES_SHOWN]:
            say(message)
        if len(self.messages) > _MESSAGES_SHOWN:
            say(f"{len(self.messages) - _MESSAGES_SHOWN} more messages; 'lms3d info' shows all")

    def __str__(self):
        count = self.triangles
        return (f"{self.path.name}: {count:,} triangle{'s' * (count != 1)}, "
                f"{UP_AXES[self.up_axis]}")


def check_readable(path, what="scene", endings=tuple(READERS)):
    """Raise UsageProblem if the file ending is unknown, Problem if there is no such file."""
    if Path(path).is_dir():
        raise Problem(f"cannot read {what} '{path}': that is a folder")
    if Path(path).suffix.lower() not in endings:
        raise UsageProblem(f"cannot read {what} '{path}': the ending is not one of "
                           + " ".join(endings))
    if not Path(path).is_file():
        raise Problem(f"cannot read {what} '{path}': no such file")


def read_data(path, what):
    """Read a file by its VTK reader; raises Problem on an error."""
    return _read(_make_reader(path, what), path, what, _up_axis(path, "file"))


def read_scene(path, up_axis="file", root=None, limits=None):
    """Read a scene. With up_axis "y" the file's y axis becomes the scene's z axis.

    With "file" that happens if the format says that y is up, as glTF does; with "z" never. A VRML
    file can only use files below `root`, by default its own folder. `limits` are values for keys of
    LIMITS.
    """
    check_readable(path)
    up_axis = _up_axis(path, up_axis)
    reader = _make_reader(path, "scene", root, limits)
    data = _read(reader, path, "scene", up_axis)
    scene = Scene(Path(path), up_axis, data, _surface(data), _messages(reader))
    if scene.triangles <= 0:
        raise Problem(f"nothing to scan in '{path}': the file holds no triangles")
    return scene


def _up_axis(path, up_axis):
    """The axis that is up in a file, in place of "file" if its format says."""
    if up_axis != "file":
        return up_axis
    return _UP_AXIS_OF_FORMAT.get(Path(path).suffix.lower(), up_axis)


def _make_reader(path, what, root=None, limits=None):
    """The reader of a file, by its ending."""
    reader = READERS[Path(path).suffix.lower()]()
    if root is not None:
        _set_root(reader, path, root)
    for name, value in (limits or {}).items():
        _set_limit(reader, path, name, value)
    failure = f"cannot read {what} '{path}'"
    if isinstance(reader, vtkTrivialProducer):
        reader.SetOutput(read_gltf(path, failure))
    else:
        check_mesh_file(path, failure)
        reader.SetFileName(str(path))
    return reader


def _set_root(reader, path, root):
    if not isinstance(reader, vtkVRMLImporterSource):
        raise UsageProblem(f"--scene-root {root}: '{path}' is not a VRML file")
    if not Path(root).is_dir():
        raise Problem(f"cannot read scene '{path}': --scene-root {root} is not a folder")
    reader.SetSceneRoot(str(root))


def _set_limit(reader, path, name, value):
    if not isinstance(reader, vtkVRMLImporterSource):
        raise UsageProblem(f"--scene-{name} {value}: '{path}' is not a VRML file")
    property_name, unit = LIMITS[name]
    getattr(reader, "Set" + property_name)(unit * value)


def _read(reader, path, what, up_axis="file"):
    """The data of a reader's file; with up_axis "y" the y axis becomes the z axis."""
    algorithm = _turned(reader) if up_axis == "y" else reader
    update(algorithm, "reading", f"cannot read {what} '{path}'",
           keeps_parts=isinstance(reader, vtkVRMLImporterSource))
    return algorithm.GetOutputDataObject(0)


def _turned(reader):
    """The reader, or a filter after it, with an output turned from y-up to z-up."""
    if isinstance(reader, vtkVRMLImporterSource):
        reader.SetUpAxisToY()
        return reader
    y_to_z = vtkTransform()
    y_to_z.RotateX(90)
    turn = vtkTransformFilter()
    turn.SetTransform(y_to_z)
    turn.SetInputConnection(reader.GetOutputPort())
    return turn


def _messages(reader):
    """The messages of the VRML reader; VTK's own readers fail instead."""
    if not isinstance(reader, vtkVRMLImporterSource):
        return ()
    return tuple(
        Message(reader.GetMessageSeverity(i) == reader.MESSAGE_ERROR, reader.GetMessage(i))
        for i in range(reader.GetNumberOfMessages())
    )


def _surface(data):
    """The surface of any data object."""
    if isinstance(data, vtkPolyData):
        return data
    composite = isinstance(data, vtkCompositeDataSet)
    extract = vtkCompositeDataGeometryFilter() if composite else vtkGeometryFilter()
    extract.SetInputDataObject(data)
    update(extract, "reading", "cannot extract the surface of the scene")
    return extract.GetOutput()
