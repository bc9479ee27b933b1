# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the same scan through LMS3D and other ray casters for Python, and compares them.

Call it as "./run bench peers". The others are installed into a virtual environment of its own,
build/peers; one that cannot be installed is left out. Each runs in a process of its own and makes
the ranges and the points of the default grid of 361 x 360 beams.
"""

import argparse
import csv
import pathlib
import subprocess
import sys
import tempfile
import venv

import numpy

import peers_casters
import peers_reference
import peers_scene

HERE = pathlib.Path(__file__).resolve().parent
ENVIRONMENT = HERE.parents[1] / "build" / "peers"
# open3d-cpu is the same without CUDA, and smaller; it is not made for every platform. Both need
# libusb.
PACKAGES = (("numpy",), ("open3d-cpu", "open3d"), ("libusb-package",), ("embreex",), ("trimesh",))
COLUMNS = ("scene", "peer", "build ms", "scan ms", "Mbeams/s", "hits", "lost", "false",
           "median error m", "worst error m", "scans")
TIME_LIMIT = 120
SAMPLE = 2000
SAMPLE_OF_LARGE_SCENE = 300
LARGE_SCENE = 200_000


def install():
    """Make the environment where there is none, and install what is missing."""
    python = ENVIRONMENT / "bin" / "python"
    if not python.exists():
        print(f"making {ENVIRONMENT.name}/ in build/, installing peers", flush=True)
        venv.create(ENVIRONMENT, with_pip=True, clear=True)
    for names in PACKAGES:
        if not any(_has(python, name) or _install(python, name) for name in names):
            print(f"{names[0]} cannot be installed; left out")
    return python


def _has(python, name):
    return _run(python, "-m", "pip", "show", "--quiet", name)


def _install(python, name):
    return _run(python, "-m", "pip", "install", "--quiet", name)


def _run(*command):
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          check=False).returncode == 0


def versions(python):
    """Return the versions of the installed peers."""
    listing = subprocess.run([python, "-m", "pip", "list", "--format=freeze"], text=True,
                             stdout=subprocess.PIPE, check=True).stdout.split()
    names = [name for group in PACKAGES for name in group]
    return [line.replace("==", " ") for line in listing if line.split("==")[0] in names]


def compare(name, python, folder):
    """Return a row for each peer."""
    points, triangles, sensor = peers_scene.make(name)
    directions = peers_scene.make_directions()
    scene_file = folder / "scene.npz"
    numpy.savez(scene_file, points=points, triangles=triangles, sensor=sensor,
                directions=directions, reach=peers_scene.MAXIMUM_RANGE)

    count = SAMPLE_OF_LARGE_SCENE if len(triangles) > LARGE_SCENE else SAMPLE
    beams = numpy.linspace(0, len(directions) - 1, count).astype(int)
    truth = peers_reference.cast(points, triangles, sensor, directions[beams])
    truth = numpy.where(truth <= peers_scene.MAXIMUM_RANGE, truth, numpy.inf)
    print(f"\n{name}: {len(triangles)} triangles, {count} beams compared with rational numbers\n")

    rows = []
    for peer, (is_debian, _) in peers_casters.PEERS.items():
        result = _scan(peer, sys.executable if is_debian else python, scene_file, folder)
        rows.append([name, peer, *_describe(result, beams, truth)])
    _print(rows)
    return rows


def _scan(peer, python, scene_file, folder):
    result_file = folder / "result.npz"
    result_file.unlink(missing_ok=True)
    command = [python, HERE / "peers_casters.py", peer, scene_file, result_file]
    try:
        subprocess.run(command, timeout=TIME_LIMIT, check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.PIPE, text=True)
    except subprocess.TimeoutExpired:
        return f"over {TIME_LIMIT} s"
    except subprocess.CalledProcessError as problem:
        return (problem.stderr.strip().splitlines() or ["failed"])[-1].replace(",", ";")
    return dict(numpy.load(result_file))


def _describe(result, beams, truth):
    if isinstance(result, str):
        return ["-", result, *["-"] * (len(COLUMNS) - 4)]
    ranges = result["ranges"]
    sample = ranges[beams]
    is_hit, is_true = numpy.isfinite(sample), numpy.isfinite(truth)
    both = is_hit & is_true
    errors = numpy.abs(sample[both] - truth[both])
    milliseconds = 1000 * result["scan"]
    return [f"{1000 * result['build']:.1f}", f"{milliseconds:.2f}",
            f"{len(ranges) / milliseconds / 1000:.2f}", int(numpy.isfinite(ranges).sum()),
            int((is_true & ~is_hit).sum()), int((is_hit & ~is_true).sum()),
            f"{numpy.median(errors):.1e}", f"{errors.max():.1e}", int(result["scans"])]


def _print(rows):
    rows = [COLUMNS, ["---"] * 2 + ["--:"] * (len(COLUMNS) - 2), *rows]
    widths = [max(len(str(row[i])) for row in rows) for i in range(len(COLUMNS))]
    for row in rows:
        cells = [str(cell).ljust(width) if i < 2 else str(cell).rjust(width)
                 for i, (cell, width) in enumerate(zip(row, widths))]
        print("| " + " | ".join(cells) + " |", flush=True)


def main():
    """Read the command line, compare, save."""
    parser = argparse.ArgumentParser(prog="./run bench peers", description=__doc__)
    parser.add_argument("--scenes", nargs="+", choices=peers_scene.NAMES,
                        default=["room", "teapot", "terrain1e6"])
    parser.add_argument("--csv", metavar="FILE", help="save the table")
    options = parser.parse_args()

    python = install()
    print("; ".join(versions(python)))
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name in options.scenes:
            rows += compare(name, python, pathlib.Path(folder))
    if options.csv:
        with open(options.csv, "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([COLUMNS, *rows])


if __name__ == "__main__":
    main()
