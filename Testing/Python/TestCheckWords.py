#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Testing/Style/check_words.py finds each phrase and name that the project avoids, and nothing else.

The examples contain a bar, so that the check accepts this file.
"""

import sys
import tempfile
import unittest
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "Style"))

import check_words  # noqa: E402 the folder above


def found(text):
    """The line numbers of the findings in a text, after removing the bars."""
    return [line for line, _ in check_words.find(text.replace("|", ""))]


class TestWords(unittest.TestCase):
    """The findings in a text."""

    def test_each_phrase(self):
        for phrase in check_words.PHRASES:
            with self.subTest(phrase):
                self.assertEqual(found(f"Fine.\nThen {phrase} it fails.\n"), [2])
                self.assertEqual(found(f"{phrase.capitalize()} it fails.\n"), [1])

    def test_a_phrase_over_two_lines_of_a_comment(self):
        for text in ("// takes s|o\n// many\n", " * takes s|o\n   * many\n", "# s|o\n# many",
                     "s|o\nmany"):
            with self.subTest(text):
                self.assertEqual(found(text), [1])

    def test_a_word_inside_of_a_name(self):
        self.assertEqual(found("bool IsTo|ldApart();"), [1])

    def test_each_prefix(self):
        for prefix in check_words.PREFIXES:
            with self.subTest(prefix):
                self.assertEqual(found(f"constexpr int {prefix}Beams = 1;"), [1])
                self.assertEqual(found(f"_{prefix.upper()}_BEAMS = 1"), [1])

    def test_each_kind_of_comment_that_begins_with_of(self):
        for text in ("/// O|f one client.", "int x; // O|f one", "# O|f one", " * O|f one",
                     '"""O|f one'):
            with self.subTest(text):
                self.assertEqual(found(text), [1])

    def test_similar_words_are_fine(self):
        self.assertEqual(found("The smallest of the most frequent values, held in all cases; at "
                               "least one. Thresholds. // one of them\n"), [])


class TestFiles(unittest.TestCase):
    """The selection of files, and the exit code."""

    def test_texts_and_sources_but_no_data(self):
        for name in ("README.md", "run", ".ci/run", "Filters/CMakeLists.txt", "Filters/a.inl"):
            self.assertTrue(check_words.is_checked(name), name)
        for name in ("LICENSE", "Testing/Data/a.py", "Testing/Style/check_words.py",
                     "Data/room.wrl"):
            self.assertFalse(check_words.is_checked(name), name)

    def test_exit_code_and_place(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "text.md"
            for text, code, output in (("Fine.\n", 0, ""), ("\nSo" " many.\n", 1, f"{path}:2: ")):
                path.write_text(text)
                with redirect_stdout(StringIO()) as printed:
                    self.assertEqual(check_words.main([str(path)]), code)
                self.assertTrue(printed.getvalue().startswith(output))


if __name__ == "__main__":
    unittest.main()
