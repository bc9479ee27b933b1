# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes glTF files for tests: any document, as .gltf or .glb."""

import base64
import json

import numpy as np

SQUARE = np.array(((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)), "<f4")
HALVES = np.array((0, 1, 2, 0, 2, 3), "<u2")


def document(points=SQUARE, corners=HALVES):
    """A document with one node, and the bytes of its buffer; y is up."""
    binary = points.tobytes() + corners.tobytes()
    types = {"uint16": 5123, "uint32": 5125}
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": len(binary)}],
        "bufferViews": [{"buffer": 0, "byteLength": points.nbytes},
                        {"buffer": 0, "byteOffset": points.nbytes, "byteLength": corners.nbytes}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
                       "min": points.min(axis=0).tolist(), "max": points.max(axis=0).tolist()},
                      {"bufferView": 1, "componentType": types[corners.dtype.name],
                       "count": corners.size, "type": "SCALAR"}],
    }, binary


def write_text(path, content, binary):
    """Write a .gltf; the buffer becomes a part of the text, if it has no address."""
    address = "data:application/octet-stream;base64," + base64.b64encode(binary).decode()
    buffers = [{"uri": address, **buffer} for buffer in content["buffers"]]
    path.write_text(json.dumps({**content, "buffers": buffers}))


def write_binary(path, content, binary):
    """Write a .glb."""
    text = json.dumps(content).encode()
    parts = [(b"JSON", text.ljust(-len(text) // 4 * -4)),
             (b"BIN\0", binary.ljust(-len(binary) // 4 * -4, b"\0"))]
    body = b"".join(len(part).to_bytes(4, "little") + name + part for name, part in parts)
    path.write_bytes(b"glTF" + np.array((2, 12 + len(body)), "<u4").tobytes() + body)
