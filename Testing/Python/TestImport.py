#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""import lms3d: what to do where it fails, and a second user of a build."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import lms3d

PACKAGE = Path(lms3d.__file__).parent
SOURCES = Path(__file__).resolve().parents[2]
BUILD = next((folder for folder in PACKAGE.parents if (folder / "CMakeCache.txt").exists()), None)

# A user who owns nothing.
AS_SECOND_USER = ("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups")

SCAN = """
import lms3d
scan = lms3d.scan(([[1, -9, -9], [1, 9, -9], [1, 0, 9]], [[0, 1, 2]]), (0, 0, 0))
print(lms3d.__file__, scan.ranges[0, 180])
"""


def start(*command, **environment):
    """A finished process, outside of all folders with sources; None removes a variable."""
    variables = {**os.environ, "PYTHONDONTWRITEBYTECODE": None, **environment}
    return subprocess.run(
        [*map(str, command)], capture_output=True, text=True, cwd="/", timeout=300, check=False,
        env={name: str(value) for name, value in variables.items() if value is not None})


class TestFailures(unittest.TestCase):
    """Each error says what to do."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def error_of_import(self, *paths):
        """The last line of the error, with the package searched in folders."""
        done = start(sys.executable, "-c", "import lms3d", PYTHONDONTWRITEBYTECODE=1,
                     PYTHONPATH=":".join(map(str, paths)))
        self.assertEqual(done.returncode, 1, done.stderr)
        line = done.stderr.splitlines()[-1]
        self.assertRegex(line, "^ImportError: ")
        self.assertIn("PYTHONPATH", line)
        return line

    def replace_vtk(self, *lines):
        """A folder with another package vtkmodules."""
        modules = self.folder / "vtkmodules"
        modules.mkdir()
        (modules / "__init__.py").touch()
        (modules / "vtkCommonCore.py").write_text("\n".join(lines))
        return self.folder

    def test_the_folder_of_the_sources(self):
        line = self.error_of_import(SOURCES / "Plugins" / "Python")
        self.assertIn(f"start Python by '{SOURCES}/run python'", line)
        self.assertIn("without its compiled modules", line)
        self.assertIn("Debian package", line)

    def test_a_built_package_beside_the_sources_is_named(self):
        sources = self.folder / "Plugins" / "Python" / "lms3d"
        built = self.folder / "build" / "lib" / "python3" / "dist-packages"
        shutil.copytree(SOURCES / "Plugins" / "Python" / "lms3d", sources)
        (built / "lms3d").mkdir(parents=True)
        shutil.copy(SOURCES / "run", self.folder)
        line = self.error_of_import(sources.parent)
        self.assertNotIn(str(built), line)
        self.assertIn(f"start Python by '{self.folder}/run python', or set", line)
        (built / "lms3d" / "_version.py").touch()
        self.assertIn(f"set PYTHONPATH to {built}", self.error_of_import(sources.parent))

    def test_a_build_that_was_interrupted(self):
        shutil.copytree(PACKAGE, self.folder / "lms3d", ignore=shutil.ignore_patterns("*.so"))
        line = self.error_of_import(self.folder)
        self.assertIn("No module named 'lms3d.vtkLMS3D", line)
        self.assertNotIn("run python", line)  # this folder has no such script
        self.assertIn(f"PYTHONPATH={self.folder}", line)

    def test_python_without_vtk(self):
        folder = self.replace_vtk("raise ModuleNotFoundError('No module named vtkCommonCore')")
        line = self.error_of_import(folder, PACKAGE.parent)
        self.assertIn("No module named vtkCommonCore. It was built for /", line)
        self.assertIn(f"PYTHONPATH={PACKAGE.parent}", line)

    def test_python_with_another_vtk(self):
        folder = self.replace_vtk("class vtkVersion:", "    GetVTKVersion = lambda: '8.7.6'")
        line = self.error_of_import(folder, PACKAGE.parent)
        self.assertIn(f"VTK 8.7.6 in {folder}/vtkmodules is another version", line)
        self.assertRegex(line, r"built for /\S+ with VTK \d+\.\d+\.\d+:")

    def test_the_built_package_is_found(self):
        done = start(sys.executable, "-c", SCAN)
        self.assertEqual(done.stdout, f"{PACKAGE}/__init__.py 1.0\n", done.stderr)


def may_read():
    """Whether this test can act as another user who may read the build."""
    return os.geteuid() == 0 and shutil.which("setpriv") is not None and BUILD is not None and \
        start(*AS_SECOND_USER, "test", "-r", PACKAGE / "__init__.py").returncode == 0


@unittest.skipUnless(may_read(), "needs root, setpriv, and a build that all users may read")
class TestSecondUser(unittest.TestCase):
    """Another user than the one who built."""

    def call(self, *command, **environment):
        """The output of a command of the second user, which writes nothing."""
        before = self.list_files()
        done = start(*AS_SECOND_USER, *command, HOME="/nonexistent", **environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        self.assertEqual(self.list_files(), before)
        return done.stdout

    @staticmethod
    def list_files():
        """Names and times of the files that a start could write. Other tests change the folders."""
        files = [*PACKAGE.rglob("*"), *BUILD.glob("*"), *SOURCES.glob("*")]
        return {path: path.stat().st_mtime_ns for path in files if path.is_file()}

    def test_the_package(self):
        self.assertEqual(self.call(sys.executable, "-c", SCAN), f"{PACKAGE}/__init__.py 1.0\n")

    def test_run_python(self):
        if BUILD.parent == SOURCES:
            preset = "default"
        elif BUILD.parent == SOURCES / "build":
            preset = BUILD.name
        else:
            self.skipTest("the build is not in the folder of a preset")
        words = self.call(SOURCES / "run", "python", "-c", SCAN, PYTHONPATH=None,
                          LMS3D_PRESET=preset, LMS3D_NO_INSTALL=1)
        self.assertEqual(words, f"{PACKAGE}/__init__.py 1.0\n")

    def test_what_is_not_built_cannot_be_used(self):
        done = start(*AS_SECOND_USER, SOURCES / "run", "build", LMS3D_PRESET="vtk",
                     LMS3D_NO_INSTALL=1)
        self.assertEqual(done.returncode, 13)
        self.assertIn("cannot write to", done.stderr)


if __name__ == "__main__":
    unittest.main()
