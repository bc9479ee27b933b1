#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes as .ply, .stl, .obj and .vtp that are cut off or not valid: one line says what is wrong."""

import struct
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkVersion

from command_line import CommandLineTest

# VTK 9.3 refuses a vertex on two lines, and has other words.
IS_STRICT = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()) >= (9, 3)

TRIANGLE = ((0, 0, 0), (1, 0, 0), (0, 1, 0))
FACET = struct.pack("<12fH", 0, 0, 1, *np.ravel(TRIANGLE), 0)

PLY = ("ply\nformat {form} 1.0\ncomment a test\nelement vertex 3\nproperty float x\n"
       "property float y\nproperty float z\nelement face {faces}\n"
       "property list uchar int vertex_indices\nproperty uchar red\nend_header\n")
PLY_POINTS = "0 0 0\n1 0 0\n0 1 0\n"

VTP = ('<VTKFile type="PolyData" version="1.0"><PolyData><Piece NumberOfPoints="3" '
       'NumberOfPolys="1"><Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">'
       '0 0 0 1 0 0 0 1 0</DataArray></Points><Polys><DataArray type="Int64" Name="connectivity" '
       'format="ascii">0 1 {corner}</DataArray><DataArray type="Int64" Name="offsets" '
       'format="ascii">3</DataArray></Polys></Piece></PolyData></VTKFile>')


def binary_ply(order, faces):
    """A file with triangles, then a quadrangle, if there are faces."""
    name = {"<": "little", ">": "big"}[order]
    head = PLY.format(form=f"binary_{name}_endian", faces=len(faces)).encode()
    body = struct.pack(order + "9f", *np.ravel(TRIANGLE))
    for corners in faces:
        body += struct.pack(f"{order}B{len(corners)}iB", len(corners), *corners, 200)
    return head + body


class TestMeshFiles(CommandLineTest):
    """Each file is scanned from above."""

    SCAN = ("--position", 0.2, 0.2, 1, "--alpha-resolution", 31, "--beta-resolution", 12, "-o")

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def assert_triangles(self, count, name, content):
        path = self.write(name, content)
        words = self.done("scan", path, *self.SCAN, self.folder / "scan.csv")
        self.assertIn(f"{name}: {count} triangle{'s' * (count != 1)},", words)

    def assert_fault(self, words, name, content):
        path = self.write(name, content)
        result = self.refused(1, "scan", path, *self.SCAN, self.folder / "fault.csv")
        self.assertIn(f"cannot read scene '{path}': ", result)
        self.assertIn(words, result)

    def test_ply(self):
        text = PLY.format(form="ascii", faces=2) + PLY_POINTS
        self.assert_triangles(2, "good.ply", text + "3 0 1 2 200\n3 0 2 1 200\n")
        self.assert_fault("face 1 of 2", "cut.ply", text + "3 0 1 2 200\n")
        self.assert_fault("face 1 of 2", "line.ply", text + "3 0 1 2 200\n3 0 2")
        self.assert_fault("face 0 of 2", "negative.ply", text + "-3 0 1 2 200\n3 0 1 2 200\n")
        self.assert_fault("vertex 2 of 3", "points.ply", text[:-6])
        self.assert_fault("it has no header", "text.ply", "hello")
        self.assert_fault("it has no header", "empty.ply", "")
        self.assert_fault("header is not valid", "type.ply", text.replace("float", "length"))
        self.assert_fault("header is not valid", "count.ply", text.replace("vertex 3", "vertex -3"))

    def test_binary_ply(self):
        for order in "<>":
            for faces, count in (([(0, 1, 2)] * 3, 3), ([(0, 1, 2), (0, 1, 2, 0), (0, 1, 2)], 4)):
                whole = binary_ply(order, faces)
                with self.subTest(order + str(count)):
                    self.assert_triangles(count, "good.ply", whole)
                    for missing in (1, 15, 27):
                        self.assert_fault("the file is cut off", "cut.ply", whole[:-missing])
                    self.assert_fault("0 of 3 elements 'vertex'", "head.ply",
                                      whole.partition(b"end_header\n")[0] + b"end_header\n")

    def test_binary_stl(self):
        head = b"solid or not".ljust(80, b"\0")
        for count, facets in ((1, 1), (1, 3)):  # more than the header says is read, too
            self.assert_triangles(facets, "good.stl",
                                  head + struct.pack("<I", count) + facets * FACET)
        for count, content in ((2, FACET + FACET[:-1]), (2**32 - 1, FACET), (1, b"")):
            self.assert_fault("the file is cut off: it has ", "cut.stl",
                              head + struct.pack("<I", count) + content)

    def test_stl_of_text(self):
        text = ("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n")
        self.assert_triangles(1, "good.stl", text)
        self.assert_fault("STLReader", "cut.stl", text[:70])

    def test_obj(self):
        text = "# a test\nv 0 0 0\nv 1 0 0 1.0\nv 0 1 0\nf 1 2 3\n"
        self.assert_triangles(1, "good.obj", text)
        on_two_lines = "long.obj", text.replace("1 0 0 1.0", "1 \\\n0 0")
        if IS_STRICT:
            self.assert_fault("L.3", *on_two_lines)
        else:
            self.assert_triangles(1, *on_two_lines)
        for vertex in ("0 1", "0 1 nan", "0 1 1e999", "0 1 a"):
            self.assert_fault("line 4 is a vertex without three finite numbers", "bad.obj",
                              text.replace("v 0 1 0", f"v {vertex}"))
        self.assert_fault("L.5" if IS_STRICT else "line 5", "face.obj",
                          text.replace("f 1 2 3", "f a b c"))

    def test_vtp(self):
        self.assert_triangles(1, "good.vtp", VTP.format(corner=2))
        self.assert_fault("", "cut.vtp", VTP[:80])
        path = self.write("corner.vtp", VTP.format(corner=99999999))
        self.assertIn("uses point 99999999 of 3",
                      self.refused(1, "scan", path, *self.SCAN, self.folder / "fault.csv"))


if __name__ == "__main__":
    unittest.main()
