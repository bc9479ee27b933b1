#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Short texts that stand for huge scenes, and the memory that vtkVRMLImporterSource may use."""

import re
import subprocess
import sys
import textwrap
import time
import unittest

from vrml_reading import SQUARE, Scene, SceneTest


class Memory(SceneTest):
    @staticmethod
    def laugh(leaf, levels):
        """A text that shows the leaf ten to the power of the levels."""
        many = "".join(f"DEF A{i} Group {{ children [ {f'USE A{i - 1} ' * 10} ] }}"
                       for i in range(1, levels + 1))
        return f"DEF A0 {leaf} Switch {{ choice [ {many} ] }} USE A{levels}"

    def test_laughs_end_soon_within_the_default_limits(self):
        bodies = "".join(f"PROTO P{i} [ ] {{ Group {{ children [ " + f"P{i - 1} {{ }} " * 10
                         + "] } }" for i in range(1, 9))
        ball = "Shape { geometry Sphere { radius 10 } }"
        for text, limit in ((self.laugh(SQUARE, 8), "MaximumNumberOfNodes"),
                            (self.laugh(ball, 8), "MaximumNumberOfTriangles"),
                            (f"{SQUARE} PROTO P0 [ ] {{ {SQUARE} }} {bodies} P8 {{ }}",
                             "MaximumNumberOfNodes")):
            with self.subTest(text[:30]):
                self.assertLess(len(text), 2000)
                start = time.process_time()
                scene = self.read(text)
                self.assertLess(time.process_time() - start, 15)
                self.assert_lost(scene)
                self.assertIn(f"{limit} allows", scene.words())
                self.assertGreater(scene.triangles, 2)

    def test_memory(self):
        text = SQUARE * 1000
        enough = 2_000_000
        self.assertEqual(self.read(text, MaximumMemory=enough).words(), "")
        parsed = self.read(text, MaximumMemory=enough // 10)
        self.assertIn("MaximumMemory", parsed.words())
        self.assertEqual(len(parsed.errors), 1)
        scene = self.read("DEF A " + SQUARE + "USE A " * 2000, MaximumMemory=enough // 4)
        self.assert_lost(scene)
        self.assertIn("MaximumMemory", scene.words())
        self.assertTrue(2 < scene.triangles < 4000)

    def test_a_text_that_exceeds_the_memory(self):
        """No shape is read. The error says what, where, and what to do."""
        path = self.write("# a comment\n" + SQUARE * 1000)
        scene = Scene(path, MaximumMemory=100_000)
        self.assertEqual(scene.triangles, 0)
        self.assertEqual(len(scene.errors), 1)
        words = re.escape(f"{path} has no surface that can be read. {path}:") + (
            r"\d+: no shape is read: the text alone is larger than MaximumMemory allows\. Raise this "
            r"limit if you trust the scene \(on the command line --scene-memory, in MB\)")
        self.assertRegex(scene.errors[0], words)
        line = int(re.search(r":(\d+): no shape", scene.errors[0]).group(1))
        self.assertTrue(10 < line < 1000, line)

    def test_an_inline_whose_text_exceeds_the_memory(self):
        """The shapes before it stay."""
        self.write(SQUARE * 1000, "large.wrl")
        scene = self.read(SQUARE + 'Inline { url "large.wrl" }', MaximumMemory=100_000)
        self.assert_lost(scene, 1)
        self.assertIn("the rest of the scene is not read: it is larger than MaximumMemory allows",
                      scene.words())

    def test_memory_of_meshes(self):
        ring = " ".join(f"{i} {i * i}" for i in range(1000))
        spine = " ".join(f"0 {i} 0" for i in range(1000))
        large = f"Shape {{ geometry Extrusion {{ crossSection [ {ring} ] spine [ {spine} ] }} }}"
        scene = self.read(SQUARE + large, MaximumMemory=10_000_000)
        self.assert_lost(scene, 1)
        self.assertIn("MaximumMemory", scene.words())

    def test_memory_of_values(self):
        for text in ("Coordinate { point [ " + "1 " * 500_000 + "] }",
                     "Coordinate { point [ " + "1 " * 100_000 + ".5 ] }",
                     "Inline { url [ " + '"" ' * 100_000 + "] }",
                     "Switch { choice [ " + "NULL " * 200_000 + "] }",
                     "Unknown { " + " ".join(f"a{i} 1" for i in range(50_000)) + " }",
                     "".join(f"EXTERNPROTO P{i} [ ] [ ]" for i in range(10_000))):
            with self.subTest(text[:30]):
                scene = self.read(SQUARE + text, MaximumMemory=1_000_000)
                self.assertEqual(len(scene.errors), 1)
                self.assertIn("MaximumMemory", scene.words())

    def test_names_and_lists_that_are_used_often(self):
        name = "N" * 100_000
        often = "USE S " * 2000
        empty = "NULL " * 100_000
        instances = "P { } " * 2000
        for text in (f"PROTO P [ ] {{ {SQUARE} }} DEF {name} Group {{ children [ {instances} ] }}",
                     f"{SQUARE} DEF S Group {{ children [ {empty} ] }} {often}"):
            with self.subTest(text[:30]):
                scene = self.read(text, MaximumMemory=50_000_000)
                self.assert_lost(scene)
                self.assertIn("MaximumMemory", scene.words())

    def test_memory_that_runs_out(self):
        path = self.write(self.laugh(SQUARE, 8))
        program = textwrap.dedent(f"""
            import resource
            resource.setrlimit(resource.RLIMIT_AS, (2 * 1024 ** 3,) * 2)
            from vrml_reading import Scene
            much = dict(MaximumNumberOfNodes=10 ** 9, MaximumMemory=10 ** 12)
            print(len(Scene({str(path)!r}, **much).errors))
            """)
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (0, "1\n"), done.stderr)


if __name__ == "__main__":
    unittest.main()
