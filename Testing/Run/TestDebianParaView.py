#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Tests the copy of ParaView's CMake files that a build on Debian 13 uses.

A folder stands for a system with Debian's package of ParaView. LMS3D_CMAKE is the program cmake.
"""

import os
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

MODULES = Path(__file__).resolve().parents[2] / "CMake"

PROJECT = f"""cmake_minimum_required(VERSION 3.22)
project(Probe LANGUAGES NONE)
list(APPEND CMAKE_MODULE_PATH "{MODULES}")
set(CMAKE_LIBRARY_ARCHITECTURE machine)
include(LMS3DDebianParaView)
lms3d_mend_debian_paraview("${{SYSTEM}}")
find_package(ParaView REQUIRED HINTS "${{SYSTEM}}/usr" NO_DEFAULT_PATH)
message(STATUS "Module: ${{probe_module}}")
"""


class TestDebianParaView(unittest.TestCase):
    """A project that finds ParaView, while the package changes."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve()
        self.system = self.root / "system"
        self.python = self.system / "usr/lib/python3/dist-packages/vtkmodules"
        self.project = self.root / "project"
        self.project.mkdir()
        (self.project / "CMakeLists.txt").write_text(PROJECT)
        self.install("5.13", "vtkCommonCore.cpython-313.so")

    def install(self, version, module):
        """Install a package, with files of its release time and a list of the present time."""
        cmake = self.system / f"usr/lib/machine/cmake/paraview-{version}"
        for folder in (cmake, self.python):
            folder.mkdir(parents=True, exist_ok=True)
        library = self.python / module
        library.touch()
        config = cmake / "paraview-config.cmake"
        config.write_text(f'set(probe_module "{version} {self.python}/vtkCommonCore.so")\n')
        os.utime(config, (0, 0))
        info = self.system / "var/lib/dpkg/info"
        info.mkdir(parents=True, exist_ok=True)
        (info / "paraview-dev.list").write_text(str(config))

    def remove(self):
        """Remove the package."""
        for name in ("paraview-config.cmake", "vtkCommonCore.*.so"):
            for file in self.system.rglob(name):
                file.unlink()

    def cmake(self, *arguments):
        """What cmake prints."""
        outcome = subprocess.run([os.environ["LMS3D_CMAKE"], *arguments], capture_output=True,
                                 text=True, check=False)
        self.assertEqual(outcome.returncode, 0, outcome.stdout + outcome.stderr)
        return outcome.stdout

    def configure(self):
        """Configure with the generator that LMS3D's presets name."""
        return self.cmake("-S", str(self.project), "-B", str(self.root / "build"), "-G", "Ninja",
                          f"-DSYSTEM={self.system}")

    def build(self):
        """Build, which configures again if that is necessary."""
        time.sleep(0.01)
        return self.cmake("--build", str(self.root / "build"))

    def test_modules_get_their_names(self):
        self.assertIn("5.13 " + str(self.python / "vtkCommonCore.cpython-313.so"), self.configure())

    def test_nothing_is_repeated_while_the_package_stays(self):
        self.configure()
        self.assertNotIn("Module:", self.build())

    def test_a_new_version_replaces_the_copy(self):
        self.configure()
        self.remove()
        self.install("5.14", "vtkCommonCore.cpython-314.so")
        self.assertIn("5.14 " + str(self.python / "vtkCommonCore.cpython-314.so"), self.build())

    def test_a_new_revision_in_the_same_folder_replaces_the_copy(self):
        self.configure()
        self.remove()
        self.install("5.13", "vtkCommonCore.cpython-314.so")
        self.assertIn("5.13 " + str(self.python / "vtkCommonCore.cpython-314.so"), self.build())

    def test_a_package_without_the_fault_needs_no_copy(self):
        self.configure()
        self.remove()
        self.install("5.14", "vtkCommonCore.so")
        self.assertIn("5.14 " + str(self.python / "vtkCommonCore.so"), self.build())
        self.assertFalse((self.root / "build/paraview").exists())


if __name__ == "__main__":
    unittest.main()
