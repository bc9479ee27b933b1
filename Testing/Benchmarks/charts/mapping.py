# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Chart B: what maps cost in time and triangles, and how far they are from the scene."""

import pathlib
import shutil
import subprocess
import tempfile

import damage_tables
import drawing
import mapping_panels
import numpy
import peers
import peers_scans
import tables
from lms3d.comparison import compare
from matplotlib import pyplot
from peers_mappers import MAPPERS
from places import BENCHMARK
from vtkmodules.util.numpy_support import vtk_to_numpy

LETTER = "B"
NAME = "mapping"
SUMMARY = "time and triangles of maps against their error, without and with noise"

SCENES = ("room", "teapot", "terrain1e5")
SCENES_WHEN_QUICK = ("room", "teapot")
TABLE, DAMAGE = "map.csv", "map-damage.csv"  # the second is of the room alone


def measure(quick, csv_file):
    """Run the benchmark of VTK's maps and ours, and give Open3D the same scans."""
    python, version = (None, "-") if quick else _install()
    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for scene in SCENES_WHEN_QUICK if quick else SCENES:
            print(f"   {scene}", flush=True)
            some = [{**row, "version": "-"} for row in _run_benchmark(scene, quick, folder)]
            rows += some
            if (folder / DAMAGE).exists():
                shutil.copy(folder / DAMAGE, csv_file.with_name(damage_tables.FILE))
            if version != "-":
                same = {key: some[0][key] for key in ("scene triangles", "hit triangles")}
                empty = {**dict.fromkeys(some[0], "-"), **same, "scene": scene, "version": version}
                rows += _map_with_peers(empty, python, folder)
    tables.write(csv_file, rows)


def _install():
    """Return the Python that has Open3D, and Open3D's version, "-" if it cannot be installed."""
    try:
        python = peers.install()
        return python, peers.find_version(peers.get_versions(python), "Open3D")
    except (OSError, subprocess.CalledProcessError) as problem:
        print(f"Open3D is left out: {problem}")
        return None, "-"


def _run_benchmark(scene, quick, folder):
    table = folder / TABLE
    (folder / DAMAGE).unlink(missing_ok=True)
    command = [BENCHMARK, "map", "--scenes", scene, "--csv", table] + ["--quick"] * quick
    subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
    return tables.read(table)


def _map_with_peers(empty, python, folder):
    """Return a row for each map of the scan without and with noise; "empty" has the other cells."""
    surface, exact, sensor = peers_scans.make_scan(empty["scene"])
    rows = []
    for scan, noise in ((exact, "0"), (peers_scans.add_noise(exact, sensor),
                                       f"{1000 * peers_scans.NOISE:g}")):
        numpy.savez(folder / "points.npz", sensor=sensor,
                    points=vtk_to_numpy(scan.GetPoints().GetData()))
        for mapper in MAPPERS:
            cells = _measure_mapper(mapper, python, folder, surface, scan)
            rows.append({**empty, "map": mapper, "noise mm": noise, **cells})
    return rows


def _measure_mapper(mapper, python, folder, surface, scan):
    try:
        result = peers.run(python, "peers_mappers.py", mapper, folder / "points.npz",
                           result_file=folder / "map.npz")
    except peers.PeerProblem as problem:
        return {"ms": str(problem)}
    local_map = peers_scans.make_surface(result["points"], result["triangles"])
    errors = compare(local_map, surface, scan)
    to_scene, to_map = errors.map_to_scene, errors.scene_to_map
    return {
        "ms": f"{1000 * float(result['seconds']):.2f}",
        "triangles": local_map.GetNumberOfCells(),
        "to scene mean mm": f"{1000 * to_scene.mean:.2f}",
        "to scene 95% mm": f"{1000 * to_scene.percentile_95:.1f}",
        "to scene max mm": f"{1000 * to_scene.maximum:.0f}",
        "to map mean mm": f"{1000 * to_map.mean:.2f}",
        "to map 95% mm": f"{1000 * to_map.percentile_95:.1f}",
        "both mean mm": f"{500 * (to_scene.mean + to_map.mean):.2f}",
        "correct %": f"{100 * errors.correctness:.2f}",
        "complete %": f"{100 * errors.completeness:.2f}",
        "normals deg": f"{errors.normal_error.mean:.1f}",
        "free space m2": f"{errors.area_in_free_space:.3f}",
        "farthest return mm": f"{1000 * errors.largest_return_distance:.2f}",
    }


def _words(table):
    """Return the caption's words about this table."""
    words = (
        "The same scans of 361 x 360 beams for all. Mean error: the mean of map to scene and "
        "visible scene to map, the ends of the upright lines. Bounded maps: within 1, 5, "
        "10, 20 and 50 mm, as named at the top right. Decimation gets as many triangles as the "
        "bounded maps within 1 (with noise 10), 10 (20) and 50 mm, vtkDecimatePro as the second. "
        "Times: the best of several runs; what takes seconds runs once.")
    others = {row["version"] for row in mapping_panels.select(table)} - {"-"}
    return " ".join([words, *(f"{version} has all cores." for version in sorted(others))])


def draw(table, machine):
    """Time and triangles against error for each scene, and the scenes' own triangles."""
    names = list(dict.fromkeys(row["scene"] for row in table))
    height = 3.9 + 2.5 * len(names)
    figure = pyplot.figure(figsize=(9.2, height))
    upper = figure.add_gridspec(len(names), 2, top=1 - 1.0 / height, bottom=2.9 / height,
                                left=0.095, right=0.985, hspace=0.2, wspace=0.05)
    lower = figure.add_gridspec(1, len(names), top=2.05 / height, bottom=0.9 / height,
                                left=0.15, right=0.985, wspace=0.08)
    above = upper.subplots(sharex="col", sharey="row", squeeze=False)
    below = lower.subplots(sharex="all", sharey="all", squeeze=False)[0]
    for name, panels, counts in zip(names, above, below):
        mapping_panels.draw_scene([row for row in table if row["scene"] == name], *panels, counts)
    mapping_panels.name_bounds(above[0][1], [row for row in table if row["scene"] == names[0]])
    above[-1][0].set_xlabel("time from the scan to the map, ms")
    above[-1][1].set_xlabel("triangles of the map")
    figure.align_ylabels(above[:, 0])
    figure.suptitle("What a map costs, and how far it is from the scene", x=0.01, ha="left",
                    y=1 - 0.1 / height, fontsize=13, weight="bold")
    mapping_panels.add_legend(figure, table, 1 - 0.3 / height)
    drawing.add_caption(figure, drawing.caption(_words(table), machine), 165)
    return figure
