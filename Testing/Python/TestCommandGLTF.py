#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""glTF scenes: what is read equals what VTK's own reader makes of valid files, turned to z-up.

Files that are not valid, or that cannot be read as they are, give one line of error.
"""

import copy
import json
import random
import unittest

import numpy as np
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkCompositeDataGeometryFilter
from vtkmodules.vtkIOGeometry import vtkGLTFReader

from command_line import POSE, ROOM, CommandLineTest, points, read, room, triangles
from gltf_pieces import HALVES, SQUARE, document, write_binary, write_text
from lms3d.problems import Problem
from lms3d.scene import read_scene

HALF = 0.5 ** 0.5


def changed(place, value, *more):
    """The document of the tests with a value at a place, and further pairs of a place and a value."""
    content, _ = document()
    for names, new in ((place, value), *zip(more[::2], more[1::2])):
        part = content
        for name in names[:-1]:
            part = part[name]
        if new is None:
            del part[names[-1]]
        else:
            part[names[-1]] = new
    return content


PRIMITIVE = ("meshes", 0, "primitives", 0)
NODE = ("nodes", 0)

VALID = {
    "plain": document()[0],
    "strip": changed((*PRIMITIVE, "mode"), 5, (*PRIMITIVE, "indices"), None),
    "fan": changed((*PRIMITIVE, "mode"), 6, (*PRIMITIVE, "indices"), None),
    "without indices": changed((*PRIMITIVE, "indices"), None, ("accessors", 0, "count"), 3),
    "moved": changed((*NODE, "translation"), [1, 2, 3], (*NODE, "scale"), [2, 3, 4],
                     (*NODE, "rotation"), [HALF, 0, 0, HALF]),
    "mirrored": changed((*NODE, "scale"), [-1, 1, 1]),
    "nested": changed(("nodes",), [
        {"children": [1, 2], "rotation": [0, HALF, 0, HALF]},
        {"mesh": 0, "matrix": [0, 1, 0, 0, -2, 0, 0, 0, 0, 0, 3, 0, 5, 6, 7, 1]}, {"mesh": 0}]),
    "second scene": changed(("nodes",), [{"mesh": 0}, {"mesh": 0, "translation": [0, 0, 1]}],
                            ("scenes",), [{"nodes": [0]}, {"nodes": [1]}], ("scene",), 1),
    "harmless extension": changed(("extensionsRequired",), ["KHR_materials_unlit"],
                                  ("extensionsUsed",), ["KHR_materials_unlit"]),
}

INVALID = {
    "no list of nodes": (changed(("nodes",), 7), "nodes is not a list"),
    "node": (changed((*NODE, "children"), [9]), "a node has the number 9, but there are 1"),
    "cycle": (changed((*NODE, "children"), [0]), "node 0 is used twice"),
    "mesh": (changed((*NODE, "mesh"), -1), "a mesh has the number -1"),
    "translation": (changed((*NODE, "translation"), ["a", 2, 3]), "is not 3 numbers"),
    "infinite": (changed((*NODE, "scale"), [1e308, 1e308, 1e308], (*NODE, "translation"),
                         [1e308, 1, 1], (*NODE, "rotation"), [9e99, 9e99, 9e99, 9e99]), "finite"),
    "positions": (changed((*PRIMITIVE, "attributes"), {}), "without positions"),
    "corners": (changed(("accessors", 1, "count"), 5), "not a multiple of 3"),
    "accessor": (changed((*PRIMITIVE, "indices"), 77), "the number 77, but there are 2"),
    "vertex": (changed(("accessors", 0, "count"), 3), "has the vertex 3, but there are 3"),
    "long accessor": (changed(("accessors", 0, "count"), 10**9), "of a view with 48"),
    "long view": (changed(("bufferViews", 0, "byteLength"), 4800), "of a buffer with 60"),
    "negative offset": (changed(("bufferViews", 0, "byteOffset"), -5), "the number -5"),
    "long buffer": (changed(("buffers", 0, "byteLength"), 99), "has 60 of 99 bytes"),
    "type": (changed(("accessors", 0, "type"), "VEC2"), "is of type VEC2, not VEC3"),
    "component": (changed(("accessors", 0, "componentType"), 1), "unknown componentType 1"),
    "missing file": (changed(("buffers", 0, "uri"), "no.bin"), "'no.bin', which does not exist"),
    "file elsewhere": (changed(("buffers", 0, "uri"), "..%2fno.bin"), "not in the folder"),
    "address": (changed(("buffers", 0, "uri"), "http://example.org/a"), "not in the folder"),
    "version": (changed(("asset", "version"), "1.0"), "glTF 2.0 can be read, not glTF 1.0"),
    "compressed": (changed(("extensionsRequired",), ["KHR_draco_mesh_compression"]),
                   "it needs the extension KHR_draco_mesh_compression"),
    "bones": (changed((*NODE, "skin"), 0), "bent by bones"),
    "weights": (changed((*NODE, "weights"), [0, 0.5]), "morph targets"),
    "instances": (changed((*NODE, "extensions"), {"EXT_mesh_gpu_instancing": {}}), "instances"),
    "lines": (changed((*PRIMITIVE, "mode"), 1), "no triangles"),
}


class TestGLTF(CommandLineTest):
    """Files that the tests write."""

    def path(self, name):
        return self.folder / name.replace(" ", "_")

    def test_the_same_surface_as_by_vtk(self):
        for name, content in VALID.items():
            for ending, write in ((".gltf", write_text), (".glb", write_binary)):
                with self.subTest(name + ending):
                    path = self.path(name + ending)
                    write(path, content, document()[1])
                    expected = self.read_by_vtk(path)
                    if name == "mirrored":  # glTF says that reflections turn triangles; VTK does not
                        expected = expected[:, ::-1]
                    found = self.corners(read_scene(path, "z").surface)
                    np.testing.assert_allclose(self.sorted(found), self.sorted(expected), atol=1e-6)
                    turned = self.corners(read_scene(path).surface)
                    np.testing.assert_allclose(turned, found[:, :, (0, 2, 1)] * (1, -1, 1),
                                               atol=1e-12)

    @staticmethod
    def read_by_vtk(path):
        surface = vtkCompositeDataGeometryFilter()
        surface.SetInputDataObject(read(vtkGLTFReader(), path))
        split = vtkTriangleFilter()
        split.SetInputConnection(surface.GetOutputPort())
        split.Update()
        return TestGLTF.corners(split.GetOutput())

    @staticmethod
    def corners(surface):
        """The corners of each triangle: N x 3 x 3."""
        return points(surface)[triangles(surface)].astype(float)

    @staticmethod
    def sorted(corners):
        """The triangles in the order of their corners, each with its smallest corner first."""
        first = [min(range(3), key=lambda i, each=each: each[i].round(5).tolist())
                 for each in corners]
        turned = [np.roll(each, -i, axis=0) for each, i in zip(corners, first)]
        return np.array(sorted((each.round(5) + 0.0 for each in turned),
                               key=lambda each: each.ravel().tolist()))

    def test_reflections_keep_the_front(self):
        path = self.path("mirrored.gltf")
        write_text(path, VALID["mirrored"], document()[1])
        a, b, c = np.moveaxis(self.corners(read_scene(path, "z").surface), 1, 0)
        np.testing.assert_array_equal(np.cross(b - a, c - a)[:, 2] > 0, True)

    def test_data_in_another_file(self):
        content, binary = document()
        content["buffers"][0]["uri"] = "a%20square.bin"
        (self.folder / "a square.bin").write_bytes(binary)
        write_text(self.path("file.gltf"), content, binary)
        self.assertEqual(read_scene(self.path("file.gltf")).triangles, 2)

    def test_a_sparse_accessor(self):
        content, binary = document()
        moved = np.array((0, 0, 9), "<f4").tobytes()
        content["bufferViews"] += [{"buffer": 0, "byteOffset": 60, "byteLength": 4},
                                   {"buffer": 0, "byteOffset": 64, "byteLength": 12}]
        content["buffers"][0]["byteLength"] = 76
        content["accessors"][0]["sparse"] = {
            "count": 1, "indices": {"bufferView": 2, "componentType": 5125},
            "values": {"bufferView": 3}}
        binary += np.array(2, "<u4").tobytes() + moved
        write_binary(self.path("sparse.glb"), content, binary)
        expected = SQUARE.copy()
        expected[2] = 0, 0, 9
        np.testing.assert_array_equal(
            points(read_scene(self.path("sparse.glb"), "z").surface), expected)

    def test_quantized_and_interleaved_coordinates(self):
        content, _ = document()
        table = np.zeros(4, [("points", "<i2", 3), ("unused", "<u2")])
        table["points"] = SQUARE * 32767
        content["bufferViews"] = [{"buffer": 0, "byteLength": 32, "byteStride": 8},
                                  {"buffer": 0, "byteOffset": 32, "byteLength": 12}]
        content["accessors"][0].update(componentType=5122, normalized=True)
        content["buffers"][0]["byteLength"] = 44
        write_binary(self.path("small.glb"), content, table.tobytes() + HALVES.tobytes())
        np.testing.assert_array_equal(points(read_scene(self.path("small.glb"), "z").surface), SQUARE)

    def test_the_room(self):
        """A scan of the room as glTF has the ranges of the room as VRML."""
        surface = room()
        y_up = points(surface)[:, (0, 2, 1)] * (1, 1, -1)
        content, binary = document(y_up.astype("<f4"), triangles(surface).astype("<u4"))
        expected = self.coarse_ranges("wrl", ROOM, *POSE)
        for path, write in ((self.path("room.glb"), write_binary),
                            (self.path("room.gltf"), write_text)):
            write(path, content, binary)
            ranges = self.coarse_ranges("gltf", path, *POSE)
            self.assertGreater(np.isclose(ranges, expected, atol=1e-4).mean(), 0.99)
        words = self.done("info", path)
        self.assertIn("turned from y-up to z-up", words)
        self.assertIn("axes as in the file", self.done("info", path, "--up-axis", "z"))

    def test_files_that_cannot_be_read(self):
        for name, (content, words) in INVALID.items():
            with self.subTest(name):
                path = self.path("bad.gltf")
                write_text(path, content, document()[1])
                with self.assertRaises(Problem) as caught:
                    read_scene(path)
                self.assertIn(words, str(caught.exception))
                self.assertNotIn("\n", str(caught.exception))

    def test_bad_files_on_the_command_line(self):
        path = self.path("bad.glb")
        write_binary(path, document()[0], document()[1])
        whole = path.read_bytes()
        for content, words in ((b"", "does not begin with glTF"), (whole[:15], "cut off"),
                               (whole[:-9], "cut off"), (b"glTF" + whole[:4] * 9, "not glTF"),
                               (whole[:12], "cut off")):
            path.write_bytes(content)
            self.assertIn(words, self.refused(1, "info", path))
        self.assertIn("is not a VRML file", self.refused(2, "info", path, "--scene-nodes", 5))
        text = self.path("bad.gltf")
        for content in ("", "{", "[]", "{}", "[" * 99999, "\0\xff", '{"asset": 5}'):
            text.write_text(content)
            self.assertIn("cannot read scene", self.refused(1, "info", text))

    def test_random_faults(self):
        """Any change gives a scene or a Problem."""
        choices = random.Random(5)
        path = self.path("random.glb")
        values = (None, -1, 0, 1, 2, 3, 5, 1e400, 10**400, 1.5, "a", [], {}, [1], True, 2**32)
        outcomes = {"scene": 0, "problem": 0}
        for _ in range(1000):
            content = copy.deepcopy(choices.choice(list(VALID.values())))
            for _ in range(choices.randint(1, 3)):
                self.damage(content, choices, values)
            try:
                write_binary(path, content, document()[1])
                read_scene(path)
                outcomes["scene"] += 1
            except Problem:
                outcomes["problem"] += 1
        self.assertGreater(min(outcomes.values()), 50)

    @staticmethod
    def damage(content, choices, values):
        """Replace or remove a random value."""
        part = content
        while True:
            keys = list(part) if isinstance(part, dict) else list(range(len(part)))
            if not keys:
                return
            key = choices.choice(keys)
            if isinstance(part[key], (dict, list)) and choices.random() < 0.8:
                part = part[key]
            elif choices.random() < 0.2:
                del part[key]
                return
            else:
                part[key] = json.loads(json.dumps(choices.choice(values)))
                return


if __name__ == "__main__":
    unittest.main()
