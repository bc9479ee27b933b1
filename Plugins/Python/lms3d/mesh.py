# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Triangle meshes as numpy arrays and as vtkPolyData."""

from typing import NamedTuple

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObject, vtkPolyData


class Mesh(NamedTuple):
    """Triangles as numpy arrays.

    `vertices` are coordinates, N x 3 float64, metres; `triangles` are numbers of vertices, M x 3.
    """

    vertices: np.ndarray
    triangles: np.ndarray


def from_vtk(data):
    """The Mesh of a vtkPolyData that has only triangles."""
    points, polygons = data.GetPoints(), data.GetPolys()
    if points is None or polygons.GetNumberOfCells() == 0:
        return Mesh(np.empty((0, 3)), np.empty((0, 3), np.int64))
    return Mesh(vtk_to_numpy(points.GetData()),
                vtk_to_numpy(polygons.GetConnectivityArray()).reshape(-1, 3))


def to_vtk(mesh):
    """The data object of a mesh: itself, or the vtkPolyData of its vertices and triangles.

    Raises ValueError if the mesh is neither a VTK data object nor a pair of arrays.
    """
    if isinstance(mesh, vtkDataObject):
        return mesh
    if not isinstance(mesh, (tuple, list)) or len(mesh) != 2:
        raise ValueError("mesh must be a vtkPolyData or a pair (vertices, triangles) of arrays, "
                         f"not {type(mesh).__name__}")
    vertices = _check_vertices(mesh[0])
    triangles = _check_triangles(mesh[1], len(vertices))
    points = vtkPoints()
    points.SetData(numpy_to_vtk(vertices, deep=True))
    polygons = vtkCellArray()
    polygons.SetData(3, numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(polygons)
    return data


def _check_vertices(values):
    vertices = np.ascontiguousarray(_to_array("vertices", values), dtype=np.float64)
    if not np.isfinite(vertices).all():
        raise ValueError("vertices must be finite numbers")
    return vertices


def _check_triangles(values, count):
    """The triangles as 64 bit integers, as vtkIdType is."""
    triangles = _to_array("triangles", values)
    if not np.issubdtype(triangles.dtype, np.integer):
        raise ValueError(f"triangles must be integers, not {triangles.dtype}")
    if triangles.min() < 0 or triangles.max() >= count:
        raise ValueError(f"triangles must be numbers of vertices, 0 to {count - 1}, not "
                         f"{triangles.min()} to {triangles.max()}")
    return np.ascontiguousarray(triangles, dtype=np.int64)


def _to_array(name, values):
    """An array of numbers with three columns and at least one row."""
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise ValueError(f"{name} must be an array with three columns: {error}") from error
    if array.ndim != 2 or array.shape[1] != 3 or len(array) == 0:
        raise ValueError(f"{name} must be an array of N x 3 numbers with N above 0, not of shape "
                         f"{array.shape}")
    if array.dtype.kind not in "iuf":
        raise ValueError(f"{name} must be numbers, not {array.dtype}")
    return array
