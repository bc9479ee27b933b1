# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Other libraries for Python: installs them into build/peers and runs them in own processes."""

import contextlib
import os
import signal
import subprocess
import venv

import numpy
from places import ENVIRONMENT, HERE

# open3d-cpu is open3d without CUDA: it is smaller, but does not exist for every platform. Both
# need libusb.
PACKAGES = (("numpy==2.4.6",), ("open3d-cpu==0.20.0", "open3d==0.20.0"),
            ("libusb-package==1.0.30.0",), ("embreex==4.4.0.post1",), ("trimesh==5.2.0",))
TIME_LIMIT = 120  # seconds


class PeerProblem(Exception):
    """Why a library has no result."""


def install():
    """Install what is missing; return the environment's Python."""
    python = ENVIRONMENT / "bin" / "python"
    if not python.exists():
        print("installing other libraries into build/peers", flush=True)
        venv.create(ENVIRONMENT, with_pip=True, clear=True)
    present = _list_packages(python)
    for choices in PACKAGES:
        if not any(package in present or _install(python, package) for package in choices):
            print(f"{choices[0]} cannot be installed", flush=True)
    return python


def _list_packages(python):
    command = [python, "-m", "pip", "list", "--format=freeze"]
    return subprocess.run(command, text=True, stdout=subprocess.PIPE, check=True).stdout.split()


def _install(python, package):
    command = [python, "-m", "pip", "install", "--quiet", package]
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          check=False).returncode == 0


def get_versions(python):
    """Return the installed libraries, each as in "trimesh 5.2.0"."""
    wanted = [package for choices in PACKAGES for package in choices]
    return [line.replace("==", " ") for line in _list_packages(python) if line in wanted]


def find_version(versions, name):
    """Return a library's version, "-" if it is not installed."""
    return next((version for version in versions if version.startswith(name.lower())), "-")


@contextlib.contextmanager
def real_time():
    """Give this process and its children the priority of lms3dBenchmark, if the system permits."""
    policy, parameters = os.sched_getscheduler(0), os.sched_getparam(0)
    with contextlib.suppress(PermissionError):
        os.sched_setscheduler(0, os.SCHED_FIFO,
                              os.sched_param(os.sched_get_priority_min(os.SCHED_FIFO)))
    try:
        yield
    finally:
        os.sched_setscheduler(0, policy, parameters)


def run(python, program, *arguments, result_file, environment=None):
    """Run a program of this folder; return the arrays that it saves.

    `environment` has further variables of the system's environment.
    """
    result_file.unlink(missing_ok=True)
    command = [python, HERE / program, *map(str, arguments), result_file]
    try:
        with real_time():
            process = subprocess.run(command, timeout=TIME_LIMIT, check=False, text=True,
                                     env={**os.environ, **(environment or {})},
                                     stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    except subprocess.TimeoutExpired as problem:
        raise PeerProblem(f"over {TIME_LIMIT} s") from problem
    if process.returncode < 0:
        raise PeerProblem(f"crashes ({signal.Signals(-process.returncode).name})")
    if process.returncode > 0:
        last_line = (process.stderr.strip().splitlines() or ["fails"])[-1]
        raise PeerProblem(last_line.replace(",", ";"))
    return dict(numpy.load(result_file))
