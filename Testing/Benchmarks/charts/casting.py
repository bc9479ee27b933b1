# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Chart A: the time of a beam against the error of its range, for all that casts beams."""

import os
import pathlib
import subprocess
import sys
import tempfile

import casting_panels
import drawing
import numpy
import peers
import tables
from casting_panels import ERRORS
from matplotlib import pyplot
from peers_casters import CASTERS
from places import BENCHMARK

LETTER = "A"
NAME = "casting"
SUMMARY = "time of a beam against the error of its range, for every method and other casters"

SECONDS = 2.0  # for which a caster called from Python repeats its scan


def measure(quick, csv_file):
    """Run the C++ casters, then the casters for Python with the same beams and the same truth."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        command = [BENCHMARK, "casting", "--csv", folder / "table.csv", "--beams", folder]
        subprocess.run(command + ["--quick"] * quick, stdout=subprocess.DEVNULL, check=True)
        rows = tables.read(folder / "table.csv")
        scenes = {row["scene"]: row["triangles"] for row in rows}
        rows = [{**row, "version": "-"} for row in rows]
        rows += [] if quick else _measure_peers(scenes, folder)
    tables.write(csv_file, sorted(rows, key=lambda row: list(scenes).index(row["scene"])))


def _measure_peers(scenes, folder):
    """Return the rows of the casters for Python, all on one core."""
    try:
        python = peers.install()
    except (OSError, subprocess.CalledProcessError) as problem:
        print(f"{', '.join(CASTERS)} are left out: {problem}")
        return [_make_row(scene, triangles, caster, "cannot be installed", "-")
                for scene, triangles in scenes.items() for caster in CASTERS]
    versions = peers.get_versions(python)
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {max(cores)})
    try:
        return [_measure_peer(caster, scene, triangles, python, folder, versions)
                for scene, triangles in scenes.items() for caster in CASTERS]
    finally:
        os.sched_setaffinity(0, cores)


def _measure_peer(caster, scene, triangles, python, folder, versions):
    print(f"{scene}, {caster}", file=sys.stderr)
    version = peers.find_version(versions, caster)
    scene_file = folder / "scene.npz"
    numpy.savez(scene_file, **_load(folder, scene))
    try:
        result = peers.run(python, "peers_casters.py", caster, scene_file, SECONDS,
                           result_file=folder / "result.npz")
    except peers.PeerProblem as problem:
        return _make_row(scene, triangles, caster, str(problem), version)
    truth = numpy.fromfile(folder / f"{scene}.ranges")
    return _make_row(scene, triangles, caster, "done", version, **_judge(result, truth))


def _load(folder, scene):
    """Return the scene and the beams of the C++ casters."""
    return {"points": numpy.fromfile(folder / f"{scene}.points").reshape(-1, 3),
            "triangles": numpy.fromfile(folder / f"{scene}.triangles",
                                        numpy.uint32).reshape(-1, 3).astype(numpy.int32),
            "sensor": numpy.fromfile(folder / f"{scene}.sensor"),
            "directions": numpy.fromfile(folder / f"{scene}.directions").reshape(-1, 3)}


def _make_row(scene, triangles, caster, end, version, **values):
    row = {"scene": scene, "caster": caster, "triangles": triangles, "threads": 1}
    for key in ("beams timed", "ns/beam", "beams compared", "hits", "misses", "false hits",
                *ERRORS):
        row[key] = values.get(key, "-")
    return {**row, "end": end, "version": version}


def _judge(result, truth):
    """Return what a row holds; beams without a true range are not compared."""
    is_compared = ~numpy.isnan(truth)
    beams, truth, ranges = len(truth), truth[is_compared], result["ranges"][is_compared]
    is_hit, is_true = numpy.isfinite(ranges), numpy.isfinite(truth)
    both = is_hit & is_true
    errors = numpy.sort(numpy.abs(ranges[both] - truth[both]) / truth[both])
    return {"beams timed": beams, "ns/beam": f"{1e9 * result['seconds'] / beams:.1f}",
            "beams compared": len(truth), "hits": int(is_true.sum()),
            "misses": int((is_true & ~is_hit).sum()),
            "false hits": int((is_hit & ~is_true).sum()),
            **{name: f"{errors[len(errors) - 1 - int(len(errors) * above)]:.1e}"
               for name, above in ERRORS.items() if len(errors)}}


def _list(rows):
    """Casters by their scenes, as in "a, b on room, teapot"."""
    scenes = {}
    for row in rows:
        scenes.setdefault(row["caster"], []).append(tables.name_scene(row["scene"]))
    casters = {}
    for caster, names in scenes.items():
        casters.setdefault(", ".join(names), []).append(caster)
    return "; ".join(f"{', '.join(some)} on {names}" for names, some in casters.items())


def _words(table):
    """Return the caption's words about this table."""
    most = max(int(row["beams timed"]) for row in table if row["end"] == "done")
    words = (f"The default scan, {most:,} beams without a limit of the range, best of many; errors "
             "against exact arithmetic. LMS3D's methods: the filter's whole update with all its "
             "arrays; casters for Python make points, too; the others get directions and give "
             "ranges. ★ and the black line: everything quicker has a larger worst error, or misses "
             "or invents beams. Faint: only as many beams as the name says, because a scan takes "
             "long; the worst of few errors is smaller.")
    for end in dict.fromkeys(row["end"] for row in table if row["end"] != "done"):
        words += f" Left out ({end}): {_list([row for row in table if row['end'] == end])}."
    versions = dict.fromkeys(row["version"] for row in table if row["version"] != "-")
    return words + (f" Versions: {', '.join(versions)}," if versions else "")


def draw(table, machine):
    """A row of panels for each scene: time and errors, the names, and the beams that fail."""
    scenes = list(dict.fromkeys(row["scene"] for row in table))
    head, foot, step, tall = 0.95, 1.35, 3.45, 2.9  # inches
    height = head + step * len(scenes) - (step - tall) + foot
    figure = pyplot.figure(figsize=(9.2, height))
    for number, scene in enumerate(scenes):
        rows = sorted((row for row in table if row["scene"] == scene and row["end"] == "done"),
                      key=casting_panels.get_time)
        bottom = 1 - (head + step * number + tall) / height
        axes = figure.add_axes((0.078, bottom, 0.47, tall / height))
        casting_panels.draw_errors(axes, rows)
        axes.set_title(f"{tables.name_scene(scene)}, {int(rows[0]['triangles']):,} triangles: "
                       "time per beam", loc="left")
        failures = figure.add_axes((0.80, bottom, 0.165, tall / height))
        casting_panels.draw_failures(failures, rows)
        failures.set_title("missed ◀   invented ▶", loc="left", fontsize=8.5)
    axes.set_xlabel("relative error of the range")
    failures.set_xlabel("share of the beams")
    figure.suptitle("Casting: what a beam costs, and how far off its range is", x=0.01, ha="left",
                    y=1 - 0.12 / height, fontsize=13, weight="bold")
    casting_panels.draw_key(figure, 1 - 0.52 / height)
    drawing.add_caption(figure, drawing.caption(_words(table), machine), 165)
    return figure
