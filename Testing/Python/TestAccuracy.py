#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The texts say what the tables beside the charts of Documentation/accuracy.md say."""

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
TEXTS = {name: (ROOT / name).read_text(encoding="utf-8") for name in numbers_of_text.TEXTS}
TEXT = TEXTS["Documentation/accuracy.md"]
NAMES = ("A-casting", "B-mapping", "C-stability", "D-growth", "E-sampling")
# What the text asks for, and does not find.
PARAMETERS = {"1 mm", "5 mm", "10 mm", "20 mm", "804 triangles", "1,280 triangles",
              "100,000 triangles", "10,000,000 triangles"}


def table(name):
    """The rows of a table beside a chart."""
    with open(CHARTS / f"{name}.csv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


QUADRICS = "grid + vtkQuadricDecimation"
PRO = "grid + vtkDecimatePro"


def mapped(scene, name, noise, bound):
    """The numbers of a map of chart B that is made by LMS3D, or of the grid that LMS3D made."""
    row, = (row for row in table("B-mapping") if row["scene"] == scene
            and row["map"] == f"LMS3D {name}" and row["noise mm"] == noise
            and row["bound mm"] == bound)
    return {key: float(row[key]) for key in ("ms", "triangles", "hit triangles", "both mean mm",
                                             "to scene mean mm", "to map mean mm",
                                             "farthest return mm")}


class TextTest(unittest.TestCase):
    """The texts against the tables."""

    maxDiff = None

    def test_numbers_are_those_of_the_tables(self):
        for name, text in TEXTS.items():
            self.assertEqual((text, []), numbers_of_text.refresh(text, CHARTS), name)
            self.assertGreater(len(numbers_of_text.references(text)), 3, name)

    def test_every_measured_number_names_its_cell(self):
        rest = numbers_of_text.without_references(TEXT)
        bare = set(re.findall(r"\d[\d.,]*\s(?:%|ns|ms|MB|mm|triangles)(?!\w)", rest))
        self.assertEqual({re.sub(r"\s", " ", number) for number in bare} - PARAMETERS, set())

    def test_the_readme_shows_all_charts(self):
        for name in NAMES:
            self.assertIn(f'src="Documentation/charts/{name}.png"', TEXTS["README.md"])

    def test_each_chart_is_shown_and_told_of(self):
        told = numbers_of_text.references(TEXT)
        for name in NAMES:
            self.assertIn(f"(charts/{name}.png)", TEXT)
            self.assertGreaterEqual(told.count(name), 5, name)
            for ending in ("png", "svg", "csv"):
                self.assertGreater((CHARTS / f"{name}.{ending}").stat().st_size, 1000)
            machine = (CHARTS / f"{name}.txt").read_text(encoding="utf-8").strip()
            picture = (CHARTS / f"{name}.svg").read_text(encoding="utf-8")
            for word in machine.split():
                self.assertIn(word, picture, name)

    def test_every_situation_is_explained(self):
        for name in {row["situation"] for row in table("C-stability")}:
            self.assertIn(f"| {name} |", TEXT)


class TableTest(unittest.TestCase):
    """What the text says of the tables as a whole."""

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

    def test_with_noise_the_bound_leaves_out_returns_of_poles(self):
        """The teapot's scan has none."""
        exceeded = {(row["scene"], row["bound mm"]) for row in table("B-mapping")
                    if row["map"] == "LMS3D map" and row["noise mm"] == "5"
                    and float(row["farthest return mm"]) > float(row["bound mm"])}
        self.assertEqual(exceeded, {(scene, bound) for scene in ("room", "terrain1e5")
                                    for bound in ("1", "5", "10")})

    def test_maps_of_the_room_compare_as_told(self):
        grid, bounded = mapped("room", "grid", "0", "0"), mapped("room", "map", "0", "10")
        for other in (grid, mapped("room", QUADRICS, "0", "10"), mapped("room", PRO, "0", "10")):
            self.assertLess(bounded["both mean mm"], other["both mean mm"])
        self.assertLess(grid["ms"], bounded["ms"])
        self.assertLess(100 * bounded["ms"], mapped("room", QUADRICS, "0", "10")["ms"])
        self.assertLess(mapped("room", "map", "5", "20")["both mean mm"],
                        mapped("room", "grid", "5", "0")["both mean mm"])
        for row in table("B-mapping"):
            if row["scene"] == "room":
                self.assertLess(int(row["scene triangles"]), int(row["triangles"]), row)

    def test_what_is_told_against_our_maps_holds(self):
        bounded = mapped("teapot", "map", "0", "10")
        decimated = mapped("teapot", QUADRICS, "0", "10")
        self.assertEqual(bounded["triangles"], decimated["triangles"])
        self.assertLess(decimated["both mean mm"], bounded["both mean mm"])
        self.assertLess(bounded["farthest return mm"], decimated["farthest return mm"])
        self.assertLess(bounded["triangles"], bounded["hit triangles"])
        self.assertLess(mapped("teapot", "grid", "5", "0")["both mean mm"],
                        mapped("teapot", "map", "5", "20")["both mean mm"])
        self.assertGreaterEqual(mapped("room", "map", "5", "5")["triangles"],
                                mapped("room", "grid", "5", "0")["triangles"])
        self.assertLess(mapped("room", "map", "5", "20")["ms"],
                        mapped("room", "map", "5", "10")["ms"])
        bounded = mapped("terrain1e5", "map", "0", "10")
        grid = mapped("terrain1e5", "grid", "0", "0")
        self.assertLess(10 * grid["ms"], bounded["ms"])
        self.assertLess(grid["to scene mean mm"], bounded["to scene mean mm"])
        self.assertLess(bounded["to map mean mm"], grid["to map mean mm"])
        self.assertLess(bounded["hit triangles"], bounded["triangles"])

class NumbersTest(unittest.TestCase):
    """That a number which is not that of its cell is told."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "T-some.csv").write_text("name,part,whole\na,25,200\nb,1234.5,1e-9\n",
                                                encoding="utf-8")

    def refreshed(self, text):
        """The text with the numbers of the table, all of which are there."""
        text, problems = numbers_of_text.refresh(text, self.folder)
        self.assertEqual(problems, [])
        return text

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

    def test_keeps_what_names_no_cell_and_tells_why(self):
        for words in ("T-some: name=c: part", "T-some: nam=a: part", "T-some: name=a: parts",
                      "T-some: name=a: name", "T-none: name=a: part"):
            comment = f"<!-- {words} -->"
            other = "<!-- T-some: name=a: part -->"
            text, problems = numbers_of_text.refresh(f"1{comment} 99{other}", self.folder)
            self.assertEqual(text, f"1{comment} 25{other}")
            self.assertEqual(len(problems), 1)
            self.assertRegex(problems[0], f"{comment}|T-none.csv")


class CasterTest(unittest.TestCase):
    """What the text says of charts A, C and D as a whole."""

    def setUp(self):
        self.casting = [row for row in table("A-casting") if row["end"] == "done"]
        self.growth = [row for row in table("D-growth") if row["end"] == "done"]

    def timed(self, caster):
        """The rows of a caster of chart A, by scene."""
        return {row["scene"]: row for row in self.casting if row["caster"] == caster}

    def test_all_casters_are_there(self):
        casters = {row["caster"] for row in table("A-casting")}
        self.assertEqual(len(casters), 16)
        self.assertLessEqual({"Open3D", "trimesh", "vtkOBBTree", "Embree rays"}, casters)

    def test_exact_errs_nowhere_and_fast_is_quicker(self):
        fast, exact = self.timed("Fast"), self.timed("Exact")
        self.assertEqual(set(fast), {"room", "teapot", "terrain1e5"})
        self.assertEqual(set(exact), set(fast))
        for scene, row in exact.items():
            self.assertEqual(float(row["worst error"]), 0.0, row)
            self.assertLess(float(fast[scene]["ns/beam"]), float(row["ns/beam"]), scene)

    def test_exact_and_fast_are_on_the_frontier(self):
        """Whatever is quicker errs more."""
        for name in ("Exact", "Fast"):
            for scene, ours in self.timed(name).items():
                for row in self.casting:
                    if row["scene"] == scene and float(row["ns/beam"]) < float(ours["ns/beam"]):
                        self.assertGreater(float(row["worst error"]), float(ours["worst error"]),
                                           row)

    def test_what_is_told_against_us_holds(self):
        packets, trimesh = self.timed("Embree robust packets"), self.timed("trimesh")
        for scene in ("room", "terrain1e5"):
            self.assertLess(float(packets[scene]["ns/beam"]),
                            float(self.timed("Exact")[scene]["ns/beam"]), scene)
        self.assertLess(float(trimesh["room"]["worst error"]),
                        float(self.timed("Fast")["room"]["worst error"]))

    def test_only_a_locator_without_tolerance_fails_in_ordinary_scenes(self):
        failing = {row["caster"] for row in self.casting
                   if int(row["misses"]) + int(row["false hits"])}
        self.assertEqual(failing, {"vtkStaticCellLocator at 0"})

    def test_only_one_locator_crashes(self):
        for name, column in (("A-casting", "caster"), ("C-stability", "method")):
            crashing = {row[column] for row in table(name) if row["end"] == "Segmentation fault"}
            self.assertEqual(crashing, {"vtkModifiedBSPTree"}, name)
        others = {row["end"] for row in table("C-stability")
                  if row["method"] != "vtkModifiedBSPTree"}
        self.assertEqual(others, {"done"})

    def test_exact_alone_fails_nowhere_but_where_products_are_too_small(self):
        failing = collections.defaultdict(set)
        for row in table("C-stability"):
            if any(int(row[kind]) for kind in ("missed", "false", "wrong")):
                failing[row["method"]].add((row["situation"], row["parameter"]))
        beyond = {("denormals", "1e-120"), ("denormals", "1e-310")}
        self.assertEqual(failing.pop("Exact"), beyond)
        self.assertEqual(len(failing), len({row["method"] for row in table("C-stability")}) - 1)
        for method, situations in failing.items():
            self.assertGreater(situations - beyond, set(), method)

    def test_growth_has_all_methods_and_ten_million_triangles(self):
        self.assertEqual(len({row["contender"] for row in self.growth
                              if row["work"] == "scan"}), 5)
        for contender in ("Exact", "Fast", "MollerTrumbore"):
            self.assertEqual(max(int(row["triangles"]) for row in self.growth
                                 if row["contender"] == contender and row["work"] == "scan"),
                             10_000_000, contender)
        self.assertEqual({row["threads"] for row in self.growth} & {"1", "2"}, {"1", "2"})

    def test_a_second_thread_helps_the_bounded_map_least(self):
        powers = {(row["work"], row["contender"]): float(row["time exponent"])
                  for row in self.growth if row["against"] == "threads"}
        self.assertGreaterEqual(len(powers), 12)
        bounded = powers["map", "map within 10 mm"]
        self.assertLess(powers["map", "plain grid"], bounded)
        self.assertLess(powers["build", "Exact"], bounded)
        self.assertLess(max(power for (work, _), power in powers.items() if work == "scan"), bounded)

    def test_what_is_told_against_our_maps_growth_holds(self):
        cost = {(row["contender"], row["triangles"]): float(row["ms"]) for row in self.growth
                if row["work"] == "map" and row["against"] == "triangles"}
        bounded = {triangles: ms for (contender, triangles), ms in cost.items()
                   if contender == "map within 10 mm"}
        self.assertEqual(max(bounded, key=bounded.get), "100000")
        for triangles, ms in bounded.items():
            self.assertLess(cost["plain grid", triangles], ms, triangles)
        memory = {(row["work"], row["contender"]): float(row["peak MB"]) for row in self.growth
                  if row["against"] == "beams" and row["beams"] == "9998244"}
        self.assertLess(memory["scan", "Exact"], memory["map", "plain grid"])
        memory = {row["contender"]: float(row["peak MB"]) for row in self.growth
                  if row["work"] == "build" and row["triangles"] == "10000000"}
        self.assertLess(memory["Exact"], memory["Fast"])


if __name__ == "__main__":
    unittest.main()
