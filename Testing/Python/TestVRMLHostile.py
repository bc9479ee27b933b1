#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes made to break a reader. None may crash or hang, a message must report each loss, and the
rest of the scene must be read. The tests write the files, since many are large."""

import math
import subprocess
import sys
import textwrap
import unittest

import numpy as np

from vrml_reading import FACE, SQUARE, SceneTest

FEW = {"MaximumNumberOfTriangles": 100_000}


class Depth(SceneTest):
    DEPTH = 200_000

    def test_deep_groups(self):
        for opening in ("Group { children [ ", "Transform { children ", "Unknown { children ",
                        "Shape { geometry ", "Anchor { a { b [ "):
            for closing in ("] } " if "[" in opening else "} ", ""):
                with self.subTest(opening + "..." + closing):
                    self.assert_lost(self.read(
                        SQUARE + opening * self.DEPTH + SQUARE + closing * self.DEPTH), None)

    def test_what_follows_a_deep_group_is_read(self):
        deep = "Group { children [ " * self.DEPTH + SQUARE + "] } " * self.DEPTH
        self.assert_lost(self.read(SQUARE + deep + SQUARE), 2)

    def test_deep_brackets_and_braces(self):
        for text in ("[" * self.DEPTH, "{" * self.DEPTH, "Group { children " + "[" * self.DEPTH,
                     "Group { x " + "[ { " * self.DEPTH, "]" * self.DEPTH, "}" * self.DEPTH):
            with self.subTest(text[:30]):
                scene = self.read(SQUARE + text)
                self.assertEqual(scene.triangles, 2)
                self.assertGreater(len(scene.messages), 0)

    def test_deep_prototypes(self):
        for opening, closing in (("PROTO P [ ] { ", "} "),
                                 ("PROTO P [ field SFNode n Shape { geometry ", "} ] { } "),
                                 ("PROTO P [ field MFNode n [ ", "] ] { } "),
                                 ("EXTERNPROTO P [ ] [ ", "] "),
                                 ("Script { field SFNode n ", "} "),
                                 ("Script { field MFNode n [ PROTO P [ field MFNode n [ ",
                                  "] ] { } ] } ")):
            for text in (opening * self.DEPTH, opening * self.DEPTH + closing * self.DEPTH):
                with self.subTest(opening, ends=text.endswith(closing)):
                    scene = self.read(SQUARE + text)
                    self.assert_lost(scene, 1)

    def test_a_node_too_deep_is_not_shown(self):
        for depth, area in ((999, 2), (1000, 1)):
            square = "DEF S " + SQUARE.replace("geometry", "appearance NULL geometry")
            boxes = "Group { children [ " * (depth - 2) + square + "] } " * (depth - 2)
            with self.subTest(depth):
                scene = self.read(SQUARE + boxes)
                self.assertEqual((scene.area(), bool(scene.words())), (area, area == 1))

    def test_deep_by_use(self):
        uses = [f"DEF A{i} Group {{ children USE A{i - 1} }}" for i in range(1, self.DEPTH)]
        self.assert_lost(self.read(
            SQUARE + "DEF A0 " + SQUARE + "Switch { choice [" + "\n".join(uses) + "] }\n"
            + f"USE A{self.DEPTH - 1}"), None)

    def test_deep_by_prototypes_of_prototypes(self):
        bodies = [f"PROTO P{i} [ field SFVec3f s 1 1 1 ] {{ P{i - 1} {{ s IS s }} }}"
                  for i in range(1, self.DEPTH)]
        self.assert_lost(self.read(
            SQUARE + "PROTO P0 [ field SFVec3f s 1 1 1 ] { Shape { geometry Box { size IS s } } }\n"
            + "\n".join(bodies) + f"\nP{self.DEPTH - 1} {{ s 2 2 2 }}"), 1)


class Recursion(SceneTest):
    def test_nodes_within_themselves(self):
        for text in ("DEF A Group { children USE A }",
                     "DEF A Transform { children Group { children [ USE A USE A ] } } USE A",
                     "Shape { geometry DEF G IndexedFaceSet { coord USE G coordIndex [ 0 1 2 ] } }",
                     "PROTO P [ ] { DEF A Group { children USE A } } P { } P { }",
                     "PROTO P [ field MFNode k [ ] ] { Group { children IS k } }"
                     " DEF A P { k USE A }"):
            with self.subTest(text):
                self.assert_lost(self.read(SQUARE + text), 1)

    def test_prototypes_within_themselves(self):
        for text in ("PROTO A [ ] { A { } } A { }",
                     "PROTO A [ ] { Group { children [ A { } A { } ] } } A { }",
                     "PROTO A [ ] { PROTO B [ ] { A { } } B { } } A { }",
                     'EXTERNPROTO A [ ] "scene.wrl#A" A { }',
                     'EXTERNPROTO A [ ] "scene.wrl" A { }',
                     'PROTO A [ ] { Inline { url "scene.wrl" } } A { }'):
            with self.subTest(text):
                self.assert_lost(self.read(SQUARE + text), None)

    def test_files_within_themselves(self):
        self.write('Inline { url "b.wrl" } ' + SQUARE, "a.wrl")
        self.write('Inline { url "a.wrl" } ' + SQUARE, "b.wrl")
        (self.folder / "self").symlink_to("scene.wrl")
        (self.folder / "sub").symlink_to(".", target_is_directory=True)
        for url in ("scene.wrl", "./scene.wrl", "self", "sub/sub/scene.wrl"):
            with self.subTest(url):
                self.assert_lost(self.read(SQUARE + f'Inline {{ url "{url}" }}'), 1)
        self.assert_lost(self.read(SQUARE + 'Inline { url "a.wrl" }'), 3)
        self.assert_lost(self.read(SQUARE + 'Inline { url "scene.wrl" }' * 20), 1)

    def test_extern_prototypes_of_each_other(self):
        for one, other in (("a", "b"), ("b", "a")):
            self.write(f'EXTERNPROTO Q [ ] "{other}.wrl#P" PROTO P [ ] {{ Q {{ }} }}', one + ".wrl")
        self.assert_lost(self.read(SQUARE + 'EXTERNPROTO P [ ] "a.wrl#P" P { }'), 1)


class Growth(SceneTest):
    LEVELS, FACTOR = 12, 10

    def test_laughs_by_use(self):
        for leaf, least in ((SQUARE, 50_000), ("Shape { geometry Box { } }", 50_000),
                            ("Group { }", 0), ("Shape { }", 0), ("WorldInfo { }", 0)):
            uses = [f"DEF A{i} Group {{ children [ {f'USE A{i - 1} ' * self.FACTOR}] }}"
                    for i in range(1, self.LEVELS)]
            with self.subTest(leaf):
                scene = self.read(SQUARE + "Switch { choice [ DEF A0 " + leaf + "\n".join(uses)
                                  + f" ] }}\nUSE A{self.LEVELS - 1}",
                                  MaximumNumberOfNodes=1_000_000, **FEW)
                self.assert_lost(scene)
                self.assertGreaterEqual(scene.triangles, least)
                self.assertLessEqual(scene.triangles, FEW["MaximumNumberOfTriangles"])

    def test_laughs_by_prototypes(self):
        for leaf in (SQUARE, "Group { }"):
            bodies = [f"PROTO P{i} [ ] {{ Group {{ children [ "
                      + f"P{i - 1} {{ }} " * self.FACTOR + "] } }" for i in range(1, self.LEVELS)]
            with self.subTest(leaf):
                scene = self.read(f"{SQUARE}PROTO P0 [ ] {{ {leaf} }}\n" + "\n".join(bodies)
                                  + f"\nP{self.LEVELS - 1} {{ }}",
                                  MaximumNumberOfNodes=1_000_000, **FEW)
                self.assert_lost(scene)
                self.assertLessEqual(scene.triangles, FEW["MaximumNumberOfTriangles"])

    def test_laughs_by_fields(self):
        wraps = "PROTO W [ field MFNode k [ ] ] { Group { children [ Group { children IS k } "
        wraps += "Group { children IS k } ] } }\n"
        self.assert_lost(self.read(SQUARE + wraps + "W { k " * 60 + SQUARE + "} " * 60,
                                   MaximumNumberOfNodes=1_000_000, **FEW))

    def test_laughs_by_files(self):
        for i in range(40):
            self.write(SQUARE + f'Inline {{ url "f{i + 1}.wrl" }}\n' * 2, f"f{i}.wrl")
        self.assert_lost(self.read(SQUARE + 'Inline { url "f0.wrl" }', **FEW))

    def test_huge_counts(self):
        huge = 2_000_000_000
        for text in (f"ElevationGrid {{ xDimension {huge} zDimension {huge} height [ 0 0 0 0 ] }}",
                     f"ElevationGrid {{ xDimension {huge} zDimension 2 height [ 0 0 0 0 ] }}",
                     "ElevationGrid { xDimension 65536 zDimension 65536 height [ 0 0 0 0 ] }",
                     "ElevationGrid { xDimension -3 zDimension -3 height [ 0 0 0 0 0 0 0 0 0 ] }"):
            with self.subTest(text):
                scene = self.read(SQUARE + f"Shape {{ geometry {text} }}")
                self.assertGreater(len(scene.messages), 0)
                self.assertEqual(scene.triangles, 2)

    def test_round_shapes_of_any_size(self):
        for size in ("1e9", "1e30", "1e300", "1e308", "1e-30", "1e-300"):
            for text in (f"Sphere {{ radius {size} }}", f"Cylinder {{ radius {size} }}",
                         f"Cone {{ bottomRadius {size} height {size} }}"):
                with self.subTest(text):
                    scene = self.read(SQUARE + f"Shape {{ geometry {text} }}", **FEW)
                    self.assertTrue(np.isfinite(scene.corners).all())
                    self.assertTrue(scene.triangles > 2 or scene.messages)

    # All points are equal, so there is no triangle.
    POINT = (f"Shape {{ geometry Extrusion {{ crossSection [ {'0 0,' * 2000} ]"
             f" spine [ {'0 0 0,' * 2000} ] ")

    def test_meshes_without_triangles_take_no_room(self):
        scene = self.read_within(2, f"{SQUARE} PROTO P [ ] {{ {self.POINT} }} }} }}" + "P { } " * 100)
        self.assertEqual(scene, "2 triangles, 0 messages")

    def test_meshes_without_triangles_that_are_not_shared(self):
        text = f"PROTO P [ field SFBool b TRUE ] {{ {self.POINT} solid IS b }} }} }}"
        scene = self.read(SQUARE + text + "P { } " * 100, **FEW)
        self.assert_lost(scene, 1)
        self.assertIn("MaximumNumberOfTriangles", scene.words())

    def test_faces_without_triangles_that_are_not_shared(self):
        many = 3000
        for text in (f"IndexedFaceSet {{ ccw IS b coord Coordinate {{ point [ 0 0 0 ] }}"
                     f" coordIndex [ {'0 0 0 -1 ' * many} ] }}",
                     f"ElevationGrid {{ ccw IS b xDimension 2 zDimension {many}"
                     f" height [ {'nan 0 ' * many} ] }}"):
            with self.subTest(text[:20]):
                scene = self.read(f"{SQUARE} PROTO P [ field SFBool b TRUE ] {{ Shape {{ geometry"
                                  f" {text} }} }}" + "P { } " * many, **FEW)
                self.assert_lost(scene, 1)
                self.assertIn("MaximumNumberOfTriangles", scene.words())

    def test_long_lists_take_no_more_than_they_need(self):
        face = FACE.format("0 0 0, 1 0 0, 1 1 0", "0 1 2 -1 " * 17_500)
        scene = self.read_within(3, f"Shape {{ geometry {face} }}\n" * 160)
        self.assertEqual(scene, f"{17_500 * 160} triangles, 0 messages")

    def test_long_lists_that_do_not_end(self):
        scene = self.read_within(3, SQUARE + ("Coordinate { point " + "1 " * 70_000) * 160)
        self.assertIn("2 triangles", scene)

    def test_long_lists_of_nodes_that_are_used_often(self):
        many = 200_000
        for holder in ("Switch { whichChoice 0 choice", "LOD { level"):
            with self.subTest(holder):
                scene = self.read_within(
                    3, f"{SQUARE} DEF S {holder} [ {'Group { } ' * many} ] }}"
                    + "USE S " * many)
                self.assertIn("2 triangles", scene)

    def read_within(self, gibibytes, text):
        """Reads a scene in a process with limited memory and 30 seconds. Returns its output."""
        program = textwrap.dedent(f"""
            import resource
            resource.setrlimit(resource.RLIMIT_AS, ({gibibytes} * 1024 ** 3,) * 2)
            resource.setrlimit(resource.RLIMIT_CPU, (30, 30))
            from vrml_reading import Scene
            scene = Scene({str(self.write(text))!r})
            print(scene.triangles, "triangles,", len(scene.messages), "messages")
            """)
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout.strip()

    def test_a_large_extrusion(self):
        ring = ", ".join(f"{math.cos(i / 1e4)} {math.sin(i / 1e4)}" for i in range(62_832))
        spine = ", ".join(f"0 {i} 0" for i in range(60_000))
        large = f"Extrusion {{ crossSection [ {ring} ] spine [ {spine} ] }}"
        self.assert_lost(self.read(f"{SQUARE} Shape {{ geometry {large} }}", **FEW), 1)


if __name__ == "__main__":
    unittest.main()
