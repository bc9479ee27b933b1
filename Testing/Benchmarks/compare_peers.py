# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the same scan through LMS3D and other ray casters for Python, and compares them.

Call it as "./run bench peers". The others are installed into a virtual environment of its own,
build/peers; one that cannot be installed is left out. Each runs in a process of its own and makes
the ranges and the points of the default grid of 361 x 360 beams. Columns with the names of those of
"./run bench scan" mean the same, but that misses, false hits and the relative errors are of a sample,
and that building ends with the first scan.
"""

import argparse
import csv
import pathlib
import signal
import subprocess
import sys
import tempfile
import venv

import numpy

import peers_casters
import peers_reference
import peers_scene
from places import BENCHMARK, ROOT

HERE = pathlib.Path(__file__).resolve().parent
ENVIRONMENT = ROOT / "build" / "peers"
# The published table is of these versions. open3d-cpu is the same without CUDA, and smaller; it is
# not made for every platform. Both need libusb.
PACKAGES = (("numpy==2.4.6",), ("open3d-cpu==0.20.0", "open3d==0.20.0"),
            ("libusb-package==1.0.30.0",), ("embreex==4.4.0.post1",), ("trimesh==5.2.0",))
COLUMNS = ("scene", "peer", "threads", "build ms", "scan ms", "Mbeams/s", "x raw", "peak MB",
           "hits", "misses", "false hits", "median error", "worst error", "worst point m", "scans")
# A point farther than that from where its beam's range ends, metres, is a mistake; single precision
# is off by some 1e-5.
MOST_POINT_ERROR = 1e-3
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
    present = _installed(python)
    for choices in PACKAGES:
        if not any(x in present or _install(python, x) for x in choices):
            print(f"{choices[0]} cannot be installed; left out")
    return python


def _installed(python):
    return subprocess.run([python, "-m", "pip", "list", "--format=freeze"], text=True,
                          stdout=subprocess.PIPE, check=True).stdout.split()


def _install(python, package):
    command = [python, "-m", "pip", "install", "--quiet", package]
    return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          check=False).returncode == 0


def versions(python):
    """Return the versions of the installed peers."""
    wanted = [package for choices in PACKAGES for package in choices]
    return [line.replace("==", " ") for line in _installed(python) if line in wanted]


def time_raw_packets(name, folder):
    """Return milliseconds of Embree's raw packets by number of threads, as "./run bench scan" does."""
    if not BENCHMARK.exists():
        print(f"x raw is left out: there is no {BENCHMARK}")
        return {}
    table = folder / "raw.csv"
    subprocess.run([BENCHMARK, "scan", "--quick", "--scenes", name, "--methods", "Fast", "--csv",
                    table], stdout=subprocess.DEVNULL, check=True)
    with open(table, newline="", encoding="utf-8") as file:
        return {int(row["threads"]): float(row["scan ms"]) for row in csv.DictReader(file)
                if row["method"] == "raw packets"}


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

    raw = time_raw_packets(name, folder)
    rows = []
    reasons = []
    for number, peer in enumerate(peers_casters.PEERS):
        row = [name, peer.name, peer.threads]
        try:
            result = scan(number, sys.executable if peer.is_debian else python, scene_file, folder)
            rows.append(row + _describe(result, raw.get(peer.threads), beams, truth))
        except PeerProblem as problem:
            reasons.append(f"{peer.name} is left out: {problem}")
            rows.append(row + ["-"] * (len(COLUMNS) - len(row)))
    print_table(COLUMNS, rows)
    print("", *reasons, sep="\n", flush=True)
    return rows


class PeerProblem(Exception):
    """Why a peer has no numbers."""


def scan(number, python, scene_file, folder, seconds=peers_casters.SECONDS):
    """Let a peer, by its number, repeat a scan for some seconds; return what it found."""
    result_file = folder / "result.npz"
    result_file.unlink(missing_ok=True)
    command = [python, HERE / "peers_casters.py", str(number), scene_file, result_file,
               str(seconds)]
    try:
        run = subprocess.run(command, timeout=TIME_LIMIT, check=False, text=True,
                             stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    except subprocess.TimeoutExpired as problem:
        raise PeerProblem(f"it takes more than {TIME_LIMIT} s") from problem
    if run.returncode < 0:
        raise PeerProblem(f"it crashes ({signal.Signals(-run.returncode).name})")
    if run.returncode > 0:
        raise PeerProblem((run.stderr.strip().splitlines() or ["it fails"])[-1])
    result = dict(numpy.load(result_file))
    if not result["point_error"] <= MOST_POINT_ERROR:
        raise PeerProblem(f"its points are {result['point_error']:.1e} m from where its ranges end")
    return result


def judge(ranges, truth):
    """Return how many beams fail, and the relative errors of those that truly hit and do."""
    is_hit, is_true = numpy.isfinite(ranges), numpy.isfinite(truth)
    both = is_hit & is_true
    failures = {"misses": int((is_true & ~is_hit).sum()),
                "false hits": int((is_hit & ~is_true).sum())}
    return failures, numpy.abs(ranges[both] - truth[both]) / truth[both]


def _describe(result, raw, beams, truth):
    ranges = result["ranges"]
    failures, errors = judge(ranges[beams], truth)
    milliseconds = 1000 * result["scan"]
    return [f"{1000 * result['build']:.1f}", f"{milliseconds:.3f}",
            f"{len(ranges) / milliseconds / 1000:.1f}", f"{milliseconds / raw:.2f}" if raw else "-",
            f"{result['peak'] / 2**20:.0f}", int(numpy.isfinite(ranges).sum()),
            *failures.values(),
            f"{numpy.median(errors):.1e}" if errors.size else "-",
            f"{errors.max():.1e}" if errors.size else "-",
            f"{result['point_error']:.1e}", int(result["scans"])]


def print_table(columns, rows):
    """Print Markdown; the first two columns hold words, the others numbers."""
    rows = [columns, ["---"] * 2 + ["--:"] * (len(columns) - 2), *rows]
    widths = [max(len(str(row[i])) for row in rows) for i in range(len(columns))]
    for row in rows:
        cells = [str(cell).ljust(width) if i < 2 else str(cell).rjust(width)
                 for i, (cell, width) in enumerate(zip(row, widths))]
        print("| " + " | ".join(cells) + " |", flush=True)


def save(rows, file_name):
    """Write the rows so far."""
    with open(file_name, "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([COLUMNS, *rows])


def main():
    """Read the command line, compare, save."""
    parser = argparse.ArgumentParser(prog="./run bench peers", description=__doc__)
    parser.add_argument("--scenes", nargs="+", choices=peers_scene.NAMES,
                        default=["room", "teapot", "terrain1e6"])
    parser.add_argument("--csv", metavar="FILE", type=pathlib.Path,
                        default=ENVIRONMENT / "peers.csv",
                        help="where to save the table (default: build/peers/peers.csv)")
    options = parser.parse_args()

    python = install()
    print("; ".join(versions(python)))
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name in options.scenes:
            rows += compare(name, python, pathlib.Path(folder))
            save(rows, options.csv)
    print(f"saved {options.csv}")


if __name__ == "__main__":
    main()
