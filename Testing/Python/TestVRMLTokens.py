#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of extreme words, numbers and bytes. None may crash or hang, a message must report each
loss, and the rest of the scene must be read."""

import gzip
import random
import shutil
import unittest

import numpy as np

from vrml_reading import CASES, FACE, HEADER, SQUARE, Scene, SceneTest


class Tokens(SceneTest):
    MILLION = 1_000_000

    def test_long_numbers(self):
        for number in ("1" * self.MILLION, "-" + "9" * 5000, "0x" + "f" * 5000, "1e" + "9" * 5000,
                       "1e-" + "9" * 5000, "0." + "0" * self.MILLION + "1", "+" * 5000, "." * 5000,
                       "1e" * 5000, "0x" * 5000):
            with self.subTest(number[:8]):
                scene = self.read(SQUARE + f"Transform {{ translation {number} 0 0 children\n"
                                  + SQUARE + "}")
                self.assertTrue(np.isfinite(scene.corners).all())
                self.assertGreaterEqual(scene.triangles, 2)
                self.assertTrue(scene.triangles == 4 or scene.messages)
        index = FACE.format("0 0 0, 1 0 0, 1 1 0", "0 1 " + "0" * self.MILLION + "2 -1")
        self.assertEqual(self.read(f"Shape {{ geometry {index} }}").triangles, 1)

    def test_long_names(self):
        name = "N" * self.MILLION
        scene = self.read(f"DEF {name} {SQUARE} Transform {{ children USE {name} }}")
        self.assertEqual((scene.area(), scene.words()), (2, ""))
        self.assertEqual(scene.names[0], name)
        for text in (f"USE {name}", f"{name} {{ }}", f"Group {{ {name} 1 }}",
                     f'Inline {{ url "{name}" }}',
                     'Inline { url [ ' + '"nothere.wrl" ' * 100_000 + "] }",
                     f'EXTERNPROTO {name} [ ] "{name}#{name}" {name} {{ }}',
                     f"PROTO {name} [ field {name} {name} {name} ] {{ {name} IS {name} }}"):
            with self.subTest(text[:10]):
                scene = self.read(SQUARE + text)
                self.assertEqual(scene.triangles, 2)
                self.assertGreater(len(scene.messages), 0)
                self.assertLess(max(map(len, scene.messages)), 2000)

    def test_messages_are_text(self):
        for name in (b"W\xe4nde", b"\xff\xfe", b"a" + "ä".encode() * 1000, "ä".encode() * 1000,
                     "a漢".encode() * 1000, b"a\0b"):
            for text in (b"USE %s", b"%s { }", b"Group { %s 1 }", b'Inline { url "%s" }',
                         b"PROTO P [ ] { Shape { geometry Box { size IS %s } } } P { }"):
                with self.subTest(text % name[:6]):
                    scene = self.read(SQUARE.encode() + text % name)
                    self.assertGreater(scene.triangles, 0)
                    self.assertGreater(len(scene.messages), 0)
                    self.assertEqual({type(message) for message in scene.messages}, {str})

    def test_long_strings_and_comments(self):
        long = "c" * 10 * self.MILLION
        scene = self.read(f'#{long}\nWorldInfo {{ title "{long}" }} {SQUARE}')
        self.assertEqual((scene.area(), scene.words()), (1, ""))

    def test_many_names(self):
        many = 300_000
        scene = self.read("".join(f"DEF A{i} Group {{ }}\n" for i in range(many)) + SQUARE
                          + "".join(f"USE A{i}\n" for i in range(0, many, 3)))
        self.assertEqual((scene.area(), scene.words()), (1, ""))
        for text in (many * "USE X\n", many * "X { }\n", "Group {" + many * " x 1\n" + "}",
                     "".join(f"PROTO P{i} [ ] {{ }}\n" for i in range(many)) + "P { }",
                     "PROTO P [ " + "".join(f"field SFBool f{i} TRUE\n" for i in range(many))
                     + "] { } P { " + "".join(f"f{i} FALSE\n" for i in range(many)) + "x 1 }"):
            with self.subTest(text[:12]):
                scene = self.read(SQUARE + text)
                self.assertEqual(scene.triangles, 2)
                self.assertGreater(len(scene.messages), 0)

    def test_zero_bytes(self):
        for text in (b"\0" * 1000, b"Shape\0{ geometry Box { } }", b"Shape { geometry Bo\0x { } }",
                     b"Transform { translation 1\0 0 0 }", b'WorldInfo { title "a\0b" }\0',
                     b'Inline { url "a\0b.wrl" }', b"# comment \0\n\0", b"DEF \0 Group { }",
                     b"DEF A\0B Group { } USE A"):
            with self.subTest(text):
                self.assertGreaterEqual(self.read(SQUARE.encode() + text).triangles, 2)
        self.assertGreater(len(self.read(SQUARE.encode() + b"Sh\0ape { }").messages), 0)


class Bytes(SceneTest):
    FILES = ("robot_openhrp.wrl", "silent_every_field.wrl", "externproto_chain.wrl", "gzip_wrl.wrl",
             "enc_string_lines.wrl", "fault_unknown_field_kinds.wrl")
    SPECIAL = b'\0"#{}[]-.09eE \nZ\xff\x80'

    def setUp(self):
        super().setUp()
        shutil.copytree(CASES / "sub", self.folder / "sub")

    def read_bytes(self, data):
        path = self.folder / "scene.wrl"
        path.write_bytes(data)
        return Scene(path)

    def test_cut_at_every_byte(self):
        """A message reports the missing part, unless no node was complete."""
        for name in self.FILES:
            data = (CASES / name).read_bytes()
            whole = self.read_bytes(data)
            for end in range(len(data.rstrip())):
                scene = self.read_bytes(data[:end])
                self.assertTrue(scene.words() or whole.words() or scene.area() < whole.area(),
                                (name, end))

    def test_changed_bytes(self):
        chance = random.Random(1)
        for name in self.FILES:
            data = (CASES / name).read_bytes()
            for _ in range(300):
                changed = bytearray(data)
                for _ in range(chance.randint(1, 4)):
                    changed[chance.randrange(len(data))] = chance.choice(self.SPECIAL)
                self.assertTrue(np.isfinite(self.read_bytes(bytes(changed)).corners).all())

    def test_broken_compression(self):
        packed = gzip.compress(HEADER + SQUARE.encode() * 20, mtime=0)
        for end in range(1, len(packed)):
            self.assertEqual(len(self.read_bytes(packed[:end]).errors), 1, end)
        wrong_sum = self.read_bytes(packed[:-8] + b"12345678")
        self.assertEqual(len(wrong_sum.errors), 1)
        self.assertNotIn("does not begin", wrong_sum.words())
        self.assertGreater(len(self.read_bytes(gzip.compress(packed)).errors), 0)
        self.assertEqual(self.read_bytes(packed + b"\0" * 512).triangles, 40)


if __name__ == "__main__":
    unittest.main()
