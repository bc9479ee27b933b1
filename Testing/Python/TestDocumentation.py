#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The examples in Python and for the command line in README.md, the guide and fusion.md run as printed."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
README = ROOT / "README.md"
GUIDE = ROOT / "Documentation" / "guide.md"
FUSION = ROOT / "Documentation" / "fusion.md"

COMMAND = "./run python -m lms3d "
WITHOUT_AN_END = ("view ", "emulate ")  # until a user ends them


def read_blocks(path, language):
    """The code blocks of a language, in their order."""
    return re.findall(rf"^```{language}\n(.*?)^```$", path.read_text(encoding="utf-8"),
                      re.DOTALL | re.MULTILINE)


class TestExamples(unittest.TestCase):
    """Runs the examples in a folder with Data, as in the folder of the sources."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "Data").symlink_to(ROOT / "Data")

    def run_program(self, *arguments):
        """The outcome of a successful run."""
        done = subprocess.run(arguments, cwd=self.folder, capture_output=True, text=True,
                              timeout=280, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def run_python(self, *arguments):
        """The output of a run without any error or warning."""
        done = self.run_program(sys.executable, *arguments)
        self.assertEqual(done.stderr, "")
        return done.stdout

    def test_python_in_the_readme(self):
        blocks = read_blocks(README, "python")
        self.assertEqual(len(blocks), 1)
        self.assertTrue(self.run_python("-c", blocks[0]).startswith("(360, 361) "))

    def test_python_in_the_guide(self):
        """Later examples use the variables of earlier ones."""
        blocks = read_blocks(GUIDE, "python")
        self.assertGreater(len(blocks), 3)
        self.run_python("-c", "\n".join(blocks))
        self.assertTrue((self.folder / "map.vtp").exists())

    def test_python_on_the_page_of_one_map_of_many_scans(self):
        self.assertEqual(self.run_python("-c", "\n".join(read_blocks(FUSION, "python")))[-2:], "2\n")

    def test_commands(self):
        path = next(block for block in read_blocks(GUIDE, "python") if "path.vtp" in block)
        self.run_python("-c", path)
        lines = "".join("".join(read_blocks(page, "sh")) for page in (README, GUIDE, FUSION)).splitlines()
        commands = {line[len(COMMAND):].split("#")[0].strip() for line in lines
                    if line.startswith(COMMAND)
                    and not line[len(COMMAND):].startswith(WITHOUT_AN_END)}
        self.assertGreater(len(commands), 4)
        # A scan first: the comparisons read what it writes.
        for words in sorted(commands, key=lambda command: not command.startswith("scan ")):
            with self.subTest(words):
                if "|" in words:
                    # What the command prints is on the standard error here.
                    self.run_program(
                        "bash", "-o", "pipefail", "-c", f"'{sys.executable}' -m lms3d {words}")
                else:
                    self.run_python("-m", "lms3d", *words.split())


if __name__ == "__main__":
    unittest.main()
