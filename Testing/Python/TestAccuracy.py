#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the documents say of speed and accuracy holds for the tables of Documentation/charts."""

import collections
import re
import unittest

from claims import CLAIMS, ROOT, TABLES
from claims.values import ACCURACY, GUIDE, PERFORMANCE, PRO, QUADRICS, README

TEXTS = {name: " ".join((ROOT / name).read_text(encoding="utf-8").split())
         for name in (ACCURACY, GUIDE, PERFORMANCE, README)}
# What the texts choose rather than measure.
PARAMETERS = {"5 %", "1 mm", "5 mm", "10 mm", "20 mm", "804 triangles", "988 triangles",
              "1,000,000 triangles", "10,000,000 triangles", "100,000 triangles",
              "200,000 triangles", "261,120 triangles", "5,000 triangles"}


class TextTest(unittest.TestCase):
    """The texts against the tables."""

    def test_claims_hold(self):
        for claim in CLAIMS:
            with self.subTest(claim.phrase):
                self.assertIn(claim.phrase, TEXTS[claim.document])
                self.assertGreaterEqual(claim.value, claim.least)
                self.assertLessEqual(claim.value, claim.most)
        self.assertGreater(len(CLAIMS), 150)

    def test_every_measured_number_is_a_claim(self):
        for name in (ACCURACY, PERFORMANCE):
            rest = TEXTS[name]
            for claim in CLAIMS:
                rest = rest.replace(claim.phrase, "")
            bare = set(re.findall(r"\d[\d.,]*\s(?:%|ns|ms|s|GB|MB|mm|bytes|times|triangles)(?!\w)",
                                  rest))
            self.assertEqual(bare - PARAMETERS, set(), name)


MAP, GRID = "LMS3D map", "LMS3D grid"


def mapped(scene, name, noise, bound):
    """Return the numbers of a map of chart B."""
    row, = (row for row in TABLES["B-mapping"]
            if (row["scene"], row["map"], row["noise mm"], row["bound mm"])
            == (scene, name, noise, bound))
    return {key: float(row[key]) for key in ("ms", "triangles", "hit triangles", "both mean mm",
                                             "to scene mean mm", "to map mean mm",
                                             "farthest return mm")}


class MapTest(unittest.TestCase):
    """What the texts say of chart B as a whole."""

    def test_every_map_was_made_without_and_with_noise(self):
        scans = collections.defaultdict(set)
        for row in TABLES["B-mapping"]:
            scans[row["scene"], row["noise mm"]].add(row["map"])
            self.assertGreater(float(row["ms"]), 0, row["map"])
        self.assertEqual(len(scans), 6)
        for maps in scans.values():
            self.assertEqual(maps, scans["room", "0"])
        self.assertGreater(len(maps), 6)

    def test_all_returns_are_within_the_bound(self):
        rows = [row for row in TABLES["B-mapping"] if row["map"] == MAP]
        for row in rows:
            self.assertLessEqual(float(row["farthest return mm"]), float(row["bound mm"]))
        self.assertEqual(len(rows), 30)

    def test_maps_of_the_room_compare_as_described(self):
        grid, bounded = mapped("room", GRID, "0", "0"), mapped("room", MAP, "0", "10")
        for other in (grid, mapped("room", QUADRICS, "0", "10"), mapped("room", PRO, "0", "10")):
            self.assertLess(bounded["both mean mm"], other["both mean mm"])
        self.assertLess(grid["ms"], bounded["ms"])
        self.assertLess(100 * bounded["ms"], mapped("room", QUADRICS, "0", "10")["ms"])
        self.assertLess(mapped("room", MAP, "5", "20")["both mean mm"],
                        mapped("room", GRID, "5", "0")["both mean mm"])
        for row in TABLES["B-mapping"]:
            if row["scene"] == "room":
                self.assertLess(int(row["scene triangles"]), int(row["triangles"]), row)

    def test_what_speaks_against_our_maps_holds(self):
        bounded = mapped("teapot", MAP, "0", "10")
        decimated = mapped("teapot", QUADRICS, "0", "10")
        # An edge that collapses takes up to two triangles away.
        self.assertIn(bounded["triangles"] - decimated["triangles"], (0, 1))
        self.assertLess(decimated["both mean mm"], bounded["both mean mm"])
        self.assertLess(bounded["farthest return mm"], decimated["farthest return mm"])
        self.assertLess(bounded["triangles"], bounded["hit triangles"])
        self.assertLess(mapped("teapot", GRID, "5", "0")["both mean mm"],
                        mapped("teapot", MAP, "5", "20")["both mean mm"])
        self.assertGreaterEqual(mapped("room", MAP, "5", "5")["triangles"],
                                mapped("room", GRID, "5", "0")["triangles"])
        self.assertLess(mapped("room", MAP, "5", "20")["ms"],
                        mapped("room", MAP, "5", "10")["ms"])
        bounded = mapped("terrain1e5", MAP, "0", "10")
        grid = mapped("terrain1e5", GRID, "0", "0")
        self.assertLess(10 * grid["ms"], bounded["ms"])
        self.assertLess(grid["to scene mean mm"], bounded["to scene mean mm"])
        self.assertLess(bounded["to map mean mm"], grid["to map mean mm"])
        self.assertLess(bounded["hit triangles"], bounded["triangles"])


class CasterTest(unittest.TestCase):
    """What the texts say of charts A, C and D as a whole."""

    def setUp(self):
        self.casting = [row for row in TABLES["A-casting"] if row["end"] == "done"]
        self.growth = [row for row in TABLES["D-growth"] if row["end"] == "done"]

    def timed(self, caster):
        """The rows of a caster of chart A, by scene."""
        return {row["scene"]: row for row in self.casting if row["caster"] == caster}

    def test_all_casters_are_there(self):
        self.assertEqual({row["caster"] for row in TABLES["A-casting"]}, {
            "Exact", "Fast", "AngleSum", "MollerTrumbore", "StaticCellLocator",
            "Embree rays", "Embree robust rays", "Embree robust packets",
            "vtkStaticCellLocator", "vtkStaticCellLocator at 0", "vtkCellLocator",
            "vtkCellTreeLocator", "vtkModifiedBSPTree", "vtkOBBTree", "Open3D", "embreex", "trimesh"})

    def test_exact_errs_nowhere_and_is_quicker_than_fast(self):
        fast, exact = self.timed("Fast"), self.timed("Exact")
        self.assertEqual(set(fast), {"room", "teapot", "terrain1e5"})
        self.assertEqual(set(exact), set(fast))
        for scene, row in exact.items():
            self.assertEqual(float(row["worst error"]), 0.0, row)
            self.assertLess(float(row["ns/beam"]), float(fast[scene]["ns/beam"]), row)

    def test_every_other_caster_that_is_quicker_errs_more(self):
        for name in ("Exact", "Fast"):
            for scene, ours in self.timed(name).items():
                for row in self.casting:
                    if (row["caster"] not in ("Exact", "Fast") and row["scene"] == scene
                            and float(row["ns/beam"]) < float(ours["ns/beam"])):
                        self.assertGreater(float(row["worst error"]), float(ours["worst error"]),
                                           row)

    def test_what_speaks_against_our_casters_holds(self):
        packets, trimesh = self.timed("Embree robust packets"), self.timed("trimesh")
        self.assertLess(float(packets["terrain1e5"]["ns/beam"]),
                        float(self.timed("Exact")["terrain1e5"]["ns/beam"]))
        self.assertLess(float(trimesh["room"]["worst error"]),
                        float(self.timed("Fast")["room"]["worst error"]))

    def test_only_a_locator_without_tolerance_fails_in_ordinary_scenes(self):
        failing = {row["caster"] for row in self.casting
                   if int(row["misses"]) + int(row["false hits"])}
        self.assertEqual(failing, {"vtkStaticCellLocator at 0"})

    def test_only_one_locator_crashes(self):
        for name, column in (("A-casting", "caster"), ("C-stability", "method")):
            crashing = {row[column] for row in TABLES[name] if row["end"] == "Segmentation fault"}
            self.assertEqual(crashing, {"vtkModifiedBSPTree"}, name)
        others = {row["end"] for row in TABLES["C-stability"]
                  if row["method"] != "vtkModifiedBSPTree"}
        self.assertEqual(others, {"done"})

    def test_exact_alone_fails_nowhere_but_where_products_are_too_small(self):
        failing = collections.defaultdict(set)
        for row in TABLES["C-stability"]:
            if any(int(row[kind]) for kind in ("missed", "false", "wrong")):
                failing[row["method"]].add((row["situation"], row["parameter"]))
        beyond = {("denormals", "1e-120"), ("denormals", "1e-310")}
        self.assertEqual(failing.pop("Exact"), beyond)
        self.assertEqual(len(failing), len({row["method"] for row in TABLES["C-stability"]}) - 1)
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
        self.assertLess(max(power for (work, _), power in powers.items() if work == "scan"),
                        bounded)

    def test_what_speaks_against_the_growth_of_our_maps_holds(self):
        cost = {(row["contender"], row["triangles"]): float(row["ms"]) for row in self.growth
                if row["work"] == "map" and row["against"] == "triangles"}
        bounded = {triangles: ms for (contender, triangles), ms in cost.items()
                   if contender == "map within 10 mm"}
        self.assertEqual(max(bounded, key=bounded.get), "10000000")
        for triangles, ms in bounded.items():
            self.assertLess(cost["plain grid", triangles], ms, triangles)
        memory = {(row["work"], row["contender"]): float(row["peak MB"]) for row in self.growth
                  if row["against"] == "beams" and row["beams"] == "9998244"}
        self.assertLess(memory["scan", "Exact"], memory["map", "plain grid"])
        memory = {row["contender"]: float(row["peak MB"]) for row in self.growth
                  if row["work"] == "build" and row["triangles"] == "10000000"}
        self.assertLess(memory["Exact"], memory["Fast"])


class ScanTest(unittest.TestCase):
    """What the texts say of tables S as a whole."""

    def test_no_beam_is_wrong_and_exact_does_not_err(self):
        for part, scenes in (("scenes", 9), ("scan", 4), ("methods", 2)):
            rows = [row for row in TABLES[f"S-speed-{part}"] if row["method"] != "raw packets"]
            self.assertEqual(len({row["scene"] for row in rows}), scenes, part)
            for row in rows:
                self.assertEqual((row["misses"], row["false hits"]), ("0", "0"), row)
                if row["method"] == "Exact":
                    self.assertEqual(row["worst error"], "0.0e+00", row)

    def test_raw_packets_are_the_unit(self):
        for part in ("scenes", "scan", "methods"):
            for row in TABLES[f"S-speed-{part}"]:
                if row["method"] == "raw packets":
                    self.assertEqual(row["x raw"], "1.00", row)


if __name__ == "__main__":
    unittest.main()
