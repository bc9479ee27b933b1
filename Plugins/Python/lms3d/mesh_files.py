# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks .ply, .stl and .obj files before VTK reads them.

If a file is cut off, VTK's reader for PLY ends the process, and the one for STL returns what is
there. The one for OBJ takes what is no number for 0.
"""

import math
import struct
from pathlib import Path

import numpy as np

from .problems import Problem

_TYPES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
          "float": "f4", "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2",
          "int32": "i4", "uint32": "u4", "float32": "f4", "float64": "f8"}
_ORDERS = {"ascii": "", "binary_little_endian": "<", "binary_big_endian": ">"}
_MAXIMUM_HEADER = 1 << 16
_CUT_OFF = "the file is cut off"


def check_mesh_file(path, failure):
    """Raise Problem, beginning with `failure`, if VTK's reader would not read the file as it is."""
    check = {".ply": _find_fault_of_ply, ".stl": _find_fault_of_stl, ".obj": _find_fault_of_obj}.get(
        Path(path).suffix.lower())
    if not check:
        return
    try:
        fault = check(path)
    except OSError as error:
        fault = error.strerror
    except MemoryError:
        fault = "not enough memory"
    if fault:
        raise Problem(f"{failure}: {fault}")


def _find_fault_of_stl(path):
    """Binary files say how many triangles they have. VTK checks the end of a text file."""
    size = Path(path).stat().st_size
    with open(path, "rb") as file:
        head = file.read(1024)
    if size < 84 or (head[:5].lower() == b"solid" and b"\0" not in head):
        return None
    expected, found = int.from_bytes(head[80:84], "little"), (size - 84) // 50
    return f"{_CUT_OFF}: it has {found:,} of {expected:,} triangles" if found < expected else None


def _find_fault_of_obj(path):
    """Each vertex needs three numbers."""
    with open(path, "rb") as file:
        for number, line in enumerate(file, 1):
            words = line.split(None, 4)[:4]
            if words[:1] == [b"v"] and not line.rstrip().endswith(b"\\"):
                try:
                    is_valid = len(words) == 4 and all(map(math.isfinite, map(float, words[1:])))
                except ValueError:
                    is_valid = False
                if not is_valid:
                    return f"line {number} is a vertex without three finite numbers"
    return None


def _find_fault_of_ply(path):
    """The header says what follows."""
    with open(path, "rb") as file:
        head = file.read(_MAXIMUM_HEADER)
        text, end, rest = head.partition(b"end_header")
        if not head.startswith(b"ply") or not end:
            return "this is no PLY file: it has no header"
        line = rest[:2] if rest.startswith(b"\r\n") else rest[:1]
        file.seek(len(text) + len(end) + len(line))
        try:
            order, elements = _read_header(text.decode("ascii"))
        except (KeyError, ValueError, IndexError, UnicodeDecodeError):
            return "its header is not valid"
        return _check_text(file, elements) if order == "" else _check_binary(
            np.fromfile(file, np.uint8).tobytes(), order, elements)


def _read_header(text):
    """The byte order, and for each element its name, count and types; a list has a pair of types."""
    order, elements = None, []
    for words in map(str.split, text.splitlines()[1:]):
        if words[:1] == ["format"]:
            order = _ORDERS[words[1]]
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:2] == ["property", "list"]:
            elements[-1][2].append((_TYPES[words[2]], _TYPES[words[3]]))
        elif words[:1] == ["property"]:
            elements[-1][2].append(_TYPES[words[1]])
    if order is None or any(count < 0 for _, count, _ in elements):
        raise ValueError
    return order, elements


def _check_text(file, elements):
    """A line for each element, with all its numbers."""
    for name, count, types in elements:
        for number in range(count):
            words = file.readline().split()
            try:
                is_complete = len(words) >= _count_words(words, types)
            except (IndexError, ValueError):
                is_complete = False
            if not is_complete:
                return f"{_CUT_OFF}, or a line lacks numbers: {name} {number:,} of {count:,}"
    return None


def _count_words(words, types):
    """How many words an element needs."""
    needed = 0
    for kind in types:
        needed += 1
        if isinstance(kind, tuple):
            length = int(words[needed - 1])
            if length < 0:
                raise ValueError
            needed += length
    return needed


def _check_binary(content, order, elements):
    """The bytes of each element."""
    first = 0
    for name, count, types in elements:
        if count == 0:
            continue
        size = _element_size(content, first, order, types)
        if size and _are_alike(content, first, order, types, size, count):
            first += count * size
            continue
        for number in range(count):
            size = _element_size(content, first, order, types)
            if size is None or first + size > len(content):
                return f"{_CUT_OFF}: it has {number:,} of {count:,} elements '{name}'"
            first += size
    return None


def _element_size(content, first, order, types):
    """The size of the element at a place, or None if it is not there."""
    place = first
    for kind in types:
        if not isinstance(kind, tuple):
            place += np.dtype(kind).itemsize
            continue
        length = _read_number(content, place, order, kind[0])
        if length is None or length < 0:
            return None
        place += np.dtype(kind[0]).itemsize + int(length) * np.dtype(kind[1]).itemsize
    return place - first


def _read_number(content, place, order, kind):
    code = (order or "<") + np.dtype(kind).char
    try:
        return struct.unpack_from(code, content, place)[0]
    except struct.error:
        return None


def _are_alike(content, first, order, types, size, count):
    """Whether all elements are there and have lists as long as the first one's."""
    if first + count * size > len(content):
        return False
    place = 0
    for kind in types:
        if not isinstance(kind, tuple):
            place += np.dtype(kind).itemsize
            continue
        lengths = np.ndarray(count, order + kind[0], content, first + place, size)
        if (lengths != lengths[0]).any():
            return False
        place += np.dtype(kind[0]).itemsize + int(lengths[0]) * np.dtype(kind[1]).itemsize
    return True
