#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Testing/Style/check_rooms.py finds each kind of violation of the table of rooms."""

import sys
import tempfile
import unittest
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "Style"))

import check_rooms  # noqa: E402 the folder above

TABLE = """| room | may include | may use | what it holds |
| --- | --- | --- | --- |
| `Filters` | `Filters/*` | VTK | filters |
| `Filters/Shapes` | `Filters/Numbers` | VTK | shapes |
| `Filters/Numbers` | | | numbers |
"""
SOURCES = {
    "Documentation/architecture.md": TABLE,
    "Filters/vtkFilter.cxx": '#include "Shapes/Shape.h"\n#include <vtkPolyData.h>\n',
    "Filters/Shapes/Shape.h": '#include "Numbers/Number.h"\n#include "vtkObject.h"\n',
    "Filters/Numbers/Number.h": "#include <vector>\n",
}


class TestRooms(unittest.TestCase):
    """A small tree that follows its table, and one violation at a time."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name, text in SOURCES.items():
            self.write(name, text)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def expect(self, *beginnings):
        """Expect these violations and no others."""
        found = list(check_rooms.find_violations(self.root))
        self.assertEqual(len(found), len(beginnings), found)
        for violation, beginning in zip(found, beginnings):
            self.assertTrue(violation.startswith(beginning), violation)

    def test_no_violation(self):
        self.expect()

    def test_a_file_in_no_room(self):
        self.write("Filters/Elsewhere/Thing.cxx", "")
        self.expect("Filters/Elsewhere/Thing.cxx: its folder has no row")

    def test_a_test_in_no_room(self):
        self.write("Testing/Cxx/Elsewhere/TestThing.cxx", "")
        self.expect("Testing/Cxx/Elsewhere/TestThing.cxx: its folder has no row")

    def test_a_row_without_a_room(self):
        (self.root / "Filters/vtkFilter.cxx").unlink()
        self.expect("Filters: a row of the table")

    def test_a_forbidden_include(self):
        for include in ('"Shapes/Shape.h"', "<Shapes/Shape.h>"):
            with self.subTest(include):
                self.write("Filters/Numbers/Number.cxx", f"#include {include}\n")
                self.expect("Filters/Numbers/Number.cxx: Filters/Numbers may not include "
                            "Filters/Shapes/Shape.h")

    def test_an_include_that_does_not_name_the_room(self):
        self.write("Filters/vtkFilter.cxx", '#include "Shape.h"\n')
        self.expect('Filters/vtkFilter.cxx: "Shape.h" is at Filters/Shapes/Shape.h')

    def test_a_forbidden_library(self):
        for include in ("<vtkPoints.h>", '"vtkPoints.h"', "<tbb/parallel_for.h>",
                        "<embree3/rtcore.h>", "<omniORB4/CORBA.h>", "<QWidget>", '"pqView.h"'):
            with self.subTest(include):
                self.write("Filters/Numbers/Number.cxx", f"#include {include}\n")
                self.expect("Filters/Numbers/Number.cxx: Filters/Numbers may not use ")

    def test_a_cycle(self):
        self.write("Documentation/architecture.md",
                   TABLE.replace("| `Filters/Numbers` | |", "| `Filters/Numbers` | `Filters` |"))
        self.expect("Filters: its arrows lead back to itself")

    def test_two_headers_of_one_name(self):
        self.write("Filters/Numbers/Shape.h", "")
        found = list(check_rooms.find_violations(self.root))
        self.assertIn("Filters/Numbers/Shape.h: Filters/Shapes/Shape.h has the same name", found)

    def test_exit_code(self):
        for name, code in (("Filters/Numbers/Number.cxx", 0), ("Filters/Thing/Thing.cxx", 1)):
            self.write(name, "")
            with (mock.patch.object(sys, "argv", ["check_rooms.py", str(self.root)]),
                  redirect_stdout(StringIO()) as printed):
                self.assertEqual(check_rooms.main(), code)
            self.assertEqual(name in printed.getvalue(), code == 1)


if __name__ == "__main__":
    unittest.main()
