# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The file formats of results. Each turns a data object into the bytes of a file, in pieces.

VTK's writers write to memory here, because they crash or report success if the disk is full. The
one for PLY writes nothing to memory in VTK 9.2, and keeps no arrays. The libraries for LAS and
E57 write to a file by themselves.
"""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter

from .execution import write
from .grid_formats import encode_pcd, encode_ptx
from .pieces import convert_rows, cut
from .survey_formats import write_e57, write_las

CSV_ARRAYS = ("Range", "Alpha", "Beta", "BeamId", "CellId")
_FURTHER_ARRAYS = ("Incidence", "Intensity", "Time")  # if a scan has them


def encode(data, ending, failure):
    """The bytes of a file as an iterable of pieces; `ending` chooses the format.

    Raises Problem, beginning with `failure`, if VTK reports an error.
    """
    return _ENCODERS[ending](data, failure)


def _xml_encoder(writer_class):
    # By default VTK appends binary data to the file, which is not valid XML: some XML parsers,
    # such as the one in Debian 12, refuse to read it.
    def encode_xml(data, failure):
        writer = writer_class()
        writer.SetInputDataObject(data)
        writer.SetDataModeToBinary()
        writer.WriteToOutputStringOn()
        write(writer, failure)
        return cut(writer.GetOutputString())

    return encode_xml


def _encode_png(image, failure):
    writer = vtkPNGWriter()
    writer.SetInputDataObject(image)
    writer.WriteToMemoryOn()
    write(writer, failure)
    return cut(vtk_to_numpy(writer.GetResult()).tobytes())


def _encode_csv(scan, _failure):
    """One line for each return, with all digits (VTK's own table writer keeps six)."""
    columns = list(_points(scan).T)
    names = _list_arrays(scan)
    columns += [vtk_to_numpy(scan.GetPointData().GetArray(name)) for name in names]

    def convert(rows):
        texts = (column[rows].astype(str).tolist() for column in columns)
        return "".join(",".join(row) + "\n" for row in zip(*texts)).encode("ascii")

    yield (",".join(("x", "y", "z", *names)) + "\n").encode("ascii")
    yield from convert_rows(scan.GetNumberOfPoints(), convert)


def _encode_ply(data, _failure):
    """Points with their arrays, or triangles with their points and normals."""
    vertices = {name: column.astype(np.float32) for name, column in zip("xyz", _points(data).T)}
    triangles = _triangles(data)
    arrays = data.GetPointData()
    if len(triangles) == 0:
        for name in _list_arrays(data):
            vertices[name] = _narrow(vtk_to_numpy(arrays.GetArray(name)))
    elif arrays.GetNormals():
        vertices.update(zip(("nx", "ny", "nz"), vtk_to_numpy(arrays.GetNormals()).T))
    yield _ply_header(vertices, len(triangles))
    yield from _convert_table(data.GetNumberOfPoints(), vertices)
    if len(triangles) > 0:
        count = np.full(len(triangles), 3, np.uint8)
        yield from _convert_table(len(triangles), {"count": count, "corners": triangles})


def _list_arrays(points):
    """The names of the arrays with one number for each point that text formats hold."""
    return list(filter(points.GetPointData().HasArray, CSV_ARRAYS + _FURTHER_ARRAYS))


def _ply_header(vertices, triangle_count):
    lines = ["ply", "format binary_little_endian 1.0", "comment metres, degrees",
             f"element vertex {len(vertices['x'])}"]
    lines += [f"property {_PLY_TYPES[column.dtype.str[1:]]} {name}"
              for name, column in vertices.items()]
    if triangle_count > 0:
        lines += [f"element face {triangle_count}", "property list uchar int vertex_indices"]
    return "\n".join([*lines, "end_header\n"]).encode("ascii")


def _convert_table(count, columns):
    """Rows of named columns as bytes without gaps."""
    types = [(name, "<" + column.dtype.str[1:], column.shape[1:])
             for name, column in columns.items()]

    def convert(rows):
        table = np.empty(rows.stop - rows.start, types)
        for name, column in columns.items():
            table[name] = column[rows]
        return table.tobytes()

    return convert_rows(count, convert)


# A type of numpy, without its byte order, and its name in PLY.
_PLY_TYPES = {"f4": "float", "f8": "double", "i4": "int"}


def _narrow(array):
    """An array of a type that PLY has; it has no integers of 64 bits."""
    if array.dtype.kind != "i":
        return array
    limits = np.iinfo(np.int32)
    fits = array.size == 0 or (array.min() >= limits.min and array.max() <= limits.max)
    return array.astype(np.int32 if fits else np.float64)


def _encode_stl(surface, _failure):
    """Triangles with normals, in single precision."""
    points = _points(surface)
    triangles = _triangles(surface)

    def convert(rows):
        table = np.zeros(rows.stop - rows.start,
                         [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("unused", "<u2")])
        corners = points[triangles[rows]]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        lengths = np.linalg.norm(normals, axis=1, keepdims=True)
        table["normal"] = np.divide(normals, lengths, out=normals, where=lengths > 0)
        table["corners"] = corners
        return table.tobytes()

    # A header that begins with "solid" would stand for the format of text.
    yield b"LMS3D".ljust(80) + np.array(len(triangles), "<u4").tobytes()
    yield from convert_rows(len(triangles), convert)


def _points(data):
    """The coordinates; a map without triangles has none."""
    points = data.GetPoints()
    return vtk_to_numpy(points.GetData()) if points else np.empty((0, 3))


def _triangles(surface):
    """The numbers of the corners; the polygons of a map are triangles."""
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
    return corners.reshape(-1, 3).astype(np.int32)


_ENCODERS = {
    ".vtp": _xml_encoder(vtkXMLPolyDataWriter),
    ".vti": _xml_encoder(vtkXMLImageDataWriter),
    ".ply": _encode_ply,
    ".stl": _encode_stl,
    ".png": _encode_png,
    ".csv": _encode_csv,
    ".pcd": encode_pcd,
    ".ptx": encode_ptx,
}

# The formats whose libraries write to a named file.
FILE_WRITERS = {".las": write_las, ".laz": write_las, ".e57": write_e57}
