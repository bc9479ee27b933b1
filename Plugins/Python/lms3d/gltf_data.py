# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The numbers of a glTF file: buffers, views of them, and accessors, all with checked limits."""

import base64
import binascii
import stat
from urllib.parse import unquote

import numpy as np

_TYPES = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_UNSIGNED = (5121, 5123, 5125)


class Invalid(Exception):
    """What is wrong with a file."""


def whole(value, what, count=None):
    """A whole number that is not negative, and below `count` if there is one."""
    if isinstance(value, bool) or not isinstance(value, int) or value < 0:
        raise Invalid(f"{what} has the number {value!r}")
    if count is not None and value >= count:
        raise Invalid(f"{what} has the number {value}, but there are {count}")
    return value


def items(container, name, kind=object):
    """A list in an object, empty if it is missing; all its items are of a kind."""
    values = container.get(name, [])
    if not isinstance(values, list) or not all(isinstance(value, kind) for value in values):
        raise Invalid(f"{name} is not a list of {kind.__name__}")
    return values


class Accessors:
    """The arrays that a document describes. `folder` has its files, `binary` is a .glb's part."""

    def __init__(self, document, folder, binary):
        self._accessors = items(document, "accessors", dict)
        self._views = items(document, "bufferViews", dict)
        self._buffers = items(document, "buffers", dict)
        self._folder = folder.resolve()
        self._binary = binary
        self._known = {}

    def points(self, number):
        """The coordinates of an accessor: N x 3."""
        accessor, values = self._read(number, "VEC3", 3)
        kind = accessor["componentType"]
        values = values.astype(float)
        if accessor.get("normalized") and kind != 5126:
            limits = np.iinfo(_TYPES[kind])
            values = np.maximum(values / limits.max, -1.0)
        if not np.isfinite(values).all():
            raise Invalid(f"accessor {number} has coordinates that are not finite")
        return values

    def indices(self, number, count):
        """The numbers of vertices in an accessor, all below `count`."""
        accessor, values = self._read(number, "SCALAR", 1)
        if accessor["componentType"] not in _UNSIGNED:
            raise Invalid(f"accessor {number} has numbers of vertices that are no unsigned integers")
        if values.size and values.max() >= count:
            raise Invalid(f"accessor {number} has the vertex {values.max()}, but there are {count}")
        return values.ravel().astype(np.int64)

    def _read(self, number, kind, width):
        accessor = self._accessors[whole(number, "an accessor", len(self._accessors))]
        what = f"accessor {number}"
        if accessor.get("type") != kind:
            raise Invalid(f"{what} is of type {accessor.get('type')}, not {kind}")
        count = whole(accessor.get("count"), f"count of {what}")
        if "bufferView" in accessor:
            values = self._view(accessor, count, width, what)
        elif "sparse" not in accessor:
            raise Invalid(f"{what} has no data")
        else:
            self._check_sparse(accessor, count, what)
            values = np.zeros((count, width), self._type(accessor, what))
        return accessor, self._add_sparse(accessor, values, what)

    def _view(self, accessor, count, width, what):
        """An array in a view of a buffer."""
        number = whole(accessor["bufferView"], f"the view of {what}", len(self._views))
        view = self._views[number]
        content = self._buffer(whole(view.get("buffer"), f"the buffer of view {number}",
                                     len(self._buffers)))
        first = whole(view.get("byteOffset", 0), f"byteOffset of view {number}")
        length = whole(view.get("byteLength"), f"byteLength of view {number}")
        if first + length > len(content):
            raise Invalid(f"view {number} ends at byte {first + length:,} of a buffer with "
                          f"{len(content):,}")
        offset = whole(accessor.get("byteOffset", 0), f"byteOffset of {what}")
        kind = self._type(accessor, what)
        step = whole(view.get("byteStride", width * kind.itemsize), f"byteStride of view {number}")
        end = offset + step * (count - 1) + width * kind.itemsize
        if count and (end > length or step < width * kind.itemsize):
            raise Invalid(f"{what} ends at byte {end:,} of a view with {length:,}")
        if count == 0:
            return np.empty((0, width), kind)
        return np.ndarray((count, width), kind, content, first + offset, (step, kind.itemsize))

    @staticmethod
    def _type(accessor, what):
        kind = accessor.get("componentType")
        if not isinstance(kind, int) or kind not in _TYPES:
            raise Invalid(f"{what} has the unknown componentType {kind}")
        return np.dtype(_TYPES[kind])

    @staticmethod
    def _check_sparse(accessor, count, what):
        """Zeros need no bytes in the file, so their number needs a limit of its own."""
        if count > 100_000_000:
            raise Invalid(f"{what} has {count:,} values without data")

    def _add_sparse(self, accessor, values, what):
        """The array with the values that replace some of its rows."""
        sparse = accessor.get("sparse")
        if sparse is None:
            return values
        parts = [sparse.get(name) for name in ("indices", "values")] if isinstance(
            sparse, dict) else [None]
        if not all(isinstance(part, dict) and "bufferView" in part for part in parts):
            raise Invalid(f"{what} is not sparse as glTF says")
        count = whole(sparse.get("count"), f"count of sparse {what}")
        rows = self._view(parts[0], count, 1, f"sparse {what}").ravel()
        if parts[0].get("componentType") not in _UNSIGNED or (rows >= len(values)).any():
            raise Invalid(f"{what} is sparse with rows that it does not have")
        values = values.copy()
        values[rows] = self._view({**parts[1], "componentType": accessor["componentType"]}, count,
                                  values.shape[1], f"sparse {what}")
        return values

    def _buffer(self, number):
        if number not in self._known:
            buffer = self._buffers[number]
            content = self._load(buffer, number)
            length = whole(buffer.get("byteLength"), f"byteLength of buffer {number}")
            if len(content) < length:
                raise Invalid(f"buffer {number} has {len(content):,} of {length:,} bytes")
            self._known[number] = memoryview(content)[:length]
        return self._known[number]

    def _load(self, buffer, number):
        """The bytes of a buffer: in the .glb, in the text, or in another file."""
        address = buffer.get("uri")
        if address is None and number == 0 and self._binary is not None:
            return self._binary
        if not isinstance(address, str):
            raise Invalid(f"buffer {number} has no data")
        if address.startswith("data:"):
            try:
                return base64.b64decode(address.partition(",")[2], validate=True)
            except binascii.Error as error:
                raise Invalid(f"buffer {number} is not valid base64: {error}") from error
        return self._load_file(address)

    def _load_file(self, address):
        name = unquote(address)
        path = (self._folder / name).resolve() if "\0" not in name else self._folder
        if ":" in address.split("/")[0] or self._folder not in path.parents:
            raise Invalid(f"its data is in '{address}', which is not in the folder of the file")
        if not path.exists():
            raise Invalid(f"its data is in '{address}', which does not exist")
        if not stat.S_ISREG(path.stat().st_mode):
            raise Invalid(f"its data is in '{address}', which is not a regular file")
        return np.fromfile(path, np.uint8).tobytes()
