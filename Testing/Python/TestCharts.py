#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The generated pages and the README's table agree with the CSV files in Documentation/charts."""

import shutil
import tempfile
import unittest
from pathlib import Path

from claims.values import ACCURACY, CHARTS, PERFORMANCE, ROOT, README, summaries, tables

PICTURES = tuple(summaries.PAGES)
PAGES = (*PICTURES, "S-speed")


def read(name):
    """Return the text of a file of the repository."""
    return (ROOT / name).read_text(encoding="utf-8")


class PageTest(unittest.TestCase):
    """The generated texts against the tables, and the documents that show them."""

    maxDiff = None

    def test_pages_are_those_of_the_tables(self):
        for name in PAGES:
            self.assertEqual(summaries.make_page(CHARTS, name),
                             read(f"Documentation/charts/{name}.md"), name)

    def test_the_readme_has_the_table_of_scans(self):
        self.assertEqual(summaries.insert_table(read(README), CHARTS), read(README))

    def test_the_readme_shows_all_charts(self):
        for name in PICTURES:
            self.assertIn(f'src="Documentation/charts/{name}.png"', read(README))

    def test_each_chart_is_shown_beside_its_numbers(self):
        for name in PICTURES:
            self.assertIn(f"(charts/{name}.png)", read(ACCURACY))
            self.assertIn(f"(charts/{name}.md)", read(ACCURACY))
            for ending in ("png", "csv"):
                self.assertGreater((CHARTS / f"{name}.{ending}").stat().st_size, 1000)
        self.assertIn("(charts/S-speed.md)", read(PERFORMANCE))

    def test_each_page_names_the_machine_and_its_tables(self):
        for name in PAGES:
            page = read(f"Documentation/charts/{name}.md")
            self.assertIn(read(f"Documentation/charts/{name}.txt").strip(), page)
            for table in CHARTS.glob(f"{name}*.csv"):
                self.assertIn(f"({table.name})", page)

    def test_every_file_belongs_to_a_chart(self):
        for path in CHARTS.iterdir():
            self.assertTrue(path.name.startswith(PAGES), path)
            self.assertIn(path.suffix, (".csv", ".md", ".png", ".txt"))

    def test_every_situation_is_explained(self):
        page = read("Documentation/charts/C-stability.md")
        for row in tables.read(CHARTS / "C-stability.csv"):
            self.assertIn(f"| {row['situation']} |", page.split("## How it was measured")[1])


class RenewalTest(unittest.TestCase):
    """Another number in a table gives another text."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for path in (*CHARTS.glob("*.csv"), *CHARTS.glob("*.txt")):
            shutil.copy(path, self.folder)

    def change(self, name, column, value):
        """Set all cells of a table's column."""
        rows = tables.read(self.folder / f"{name}.csv")
        tables.write(self.folder / f"{name}.csv", [{**row, column: value} for row in rows])

    def test_pages_follow_their_tables(self):
        for name, part, column in (
                ("A-casting", "", "ns/beam"), ("B-mapping", "", "ms"),
                ("B-mapping", "-damage", "triangles"),
                ("D-growth", "", "time exponent"), ("E-sampling", "", "triangles"),
                ("S-speed", "-scenes", "scan ms")):
            self.change(name + part, column, "7654.3")
            self.assertRegex(summaries.make_page(self.folder, name), r"7,?654", name)

    def test_the_speed_page_says_if_the_machine_was_not_quiet(self):
        words = "The machine was not quiet: other processes took up to 42 % of the cores' time."
        for share, is_quiet in (("3", True), ("42", False), ("-", True)):
            self.change("S-speed-methods", "others %", share)
            page = summaries.make_page(self.folder, "S-speed")
            self.assertEqual(words not in page, is_quiet, share)

    def test_the_readme_follows_its_table(self):
        self.change("S-speed-scan", "scan ms", "98.76")
        self.assertIn("| 98.76 |", summaries.insert_table(read(README), self.folder))

    def test_a_readme_without_markers_is_refused(self):
        for text in ("", summaries.BEGIN, summaries.END):
            with self.assertRaisesRegex(ValueError, "table: begin"):
                summaries.insert_table(text, self.folder)


class NumberTest(unittest.TestCase):
    """How numbers are rounded."""

    def test_numbers_have_two_digits_and_whole_integers(self):
        for cell, text in (("20274.4", "20,274"), ("31.4", "31"), ("6.3", "6.3"), ("9.96", "10"),
                           ("0.054", "0.054"), ("1976", "1,976"), ("0", "0"), ("0.3", "0.3"),
                           ("6.9e-13", "< 0.001"), ("-", "-"), ("over 120 s", "over 120 s")):
            self.assertEqual(tables.to_number(cell), text)

    def test_shares_look_like_0_and_1_only_if_they_are(self):
        for share, text in ((0, "0"), (0.0003, "< 0.1"), (0.084, "8.4"), (0.321, "32"),
                            (0.998, "99.8"), (1, "100")):
            self.assertEqual(tables.to_percent(share), text)

    def test_a_row_is_found_once(self):
        rows = [{"a b": "1"}, {"a b": "2"}, {"a b": "2"}]
        self.assertEqual(tables.find(rows, a_b="1"), {"a b": "1"})
        self.assertIsNone(tables.find(rows, a_b="3"))
        with self.assertRaises(ValueError):
            tables.find(rows, a_b="2")


if __name__ == "__main__":
    unittest.main()
