#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Documentation/accuracy.md says what the tables beside its charts say."""

import collections
import csv
import re
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Testing" / "Benchmarks" / "charts"))
import numbers_of_text  # noqa: E402  (of a folder that is no package)

CHARTS = ROOT / "Documentation" / "charts"
TEXT = (ROOT / "Documentation" / "accuracy.md").read_text(encoding="utf-8")
NAMES = ("A-casting", "B-mapping", "C-stability", "D-growth", "E-sampling")


def table(name):
    """The rows of a table beside a chart."""
    with open(CHARTS / f"{name}.csv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class TextTest(unittest.TestCase):
    """The text against the tables."""

    maxDiff = None

    def test_numbers_are_those_of_the_tables(self):
        self.assertEqual(TEXT, numbers_of_text.refresh(TEXT, CHARTS))

    def test_every_percentage_names_its_cell(self):
        bare = re.findall(r"[^\n]*\d %(?!<!--)[^\n]*", TEXT)
        self.assertEqual(bare, [])

    def test_each_chart_is_shown_and_told_of(self):
        told = numbers_of_text.references(TEXT)
        for name in NAMES:
            self.assertIn(f"(charts/{name}.png)", TEXT)
            self.assertGreaterEqual(told.count(name), 5, name)
            for ending in ("png", "svg", "csv"):
                self.assertGreater((CHARTS / f"{name}.{ending}").stat().st_size, 1000)

    def test_every_situation_is_explained(self):
        for name in {row["situation"] for row in table("C-stability")}:
            self.assertIn(f"| {name} |", TEXT)


class TableTest(unittest.TestCase):
    """What the text says of the tables as a whole."""

    def test_exact_fails_nowhere_but_among_denormals_of_double(self):
        rows = [row for row in table("C-stability") if row["method"] == "Exact"]
        failing = {row["parameter"] for row in rows
                   if any(int(row[kind]) for kind in ("missed", "false", "wrong"))}
        self.assertEqual(failing, {"1e-310"})
        self.assertGreater(len(rows), 50)

    def test_exact_errs_nowhere_and_nobody_quicker_than_fast_errs_less(self):
        rows = [row for row in table("A-casting") if row["end"] == "done"]
        fast = {row["scene"]: row for row in rows if row["caster"] == "Fast"}
        self.assertEqual(set(fast), {"room", "teapot", "terrain1e5"})
        for row in rows:
            if row["caster"] == "Exact":
                self.assertEqual(float(row["worst error"]), 0.0, row)
            other = fast[row["scene"]]
            if float(row["ns/beam"]) < float(other["ns/beam"]):
                self.assertGreater(float(row["worst error"]), float(other["worst error"]), row)

    def test_only_a_locator_without_tolerance_fails_in_ordinary_scenes(self):
        failing = {row["caster"] for row in table("A-casting") if row["end"] == "done"
                   and int(row["misses"]) + int(row["false hits"])}
        self.assertEqual(failing, {"vtkStaticCellLocator at 0"})

    def test_all_casters_are_there(self):
        casters = {row["caster"] for row in table("A-casting")}
        self.assertEqual(len(casters), 15)
        self.assertLessEqual({"Open3D", "trimesh", "vtkOBBTree", "Embree rays"}, casters)

    def test_growth_has_all_methods_and_ten_million_triangles(self):
        rows = [row for row in table("D-growth") if row["end"] == "done"]
        self.assertEqual(len({row["contender"] for row in rows if row["work"] == "scan"}), 5)
        for contender in ("Exact", "Fast"):
            self.assertEqual(max(int(row["triangles"]) for row in rows
                                 if row["contender"] == contender), 10_000_000)
        self.assertEqual({row["threads"] for row in rows} & {"1", "2"}, {"1", "2"})

    def test_every_map_was_made_without_and_with_noise(self):
        scans = collections.defaultdict(set)
        for row in table("B-mapping"):
            scans[row["scene"], row["noise mm"]].add(row["map"])
            self.assertGreater(float(row["ms"]), 0, row["map"])
        self.assertEqual(len(scans), 6)
        for maps in scans.values():
            self.assertEqual(maps, scans["room", "0"])
        self.assertGreater(len(maps), 6)

    def test_returns_without_noise_are_within_the_bound(self):
        rows = [row for row in table("B-mapping")
                if row["map"] == "LMS3D map" and row["noise mm"] == "0"]
        for row in rows:
            self.assertLessEqual(float(row["farthest return mm"]), float(row["bound mm"]))
        self.assertEqual(len(rows), 15)

    def test_no_method_crashed(self):
        self.assertEqual({row["end"] for row in table("C-stability")}, {"done"})


class NumbersTest(unittest.TestCase):
    """That a number which is not that of its cell is told."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "T-some.csv").write_text("name,part,whole\na,25,200\nb,1234.5,1e-9\n",
                                                encoding="utf-8")

    def refreshed(self, text):
        """The text with the numbers of the table."""
        return numbers_of_text.refresh(text, self.folder)

    def test_replaces_a_wrong_number(self):
        comment = "<!-- T-some: name=a: part / whole -->"
        self.assertEqual(self.refreshed(f"so 99.9 %{comment} x"), f"so 12.5 %{comment} x")
        for unit in ("mm", "MB"):
            self.assertEqual(self.refreshed(f"so 99 {unit}{comment} x"), f"so 0 {unit}{comment} x")

    def test_keeps_the_kind_of_number(self):
        comment = "<!-- T-some: name=b: {} -->"
        part, whole, both = (comment.format(x) for x in ("part", "whole", "part + whole"))
        self.assertEqual(self.refreshed(f"1{part} 1.5e-3{whole} 0.00{both}"),
                         f"1,234{part} 1.0e-09{whole} 1,234.50{both}")

    def test_refuses_what_names_no_cell(self):
        for words in ("name=c: part", "nam=a: part", "name=a: parts", "name=a: name"):
            with self.assertRaises(numbers_of_text.NumberProblem):
                self.refreshed(f"1<!-- T-some: {words} -->")


if __name__ == "__main__":
    unittest.main()
