# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of what a device reports: the errors of a scan, and the local map of it."""

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401 renders the texts
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkPolyDataMapper,
    vtkTextActor,
)

from .figure import DEFAULT_SIZE, Figure

_LARGEST_SHOWN = 20.0  # millimetres
_COLORS = ((0.15, 0.35, 0.85), (0.88, 0.88, 0.84), (0.85, 0.25, 0.15))  # from below 0 to above
_BEYOND = (0.75, 0.0, 0.65)  # larger errors, either way
_IDEAL = (0.44, 0.64, 0.96)
_TEXT = (0.2, 0.2, 0.2)
_POINT_SIZE = 2  # pixels
_AMBIENT = 0.4  # of the light, so that colours are visible on dark walls


def range_errors(ideal, reported):
    """The reported range of each return minus the ideal one, metres; NaN without an ideal one.

    Both are outputs of vtkLMS3DScanFilter or vtkLMS3DRangeErrorFilter with the same beams.
    """
    return _array(reported, "Range") - _by_beam(ideal, "Range", reported)


class DeviceMapFigure(Figure):
    """The scene of a simulation, and another map of it, with the edges of its triangles."""

    def __init__(self, simulation, reconstruction, size=DEFAULT_SIZE):
        self._reconstruction = reconstruction
        super().__init__(simulation, size, edges=True)

    def _map_port(self):
        return self._reconstruction.GetOutputPort()


class DeviceFigure(Figure):
    """The returns of an ideal simulation, and of a reported scan, coloured by their errors.

    The ideal scan must have normals (SurfaceAttributes). Only returns of surfaces that face the
    camera are drawn. Larger errors than the legend has are purple.
    """

    def __init__(self, simulation, reported, name, size=DEFAULT_SIZE):
        self._halves = (vtkPolyData(), vtkPolyData())
        super().__init__(simulation, size)
        ideal = simulation.scan
        self._fill(self._halves[0], ideal, np.zeros(ideal.GetNumberOfPoints()))
        self._fill(self._halves[1], reported, range_errors(ideal, reported))
        self._add_texts(name)

    def _left_actor(self):
        actor = _points_actor(self._halves[0])
        actor.GetMapper().ScalarVisibilityOff()
        actor.GetProperty().SetColor(_IDEAL)
        return actor

    def _right_actor(self, edges):
        actor = _points_actor(self._halves[1])
        actor.GetMapper().SetLookupTable(_make_colors())
        actor.GetMapper().UseLookupTableScalarRangeOn()
        return actor

    def _fill(self, half, scan, errors):
        """Put the returns that face the camera into a half."""
        points = vtk_to_numpy(scan.GetPoints().GetData())
        normals = _by_beam(self._simulation.scan, "Normals", scan)
        facing = np.einsum("ij,ij->i", normals, self.camera.GetPosition() - points) > 0
        kept = facing & np.isfinite(errors)
        half.ShallowCopy(_make_points(points[kept], normals[kept], 1000 * errors[kept]))

    def _add_texts(self, name):
        renderers = self.window.GetRenderers()
        for i, text in enumerate(("ideal", name)):
            title = vtkTextActor()
            title.SetInput(text)
            title.GetTextProperty().SetColor(_TEXT)
            title.GetTextProperty().SetFontSize(self.window.GetSize()[1] // 28)
            title.SetPosition(10, self.window.GetSize()[1] // 30)
            renderers.GetItemAsObject(i).AddViewProp(title)
        renderers.GetItemAsObject(1).AddViewProp(_make_legend())


def _points_actor(points):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(points)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetPointSize(_POINT_SIZE)
    actor.GetProperty().SetAmbient(_AMBIENT)
    actor.GetProperty().SetDiffuse(1.0 - _AMBIENT)
    return actor


def _make_points(points, normals, errors):
    """One vertex for each point, with its normal, and its error as scalar."""
    data = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(coordinates)
    vertices = vtkCellArray()
    vertices.SetData(1, numpy_to_vtkIdTypeArray(np.arange(len(points)), deep=True))
    data.SetVerts(vertices)
    data.GetPointData().SetNormals(numpy_to_vtk(np.ascontiguousarray(normals), deep=True))
    data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(errors), deep=True))
    return data


def _make_colors(steps=255):
    """The colours of errors in millimetres."""
    function = vtkColorTransferFunction()
    for value, color in zip((0.0, 0.5, 1.0), _COLORS):
        function.AddRGBPoint(value, *color)
    table = vtkLookupTable()
    table.SetNumberOfTableValues(steps)
    table.SetTableRange(-_LARGEST_SHOWN, _LARGEST_SHOWN)
    for i in range(steps):
        table.SetTableValue(i, *function.GetColor(i / (steps - 1)), 1.0)
    for prefix in ("Above", "Below"):
        getattr(table, f"Set{prefix}RangeColor")(*_BEYOND, 1.0)
        getattr(table, f"SetUse{prefix}RangeColor")(True)
    return table


def _make_legend():
    legend = vtkScalarBarActor()
    legend.SetLookupTable(_make_colors())
    legend.SetTitle("range error (mm); larger: purple")
    legend.SetOrientationToHorizontal()
    legend.SetNumberOfLabels(5)
    legend.SetLabelFormat("%.0f")
    legend.SetPosition(0.35, 0.01)
    legend.SetWidth(0.6)
    legend.SetHeight(0.09)
    for text in (legend.GetTitleTextProperty(), legend.GetLabelTextProperty()):
        text.SetColor(_TEXT)
        text.ShadowOff()
        text.ItalicOff()
        text.BoldOff()
    return legend


def _by_beam(ideal, name, scan):
    """The values that an ideal scan has for the beams of a scan, NaN without a return."""
    values = _array(ideal, name)
    beams, wanted = _array(ideal, "BeamId"), _array(scan, "BeamId")
    places = np.searchsorted(beams, wanted)
    found = beams[np.minimum(places, len(beams) - 1)] == wanted
    taken = values[np.minimum(places, len(beams) - 1)].astype(np.float64)
    taken[~found] = np.nan
    return taken


def _array(scan, name):
    return vtk_to_numpy(scan.GetPointData().GetArray(name))
