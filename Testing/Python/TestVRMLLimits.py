#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The limits of vtkVRMLImporterSource, and the files that it may open."""

import gzip
import os
import unittest
from pathlib import Path

import lms3d
from vrml_reading import HEADER, SQUARE, Scene, SceneTest


class Limits(SceneTest):
    def test_defaults(self):
        reader = lms3d.vtkVRMLImporterSource()
        self.assertEqual(reader.GetEngine(), reader.VRML97)
        self.assertEqual(reader.GetSceneRoot(), None)
        self.assertEqual(reader.GetChordError(), 0.001)
        self.assertEqual(reader.GetMaximumInlineDepth(), 16)
        self.assertEqual(reader.GetMaximumNumberOfNodes(), 2_000_000)
        self.assertEqual(reader.GetMaximumNumberOfTriangles(), 20_000_000)
        self.assertEqual(reader.GetMaximumMemory(), 2_000_000_000)
        self.assertEqual(reader.GetMaximumFileSize(), 1_000_000_000)

    def assert_limit(self, text, least, enough, **limit):
        """At the minimum value everything is read without a message, below it a part is lost."""
        (name, value), = limit.items()
        scene = self.read(text, **limit)
        self.assertEqual((scene.area(), scene.words()), (enough, ""))
        scene = self.read(text, **{name: value - 1})
        self.assert_lost(scene, least)
        self.assertIn(name, scene.words())

    def test_triangles(self):
        self.assert_limit(SQUARE * 10, 9, 10, MaximumNumberOfTriangles=20)
        box = "Shape { geometry Box { size 1 1 1 } }"
        self.assert_limit(SQUARE + box, 1, 7, MaximumNumberOfTriangles=14)

    def test_triangles_of_each_kind_of_geometry(self):
        for text, triangles in (("Extrusion { }", 12), ("Box { }", 12), ("Sphere { }", None),
                                ("Cone { }", None), ("Cylinder { }", None),
                                ("Extrusion { crossSection [ 0 0, 1 0, 1 0, 1 1 ] }", 6),
                                ("ElevationGrid { xDimension 3 zDimension 2"
                                 " height [ 0 0 0 0 0 0 ] }", 4)):
            with self.subTest(text):
                text = f"{SQUARE} Shape {{ geometry {text} }}"
                scene = self.read(text)
                self.assertIn(triangles, (None, scene.triangles - 2))
                self.assert_limit(text, 1, scene.area(), MaximumNumberOfTriangles=scene.triangles)

    def test_triangles_beyond_the_limit_are_not_those_of_what_follows(self):
        scene = self.read("Shape { geometry Extrusion { } }" + SQUARE, MaximumNumberOfTriangles=14)
        self.assertEqual((scene.triangles, scene.words()), (14, ""))

    def test_triangles_count_with_each_use(self):
        text = "DEF A " + SQUARE + "USE A " * 9
        self.assert_limit(text, 9, 10, MaximumNumberOfTriangles=20)

    def test_inline_depth(self):
        for i in range(5):
            self.write(SQUARE + f'Inline {{ url "f{i + 1}.wrl" }}', f"f{i}.wrl")
        self.write(SQUARE, "f5.wrl")
        self.assert_limit('Inline { url "f0.wrl" }', 5, 6, MaximumInlineDepth=6)

    def test_extern_prototypes_count_as_depth(self):
        for i in range(5):
            self.write(f'EXTERNPROTO P [ ] "f{i + 1}.wrl#P"', f"f{i}.wrl")
        self.write(f"PROTO P [ ] {{ {SQUARE} }}", "f5.wrl")
        text = SQUARE + 'EXTERNPROTO P [ ] "f0.wrl#P" P { }'
        self.assertEqual(self.read(text).words(), "")
        self.assert_lost(self.read(text, MaximumInlineDepth=3), 1)

    def test_nodes(self):
        text = SQUARE * 1000
        self.assertEqual(self.read(text, MaximumNumberOfNodes=100_000).words(), "")
        scene = self.read(text, MaximumNumberOfNodes=1000)
        self.assert_lost(scene)
        self.assertIn("MaximumNumberOfNodes", scene.words())
        self.assertGreater(scene.triangles, 0)

    def test_file_size(self):
        size = len(HEADER) + 10 * len(SQUARE)
        scene = self.read(SQUARE * 10, MaximumFileSize=size)
        self.assertEqual((scene.area(), scene.words()), (10, ""))
        scene = self.read(SQUARE * 10, MaximumFileSize=size - 1)
        self.assertEqual(len(scene.errors), 1)
        self.assertIn("MaximumFileSize", scene.words())

    def test_file_size_of_an_inline(self):
        self.write(SQUARE + " " * 100_000, "large.wrl")
        scene = self.read(SQUARE + 'Inline { url "large.wrl" }', MaximumFileSize=10_000)
        self.assert_lost(scene)
        self.assertIn("MaximumFileSize", scene.words())
        self.assertGreaterEqual(scene.area(), 1)

    def test_compression_bomb(self):
        path = self.folder / "bomb.wrz"
        with gzip.open(path, "wb", compresslevel=1) as file:
            file.write(HEADER + SQUARE.encode())
            for _ in range(256):
                file.write(b" " * 1024 ** 2)
        scene = Scene(path, MaximumFileSize=16 * 1024 ** 2)
        self.assertEqual(len(scene.errors), 1)
        self.assertIn("MaximumFileSize", scene.words())

    def test_a_lost_part_is_the_next_file_s_no_more(self):
        reader = lms3d.vtkVRMLImporterSource()
        reader.SetFileName(str(self.write(SQUARE + "USE X", "a.wrl")))
        reader.AddObserver("ErrorEvent", lambda *_: None)
        reader.Update()
        self.assertEqual(reader.GetNumberOfMessages(), 1)
        reader.SetFileName(str(self.write(SQUARE, "b.wrl")))
        reader.Update()
        self.assertEqual(reader.GetNumberOfMessages(), 0)


class Files(SceneTest):
    """The scene has its own folder, with a square in it and one in the folder above."""

    def setUp(self):
        super().setUp()
        self.write(SQUARE, "secret.wrl")
        self.write(f"PROTO P [ ] {{ {SQUARE} }}", "secret_proto.wrl")
        self.write(SQUARE, "scene/beside.wrl")
        self.within = self.folder / "scene"

    def scene(self, text, **properties):
        return Scene(self.write(SQUARE + text, "scene/scene.wrl"), **properties)

    def inline(self, url, **properties):
        return self.scene(f'Inline {{ url "{url}" }}', **properties)

    def test_beside_and_below(self):
        self.write(SQUARE, "scene/a b.wrl")
        self.write(SQUARE, "scene/Wände.wrl")
        for url in ("beside.wrl", "./beside.wrl", "../scene/beside.wrl", "x/../beside.wrl",
                    str(self.within / "beside.wrl"), "file:" + str(self.within / "beside.wrl"),
                    "file://" + str(self.within / "beside.wrl"), "a%20b.wrl",
                    "a b.wrl", "Wände.wrl", "W%C3%A4nde.wrl"):
            with self.subTest(url):
                (self.within / "x").mkdir(exist_ok=True)
                scene = self.inline(url)
                self.assertEqual((scene.area(), scene.words()), (2, ""))

    def test_nothing_outside_the_scene_s_folder(self):
        (self.within / "link.wrl").symlink_to("../secret.wrl")
        (self.within / "up").symlink_to("..", target_is_directory=True)
        for url in ("../secret.wrl", "x/../../secret.wrl", str(self.folder / "secret.wrl"),
                    "file://" + str(self.folder / "secret.wrl"), "link.wrl", "up/secret.wrl",
                    "%2e%2e/secret.wrl", "..%2fsecret.wrl", "../" * 50 + "etc/passwd",
                    "/etc/passwd"):
            with self.subTest(url):
                scene = self.inline(url)
                self.assert_lost(scene, 1)
                self.assertNotIn("root:", scene.words())

    def test_a_folder_whose_name_begins_the_same_is_outside(self):
        self.write(SQUARE, "scene2/secret.wrl")
        self.assert_lost(self.inline("../scene2/secret.wrl"), 1)
        self.assert_lost(self.inline("../scene2/secret.wrl", SceneRoot=str(self.within)), 1)

    def test_scene_root_opens_more(self):
        for root in (self.folder, str(self.folder) + "/", self.within / ".."):
            with self.subTest(root):
                scene = self.inline("../secret.wrl", SceneRoot=str(root))
                self.assertEqual((scene.area(), scene.words()), (2, ""))

    def test_scene_root_opens_less(self):
        self.write(SQUARE, "scene/low/low.wrl")
        scene = self.inline("beside.wrl", SceneRoot=str(self.within / "low"))
        self.assert_lost(scene, 1)
        scene = self.inline("low/low.wrl", SceneRoot=str(self.within / "low"))
        self.assertEqual((scene.area(), scene.words()), (2, ""))

    def test_a_scene_root_that_is_not_there(self):
        scene = self.inline("beside.wrl", SceneRoot=str(self.folder / "none"))
        self.assertIn("SceneRoot", scene.words())
        self.assertEqual(len(scene.errors), 1)

    def test_extern_prototypes_too(self):
        for url in ("../secret_proto.wrl#P", "../secret_proto.wrl"):
            self.assert_lost(self.scene(f'EXTERNPROTO P [ ] "{url}" P {{ }}'), 1)

    def test_regular_files_only(self):
        os.mkfifo(self.within / "pipe.wrl")
        (self.within / "zero.wrl").symlink_to("/dev/zero")
        (self.within / "loop.wrl").symlink_to("loop.wrl")
        (self.within / "folder.wrl").mkdir()
        (self.within / "closed.wrl").write_bytes(HEADER)
        (self.within / "empty.wrl").write_bytes(b"")
        for url in ("pipe.wrl", "zero.wrl", "loop.wrl", "folder.wrl", "empty.wrl", "/dev/zero",
                    "/dev/stdin", "/dev/fd/0", "/proc/self/mem", ".", "..", "/", "", " ",
                    "n" * 300, "n/" * 5000, "n" * 1_000_000, "scene.wrl#x", "a\\\\b.wrl"):
            with self.subTest(url[:40]):
                self.assert_lost(self.inline(url), 1)
                self.assert_lost(self.inline(url, SceneRoot="/"), 1)

    def test_no_network(self):
        for url in ("http://127.0.0.1:9/x.wrl", "HTTPS://localhost/x.wrl", "ftp://localhost/x.wrl",
                    "//localhost/x.wrl", "file://elsewhere/x.wrl", "urn:x:y", "data:model/vrml,x",
                    "javascript:x"):
            with self.subTest(url):
                self.assert_lost(self.inline(url), 1)

    def test_the_scene_itself_is_a_regular_file(self):
        os.mkfifo(self.folder / "pipe.wrl")
        for path in (self.folder / "pipe.wrl", self.folder / "none.wrl", self.folder / ("n" * 5000),
                     self.folder, Path("/dev/zero"), Path("/proc/self/mem")):
            with self.subTest(path.name[:40]):
                scene = Scene(path)
                self.assertEqual(len(scene.errors), 1)
                self.assertEqual(scene.triangles, 0)

    def test_a_relative_file_name(self):
        path = self.write(SQUARE + 'Inline { url "beside.wrl" }', "scene/s.wrl")
        self.assertEqual(Scene(os.path.relpath(path)).area(), 2)
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.within)
        for name in ("s.wrl", "./s.wrl", "../scene/s.wrl"):
            self.assertEqual((Scene(name).area(), Scene(name).words()), (2, ""))


if __name__ == "__main__":
    unittest.main()
