# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the triangles of glTF 2.0 files, .glb and .gltf, as vtkPolyData.

VTK's own reader ends the process if a file has numbers that point outside its data, and fails if a
picture is missing. This one reads geometry only. It raises Problem if the file is invalid, or uses
what it cannot read and what would change the surface.
"""

import json
from pathlib import Path

import numpy as np

from .gltf_data import Accessors, Invalid, items, whole
from .mesh import to_vtk
from .problems import Problem

_TRIANGLES, _STRIP, _FAN = 4, 5, 6
_MAXIMUM_TRIANGLES = 100_000_000
_JSON, _BINARY = b"JSON", b"BIN\0"

# Required extensions that do not change the surface, or that this reader supports.
_HARMLESS = ("KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_",
             "KHR_mesh_quantization", "KHR_xmp")


def read_gltf(path, failure):
    """The surface of a file, y up as the format says; Problem begins with `failure`."""
    try:
        with np.errstate(over="ignore", invalid="ignore"):  # to_vtk refuses what is not finite
            return to_vtk(_read(Path(path)))
    except OSError as error:
        raise Problem(f"{failure}: {error.strerror}") from error
    except MemoryError as error:
        raise Problem(f"{failure}: not enough memory") from error
    except (Invalid, ValueError, RecursionError) as error:
        raise Problem(f"{failure}: {error}") from error
    except (ArithmeticError, LookupError, TypeError) as error:
        raise Problem(f"{failure}: this is no valid glTF: {error}") from error


def _read(path):
    """The vertices and triangles of all nodes of the scene."""
    text, binary = _split(np.fromfile(path, np.uint8).tobytes(), path)
    try:
        document = json.loads(text.decode("utf-8-sig"))
    except ValueError as error:
        raise Invalid(f"this is no glTF file: {error}") from error
    _check_version(document)
    meshes = _Meshes(document, Accessors(document, path.parent, binary))
    vertices, triangles, first = [], [], 0
    for node, matrix in _nodes(document):
        for points, corners in meshes.get(node):
            vertices.append(points @ matrix[:3, :3].T + matrix[:3, 3])
            # A reflection turns triangles inside out.
            triangles.append(first + (corners if np.linalg.det(matrix) > 0 else corners[:, ::-1]))
            first += len(points)
            meshes.count(len(corners))
    if not triangles:
        raise Invalid("nothing to scan: the file holds no triangles")
    return np.concatenate(vertices), np.concatenate(triangles)


def _split(content, path):
    """The text and the binary part of a file."""
    if not content.startswith(b"glTF"):
        if path.suffix.lower() == ".glb":
            raise Invalid("this is no .glb file: it does not begin with glTF")
        return content, None
    version, length = np.frombuffer(content[4:12].ljust(8, b"\0"), "<u4").tolist()
    if version != 2:
        raise Invalid(f"glTF 2 can be read, not glTF {version}")
    if length > len(content):
        raise Invalid(f"the file is cut off: it has {len(content):,} of {length:,} bytes")
    chunks = {}
    first = 12
    while first + 8 <= length:
        size = int.from_bytes(content[first:first + 4], "little")
        if first + 8 + size > length:
            raise Invalid("the file is cut off: a part of it ends after the file")
        chunks.setdefault(content[first + 4:first + 8], content[first + 8:first + 8 + size])
        first += 8 + size
    if _JSON not in chunks:
        raise Invalid("this is no .glb file: it has no text")
    return chunks[_JSON], chunks.get(_BINARY)


def _check_version(document):
    asset = document.get("asset") if isinstance(document, dict) else None
    if not isinstance(asset, dict):
        raise Invalid("this is no glTF file: it has no asset")
    version = str(asset.get("minVersion", asset.get("version")))
    if version != "2.0":
        raise Invalid(f"glTF 2.0 can be read, not glTF {version}")
    for name in items(document, "extensionsRequired", str):
        if not name.startswith(_HARMLESS):
            raise Invalid(f"it needs the extension {name}, which cannot be read: save the file "
                          "without it")


def _nodes(document):
    """Each node of the scene with its matrix to the scene."""
    nodes = items(document, "nodes", dict)
    visited = set()
    waiting = [(number, np.identity(4)) for number in _roots(document)]
    while waiting:
        number, parent = waiting.pop()
        number = whole(number, "a node", len(nodes))
        if number in visited:
            raise Invalid(f"node {number} is used twice; nodes must form trees")
        visited.add(number)
        node = nodes[number]
        if "EXT_mesh_gpu_instancing" in node.get("extensions", ()):
            raise Invalid(f"node {number} has instances by EXT_mesh_gpu_instancing, which cannot "
                          "be read: save the file without this extension")
        matrix = parent @ _matrix(node, number)
        if not np.isfinite(matrix).all():
            raise Invalid(f"the matrix of node {number} is not finite")
        yield node, matrix
        waiting += [(child, matrix) for child in reversed(items(node, "children"))]


def _roots(document):
    """The first nodes of the scene; without scenes all nodes without a parent."""
    scenes = items(document, "scenes", dict)
    if scenes:
        return reversed(items(scenes[whole(document.get("scene", 0), "the scene", len(scenes))],
                              "nodes"))
    nodes = items(document, "nodes", dict)
    children = {child for node in nodes for child in items(node, "children", int)}
    return [number for number in reversed(range(len(nodes))) if number not in children]


def _matrix(node, number):
    """The matrix from a node to its parent."""
    def numbers(name, default):
        values = node.get(name, default)
        if (not isinstance(values, list) or len(values) != len(default)
                or not all(isinstance(value, (int, float)) for value in values)):
            raise Invalid(f"{name} of node {number} is not {len(default)} numbers")
        return np.array(values, float)

    if "matrix" in node:
        return numbers("matrix", [0.0] * 16).reshape(4, 4).T
    matrix = np.identity(4)
    x, y, z, w = numbers("rotation", [0.0, 0.0, 0.0, 1.0])
    cross = np.array(((0, -z, y), (z, 0, -x), (-y, x, 0)))
    rotation = np.identity(3) + 2 * w * cross + 2 * cross @ cross
    matrix[:3, :3] = rotation * numbers("scale", [1.0, 1.0, 1.0])
    matrix[:3, 3] = numbers("translation", [0.0, 0.0, 0.0])
    return matrix


class _Meshes:
    """The meshes of a document, each decoded once."""

    def __init__(self, document, accessors):
        self._meshes = items(document, "meshes", dict)
        self._accessors = accessors
        self._known = {}
        self._triangles = 0

    def get(self, node):
        """Points and triangles of each primitive of a node's mesh; lines and points have none."""
        if "mesh" not in node:
            return []
        number = whole(node["mesh"], "a mesh", len(self._meshes))
        if "skin" in node:
            raise Invalid(f"mesh {number} is bent by bones (a skin), which cannot be read: save it "
                          "in its pose, without bones")
        mesh = self._meshes[number]
        if any(node.get("weights", mesh.get("weights", ()))):
            raise Invalid(f"mesh {number} is changed by the weights of morph targets, which cannot "
                          "be read: save it in its shape, without morph targets")
        if number not in self._known:
            parts = [self._read(part, number) for part in items(mesh, "primitives", dict)]
            self._known[number] = [part for part in parts if part]
        return self._known[number]

    def count(self, triangles):
        """Raise Invalid if there are too many triangles; a mesh counts for each of its nodes."""
        self._triangles += triangles
        if self._triangles > _MAXIMUM_TRIANGLES:
            raise Invalid(f"it has more than {_MAXIMUM_TRIANGLES:,} triangles")

    def _read(self, part, number):
        mode = part.get("mode", _TRIANGLES)
        attributes = part.get("attributes")
        if mode not in (_TRIANGLES, _STRIP, _FAN):
            return None
        if not isinstance(attributes, dict) or "POSITION" not in attributes:
            raise Invalid(f"mesh {number} has triangles without positions")
        points = self._accessors.points(attributes["POSITION"])
        indices = (self._accessors.indices(part["indices"], len(points)) if "indices" in part
                   else np.arange(len(points)))
        if mode == _TRIANGLES and len(indices) % 3 != 0:
            raise Invalid(f"mesh {number} has {len(indices)} corners of triangles, not a multiple "
                          "of 3")
        return points, _corners(indices, mode)


def _corners(indices, mode):
    """The corners of each triangle."""
    if mode == _TRIANGLES:
        return indices.reshape(-1, 3)
    count = max(len(indices) - 2, 0)
    if mode == _FAN:
        return np.column_stack((np.repeat(indices[:1], count), indices[1:1 + count], indices[2:]))
    corners = np.column_stack((indices[:count], indices[1:1 + count], indices[2:]))
    corners[1::2, :2] = corners[1::2, 1::-1]
    return corners
