# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Tables S, without a picture: the times of scans, of building and of reading."""

import os
import subprocess

import tables
from places import BENCHMARK
from speed_tables import TITLE

LETTER = "S"
NAME = "speed"
SUMMARY = TITLE[0].lower() + TITLE[1:] + "; no picture"

# The arguments of lms3dBenchmark for each CSV file.
OURS = ("--methods", "Exact", "Fast")
PARTS = {
    "scenes": ("scan", *OURS),
    "scan": ("scan", *OURS, "--scenes", "room", "castle", "teapot", "terrain1e6"),
    "methods": ("scan", "--scenes", "room", "teapot",
                "--methods", "AngleSum", "MollerTrumbore", "StaticCellLocator"),
    "first": ("first", "--scenes", "terrain1e6"),
    "read": ("read", "--scenes", "terrain1e6", "terrain1e7"),
}
PARTS_WHEN_QUICK = {
    "scan": ("scan", "--quick", *OURS, "--scenes", "room", "teapot"),
    "first": ("first", "--quick", "--scenes", "room"),
    "read": ("read", "--quick", "--scenes", "room"),
}
KERNELS = ("Baseline", "AVX2", "AVX512")
KERNEL_SCENES = ("room", "castle", "teapot", "terrain1e5", "terrain1e6")

draw = None


def measure(quick, csv_file):
    """Run the benchmarks; their tables stand beside csv_file, each with its part in its name."""
    for part, arguments in (PARTS_WHEN_QUICK if quick else PARTS).items():
        _run(arguments, _name(csv_file, part))
    if not quick:
        _measure_kernels(csv_file)


def _name(csv_file, part):
    return csv_file.with_name(f"{csv_file.stem}-{part}.csv")


def _run(arguments, csv_file, kernels=""):
    environment = {**os.environ, "LMS3D_KERNELS": kernels} if kernels else None
    print(f"   {' '.join(arguments)} {kernels}".rstrip(), flush=True)
    subprocess.run([BENCHMARK, *arguments, "--csv", csv_file], stdout=subprocess.DEVNULL,
                   env=environment, check=True)


def _measure_kernels(csv_file):
    """Scan with each instruction set that the processor has, Embree restricted to it as well."""
    rows = []
    path = _name(csv_file, "kernels")
    for name in KERNELS:
        _run(("scan", "--quick", *OURS, "--scenes", *KERNEL_SCENES), path, name)
        rows += tables.select(tables.read(path), kernels=name)
    tables.write(path, rows)
