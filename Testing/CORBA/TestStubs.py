# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The line of Documentation/corba.md that makes the stubs for C++."""

import re
import shlex
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).parents[2]
INTERFACES = ("LMS3D", "LMS3DScanner")


class StubsTest(unittest.TestCase):
    """A folder with nothing but the installed interfaces."""

    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        installed = self.folder / "share/LMS3D/idl"
        installed.mkdir(parents=True)
        for name in INTERFACES:
            (installed / f"{name}.idl").symlink_to(ROOT / f"Plugins/CORBA/IDL/{name}.idl")

    def run_line(self, line):
        """The output of a line of the shell that succeeds without a message."""
        done = subprocess.run(["sh", "-c", line], cwd=self.folder, capture_output=True, text=True,
                              timeout=280, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""), line)
        return done.stdout

    def test_the_stubs_compile(self):
        page = (ROOT / "Documentation/corba.md").read_text(encoding="utf-8")
        (line,) = re.findall(r"^```sh\n(.*omniidl -bcxx.*)\n```$", page, re.MULTILINE)
        self.run_line(line)
        files = {path.name for path in self.folder.iterdir() if path.is_file()}
        self.assertEqual(files, {f"{name}{end}" for name in INTERFACES for end in (".hh", "SK.cc")})
        flags = shlex.join(self.run_line("pkg-config --cflags omniORB4").split())
        self.run_line(f"c++ -fsyntax-only -I. {flags} *SK.cc")


if __name__ == "__main__":
    unittest.main()
