# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the scenes in Data: the files equal the output of their generators and are well formed."""

import numpy as np

from scene_pieces import DATA, generated, read


class SceneTests:
    """Tests of every scene; the subclasses name the file and its generator."""

    @classmethod
    def setUpClass(cls):
        cls.pieces = read(DATA / cls.scene)

    def test_file_is_what_its_generator_writes(self):
        self.assertEqual(generated(self.script), (DATA / self.scene).read_bytes())

    def test_header(self):
        text = (DATA / self.scene).read_text(encoding="utf-8")
        self.assertTrue(text.startswith("#VRML V2.0 utf8\n"))
        for words in ("Units: metres", "Z is up", f"Made by: python3 Data/{self.script}"):
            self.assertIn(words, text)

    def test_indices_and_colours_are_in_range(self):
        for name, mesh in self.pieces.items():
            with self.subTest(name):
                self.assertEqual(mesh.rest.strip(), "")
                used = {i for face in mesh.faces for i in face}
                self.assertEqual(used, set(range(len(mesh.points))))
                self.assertTrue(all(0 <= value <= 1 for value in mesh.colour))

    def test_points_are_shared(self):
        for name, mesh in self.pieces.items():
            with self.subTest(name):
                self.assertTrue(all(count == 1 for count in mesh.directed_edges().values()))

    def test_no_triangle_is_degenerate(self):
        for name, mesh in self.pieces.items():
            with self.subTest(name):
                self.assertGreater(mesh.areas().min(), self.smallest_area)


class ClosedSceneTests(SceneTests):
    """Tests of every scene that is a space with furniture; the subclasses also name the piece `shell`."""

    def triangle_count(self):
        return sum(len(mesh.triangles) for mesh in self.pieces.values())

    def test_every_piece_is_closed(self):
        for name, mesh in self.pieces.items():
            with self.subTest(name):
                edges = mesh.directed_edges()
                self.assertTrue(mesh.solid)
                self.assertTrue(all(edges[b, a] == 1 for a, b in edges))

    def test_furniture_faces_outwards_and_the_room_inwards(self):
        for name, mesh in self.pieces.items():
            with self.subTest(name):
                inwards = {volume < 0 for volume in mesh.volumes()}
                self.assertEqual(inwards, {name == self.shell})

    def test_quads_are_flat_and_convex(self):
        for name, mesh in self.pieces.items():
            for face in mesh.faces:
                with self.subTest(name, face=face):
                    self.assertIn(len(face), (3, 4))
                    self.check_flat_and_convex(mesh.points[face])

    def check_flat_and_convex(self, corners):
        sides = np.roll(corners, -1, axis=0) - corners
        turns = np.cross(sides, np.roll(sides, -1, axis=0))
        self.assertTrue(np.all(turns @ turns[0] > 0))
        self.assertLess(np.abs((corners - corners[0]) @ turns[0]).max(), 1e-12)
