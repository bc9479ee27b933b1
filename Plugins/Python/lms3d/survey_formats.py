# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Formats of surveyors: LAS, LAZ and E57. Optional libraries write them to a file.

A scan of many returns is converted in pieces.
"""

import uuid
from contextlib import contextmanager

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from ._version import __version__
from .grid import Grid
from .interruption import interruptible
from .pieces import BEAMS, slices
from .problems import Problem

_SOFTWARE = f"LMS3D {__version__}"
_LARGEST_INTEGER = 2**31 - 1


def write_las(scan, path, failure):
    """Write returns in the scene's coordinates as LAS 1.4, or as LAZ if the ending says so."""
    import laspy  # pylint: disable=import-outside-toplevel

    points = vtk_to_numpy(scan.GetPoints().GetData())
    arrays = {name: scan.GetPointData().GetArray(name) for name in ("BeamId", "Time")}
    arrays = {name: vtk_to_numpy(array) for name, array in arrays.items() if array}
    header = laspy.LasHeader(version="1.4", point_format=1 if "Time" in arrays else 0)
    header.generating_software = _SOFTWARE
    header.offsets, header.scales = _las_grid(points)
    header.add_extra_dim(laspy.ExtraBytesParams("BeamId", arrays["BeamId"].dtype))
    # lazrs takes a KeyboardInterrupt in its calls of the file for an error of the file.
    with interruptible(lambda: None) as interruptions, _laspy_errors(failure), \
            laspy.open(str(path), "w", header=header) as file:
        for rows in slices(len(points), BEAMS):
            if interruptions:
                break
            record = laspy.ScaleAwarePointRecord.zeros(rows.stop - rows.start, header=header)
            record.x, record.y, record.z = points[rows].T
            record["BeamId"] = arrays["BeamId"][rows]
            if "Time" in arrays:
                record["gps_time"] = arrays["Time"][rows]
            file.write_points(record)


def _las_grid(points):
    """Offsets and steps of the coordinates, which LAS keeps as integers.

    The steps are 0.1 mm. Only a cloud of more than 400 km needs larger ones.
    """
    low, high = points.min(axis=0), points.max(axis=0)
    offsets = np.round((low + high) / 2)
    reach = np.maximum(high - offsets, offsets - low)
    steps = 10.0 ** np.ceil(np.log10(np.maximum(reach / _LARGEST_INTEGER, 1e-4)) - 1e-9)
    return offsets, steps


@contextmanager
def _laspy_errors(failure):
    import laspy  # pylint: disable=import-outside-toplevel

    try:
        yield
    except (laspy.errors.LaspyException, RuntimeError) as error:
        raise Problem(f"{failure}: {error}; the disk may be full") from error


def write_e57(scan, path, failure):
    """Write returns in the sensor's coordinates, with row and column of the grid, and the pose."""
    import pye57  # pylint: disable=import-outside-toplevel

    image_file = None
    try:
        file = pye57.E57(str(path), "w")
        image_file = file.image_file
        _E57Scan(pye57.libe57, file).write(Grid(scan))
        image_file.close()
    except pye57.libe57.E57Exception as error:
        raise Problem(f"{failure}: {str(error).splitlines()[0]}; the disk may be full") from error
    finally:
        if image_file and image_file.isOpen():
            image_file.cancel()


class _E57Scan:
    """One scan of an E57 file: its structure of nodes, then its points."""

    def __init__(self, library, file):
        self._library = library
        self._file = file.image_file
        self._scans = file.data3d

    def write(self, grid):
        """Write the scan of a grid."""
        last_row, last_column = len(grid.alpha) - 1, len(grid.beta) - 1
        low, high = _bounds(grid)
        scan = self._structure({
            "guid": "{%s}" % uuid.uuid4(), "name": "scan", "description": _SOFTWARE,
            "indexBounds": {"rowMinimum": 0, "rowMaximum": last_row, "columnMinimum": 0,
                            "columnMaximum": last_column, "returnMinimum": 0, "returnMaximum": 0},
            "cartesianBounds": {f"{axis}{name}": float(value)
                                for name, values in (("Minimum", low), ("Maximum", high))
                                for axis, value in zip("xyz", values)},
            "pose": {"rotation": dict(zip("wxyz", grid.quaternion)),
                     "translation": dict(zip("xyz", grid.position.tolist()))}})
        prototype = self._structure({f"cartesian{axis}": 0.0 for axis in "XYZ"})
        for name, last in (("rowIndex", last_row), ("columnIndex", last_column)):
            prototype.set(name, self._library.IntegerNode(self._file, 0, 0, last))
        points = self._library.CompressedVectorNode(
            self._file, prototype, self._library.VectorNode(self._file, True))
        scan.set("points", points)
        self._scans.append(scan)
        self._write_points(grid, points)

    def _write_points(self, grid, points):
        columns = {f"cartesian{axis}": np.empty(BEAMS) for axis in "XYZ"}
        # Not int64: pye57 takes its type code, l, for 32 bits.
        columns.update((name, np.empty(BEAMS, np.longlong)) for name in ("rowIndex", "columnIndex"))
        buffers = self._library.VectorSourceDestBuffer()
        for name, column in columns.items():
            buffers.append(self._library.SourceDestBuffer(
                self._file, name, column, BEAMS, True, True))
        writer = points.writer(buffers)
        try:
            for rows in slices(grid.returns, BEAMS):
                turns, beams = np.divmod(grid.ids[rows], len(grid.alpha))
                for column, values in zip(columns.values(),
                                          (*grid.local_points(rows).T, beams, turns)):
                    column[:rows.stop - rows.start] = values
                writer.write(rows.stop - rows.start)
            writer.close()
        finally:
            # The process would crash if the file were cancelled before its writer has gone.
            del writer

    def _structure(self, content):
        """A node with named numbers, texts and structures."""
        node = self._library.StructureNode(self._file)
        for name, value in content.items():
            node.set(name, self._node(value))
        return node

    def _node(self, value):
        if isinstance(value, dict):
            return self._structure(value)
        kind = {str: "StringNode", int: "IntegerNode", float: "FloatNode"}[type(value)]
        return getattr(self._library, kind)(self._file, value)


def _bounds(grid):
    """The smallest and the largest coordinates in the sensor's frame."""
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for rows in slices(grid.returns, BEAMS):
        points = grid.local_points(rows)
        low, high = np.minimum(low, points.min(axis=0)), np.maximum(high, points.max(axis=0))
    return low, high
