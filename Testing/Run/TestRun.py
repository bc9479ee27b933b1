#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Tests what ./run wants to install, with a copy of it on a system without packages, how it starts
ParaView, and whether a second user can start it in a build that another user has made.

LMS3D_RUN is the script. Programs in a folder of the test replace dpkg-query, which then lists no
package, and apt-get, sudo and cmake, which record that they were called.
"""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

FORBIDDEN = 10
FAILED_BUILD = 13


def is_supported():
    """Whether ./run installs packages on this system."""
    release = Path("/etc/os-release")
    lines = release.read_text().splitlines() if release.exists() else []
    return "ID=debian" in lines and {'VERSION_ID="12"', 'VERSION_ID="13"'} & set(lines)


@unittest.skipUnless(is_supported(), "./run installs packages on Debian 12 and 13 only")
class TestRun(unittest.TestCase):
    """./run with LMS3D_NO_INSTALL on a machine without packages."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.calls = self.root / "calls"
        shutil.copy(os.environ["LMS3D_RUN"], self.root / "run")
        self.programs = self.root / "programs"
        self.programs.mkdir()
        self.stand_in("dpkg-query", "exit 1")
        for name in ("apt-get", "sudo", "cmake"):
            self.stand_in(name, f'echo {name} >>"{self.calls}"')

    def stand_in(self, name, script):
        """Put a program first in PATH."""
        program = self.programs / name
        program.write_text(f"#!/bin/sh\n{script}\n")
        program.chmod(0o755)

    def call(self, *command, **environment):
        """The outcome of ./run."""
        path = f"{self.programs}:{os.environ['PATH']}"
        names = ("LMS3D_PRESET", "LMS3D_PACKAGES", "LMS3D_NO_INSTALL")
        others = {name: value for name, value in os.environ.items() if name not in names}
        return subprocess.run([self.root / "run", *command], capture_output=True, text=True, check=False,
                              env={**others, "PATH": path, **environment})

    def missing(self, *command):
        """The packages that ./run names and does not install."""
        outcome = self.call(*command, LMS3D_NO_INSTALL="1")
        self.assertEqual(outcome.returncode, FORBIDDEN, outcome.stderr)
        self.assertIn("LMS3D_NO_INSTALL is set and packages are missing", outcome.stderr)
        self.assertFalse(self.calls.exists(), "the system was touched")
        return set(outcome.stderr.split("--no-install-recommends")[1].split())

    def test_nothing_is_installed(self):
        self.assertIn("g++", self.missing("build"))

    def test_demo_needs_few_packages(self):
        packages = self.missing("demo")
        self.assertLessEqual({"cmake", "libembree-dev", "paraview-dev", "xvfb"}, packages)
        for word in ("qt", "omni", "gtest", "mpi", "java", "jdk", "maven"):
            self.assertFalse([package for package in packages if word in package], word)

    def test_each_part_adds_its_packages(self):
        demo = self.missing("demo")
        self.assertEqual(self.missing("server") - demo,
                         {"libcli11-dev", "libomniorb4-dev", "omniidl"})
        self.assertEqual(self.missing("bench") - demo, {"libgtest-dev"})
        self.assertIn("libopenmpi-dev", self.missing("test") - demo)
        interop = self.missing("interop") - self.missing("test")
        self.assertLessEqual({"maven", "python3-venv"}, interop)
        self.assertEqual(self.missing("python"), demo)
        self.assertEqual(self.missing("python", "-m", "pip", "list") - demo, {"python3-venv"})

    def test_parts_of_the_build_folder_stay(self):
        build = self.root / "build"
        build.mkdir()
        (build / "CMakeCache.txt").write_text("LMS3D_BUILD_CORBA:BOOL=ON\nBUILD_TESTING:BOOL=OFF\n")
        (build / ".made-for").write_text(self.stamp())
        self.assertIn("omniidl", self.missing("demo"))
        self.assertNotIn("libgtest-dev", self.missing("demo"))

    def test_parts_of_a_failed_configuration_are_forgotten(self):
        build = self.root / "build"
        cache = build / "CMakeCache.txt"
        self.stand_in("dpkg-query", 'for last; do echo; echo "$last installed"; done')
        self.stand_in("cmake", f"echo LMS3D_BUILD_CORBA:BOOL=ON >{cache}; exit 1")
        self.stand_in("apt-get", "exit 0")
        self.stand_in("sudo", '"$@"')
        outcome = self.call("server")
        self.assertEqual(outcome.returncode, FAILED_BUILD, outcome.stderr)
        self.assertFalse(cache.exists())

    def stamp(self):
        """The text that ./run writes into a build folder: its own folder and the system."""
        command = ["sh", "-c", '. /etc/os-release && echo "$ID $VERSION_ID"']
        system = subprocess.run(command, capture_output=True, text=True, check=True)
        return f"{self.root.resolve()} {system.stdout}"

    def test_further_packages_are_named(self):
        outcome = self.call("demo", LMS3D_NO_INSTALL="1", LMS3D_PACKAGES="libcoin-dev")
        self.assertIn("libcoin-dev", outcome.stderr)

    def start_paraview(self, *arguments):
        """The settings folder and the arguments that ./run gives to ParaView, in a finished build."""
        plugins = self.root / "build/lib/paraview-5.11/plugins"
        for name in ("LMS3D", "LMS3DRemote"):
            (plugins / name).mkdir(parents=True, exist_ok=True)
            (plugins / name / f"{name}.so").touch()
        (self.root / "build/lib/python3/dist-packages/lms3d").mkdir(parents=True, exist_ok=True)
        self.stand_in("dpkg-query", 'for last; do echo; echo "$last installed"; done')
        said = self.root / "said"
        self.stand_in("paraview", f'printf "%s\\n" "$XDG_CONFIG_HOME" "$@" >{said}')
        outcome = self.call("paraview", *arguments, DISPLAY=":0", HOME=str(self.root / "home"),
                            XDG_CONFIG_HOME="")
        self.assertEqual(outcome.returncode, 0, outcome.stderr)
        settings, *given = said.read_text().splitlines()
        return Path(settings), given

    def test_paraview_gets_the_users_arguments_first(self):
        plugins = self.root.resolve() / "build/lib/paraview-5.11/plugins"
        self.assertEqual(self.start_paraview("my room.wrl", "--stereo")[1], [
            "my room.wrl", "--stereo",
            f"--plugin-search-paths={plugins}/LMS3D", "--plugins=LMS3D",
            f"--plugin-search-paths={plugins}/LMS3DRemote", "--plugins=LMS3DRemote"])

    def test_paraview_has_settings_of_its_own(self):
        configuration = self.root / "home/.config"
        plain = configuration / "ParaView/ParaView5.11.0.ini"
        plain.parent.mkdir(parents=True)
        plain.write_text("as the user likes it")
        (configuration / "theme").write_text("dark")
        own = configuration / "LMS3D"
        self.assertEqual(self.start_paraview("room.wrl")[0], own)
        copy = own / "ParaView" / plain.name
        self.assertEqual(copy.read_text(), "as the user likes it")
        self.assertEqual((own / "theme").resolve(), (configuration / "theme").resolve())
        self.assertFalse((own / "LMS3D").exists())

        copy.write_text("changed in the window")
        self.assertEqual(self.start_paraview("room.wrl")[0], own)
        self.assertEqual(copy.read_text(), "changed in the window")
        self.assertEqual(plain.read_text(), "as the user likes it")

    def test_paraview_starts_in_a_new_home(self):
        self.assertEqual(self.start_paraview("room.wrl")[0], self.root / "home/.config/LMS3D")

    def test_unknown_commands_are_refused(self):
        self.assertEqual(self.call("frobnicate").returncode, 2)

    def built(self):
        """A build with the Python package, which the user of second_call() may only read."""
        build = self.root / "build"
        package = build / "lib" / "python3" / "dist-packages" / "lms3d"
        package.mkdir(parents=True)
        (package / "__init__.py").write_text("print('the package')\n")
        (build / "build.ninja").touch()
        (build / "CMakeCache.txt").write_text("LMS3D_BUILD_CORBA:BOOL=OFF\n")
        (build / ".made-for").write_text(self.stamp())
        self.root.chmod(0o755)
        build.chmod(0o555)
        self.addCleanup(build.chmod, 0o755)
        return build

    def second_call(self, *command):
        """The outcome of ./run for a user who may write nothing, not even if this test runs as root."""
        user = ("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups") if os.geteuid() == 0 else ()
        return subprocess.run(
            [*user, self.root / "run", *command], capture_output=True, text=True, check=False,
            env={"PATH": f"{self.programs}:{os.environ['PATH']}", "HOME": "/nonexistent"})

    def test_a_second_user_uses_the_build(self):
        self.built()
        before = sorted(self.root.rglob("*"))
        outcome = self.second_call("python", "-c", "import lms3d")
        self.assertEqual((outcome.returncode, outcome.stdout, outcome.stderr), (0, "the package\n", ""))
        self.assertEqual(sorted(self.root.rglob("*")), before)

    def test_packages_of_pip_stay_in_the_build(self):
        """Debian's Python is used until pip is called, then an environment with Debian's packages."""
        build = self.built()
        build.chmod(0o755)
        (build / "python" / "bin").mkdir(parents=True)
        shutil.copy("/bin/echo", build / "python" / "bin" / "python")
        self.assertEqual(self.second_call("python", "-c", "import lms3d").stdout, "the package\n")
        shutil.copy("/bin/echo", build / "python" / "bin" / "pip")
        self.assertEqual(self.second_call("python", "-m", "lms3d").stdout, "-m lms3d\n")

    def test_a_second_user_cannot_build(self):
        build = self.built()
        for command in ("server", "build"):
            outcome = self.second_call(command)
            self.assertEqual(outcome.returncode, FAILED_BUILD, outcome.stderr)
            self.assertIn("cannot write to", outcome.stderr)
        build.chmod(0o755)
        (build / ".made-for").write_text("/elsewhere debian 12\n")
        build.chmod(0o555)
        self.assertEqual(self.second_call("python").returncode, FAILED_BUILD)


if __name__ == "__main__":
    unittest.main()
