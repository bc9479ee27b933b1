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
from casting_panels import ERRORS, PEERS
from matplotlib import pyplot

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import compare_peers  # noqa: E402  (of the folder above)
import peers_casters  # noqa: E402

LETTER = "A"
NAME = "casting"
SUMMARY = "time of a beam against the error of its range, for every method and other casters"

SECONDS = 2.0


def measure(quick, csv_file):
    """Run the C++ casters, then those for Python with the same beams and the same truth."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        command = [drawing.BENCHMARK, "casting", "--csv", folder / "table.csv", "--beams", folder]
        subprocess.run(command + ["--quick"] * quick, stdout=subprocess.DEVNULL, check=True)
        rows = drawing.read_table(folder / "table.csv")
        scenes = {row["scene"]: row["triangles"] for row in rows}
        peers, versions = ([], {}) if quick else _measure_peers(scenes, folder)
    rows = [{**row, "version": versions.get(row["caster"], "-")} for row in rows + peers]
    drawing.write_table(csv_file, sorted(rows, key=lambda row: list(scenes).index(row["scene"])))


def _measure_peers(scenes, folder):
    """Their rows, each from a process of its own, on one core; and their versions."""
    try:
        python = compare_peers.install()
    except (OSError, subprocess.CalledProcessError) as problem:
        print(f"Open3D and trimesh are left out: {problem}")
        return [_row(scene, triangles, peer, "cannot be installed")
                for scene, triangles in scenes.items() for peer in PEERS.values()], {}
    cores = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {max(cores)})
    try:
        rows = [_measure_peer(number, peer.name, scene, triangles, python, folder)
                for scene, triangles in scenes.items()
                for number, peer in enumerate(peers_casters.PEERS) if peer.name in PEERS]
    finally:
        os.sched_setaffinity(0, cores)
    return rows, {name: version for name in PEERS.values()
                  for version in compare_peers.versions(python)
                  if version.startswith(name.lower())}


def _measure_peer(number, name, scene, triangles, python, folder):
    print(f"{scene}, {PEERS[name]}", file=sys.stderr)
    scene_file = folder / "scene.npz"
    numpy.savez(scene_file, reach=numpy.inf, **_load(folder, scene))
    try:
        result = compare_peers.scan(number, python, scene_file, folder, SECONDS)
    except compare_peers.PeerProblem as problem:
        return _row(scene, triangles, PEERS[name], str(problem).replace(",", ";"))
    truth = numpy.fromfile(folder / f"{scene}.ranges")
    return _row(scene, triangles, PEERS[name], "done", **_judge(result, truth))


def _load(folder, scene):
    """What the C++ casters got."""
    return {"points": numpy.fromfile(folder / f"{scene}.points").reshape(-1, 3),
            "triangles": numpy.fromfile(folder / f"{scene}.triangles",
                                        numpy.uint32).reshape(-1, 3).astype(numpy.int32),
            "sensor": numpy.fromfile(folder / f"{scene}.sensor"),
            "directions": numpy.fromfile(folder / f"{scene}.directions").reshape(-1, 3)}


def _row(scene, triangles, caster, end, **values):
    row = {"scene": scene, "caster": caster, "triangles": triangles, "threads": 1}
    for key in ("beams timed", "ns/beam", "beams compared", "hits", "misses", "false hits",
                *ERRORS):
        row[key] = values.get(key, "-")
    return {**row, "end": end}


def _judge(result, truth):
    asked = ~numpy.isnan(truth)
    failures, errors = compare_peers.judge(result["ranges"][asked], truth[asked])
    errors = numpy.sort(errors)
    return {"beams timed": len(truth), "ns/beam": f"{1e9 * result['scan'] / len(truth):.1f}",
            "beams compared": int(asked.sum()), "hits": int(numpy.isfinite(truth).sum()),
            **failures,
            **{name: f"{errors[len(errors) - 1 - int(len(errors) * above)]:.1e}"
               for name, above in ERRORS.items() if len(errors)}}


def _list(rows):
    """Casters by their scenes, as in "a, b on room, teapot"."""
    scenes = {}
    for row in rows:
        scenes.setdefault(row["caster"], []).append(drawing.name_scene(row["scene"]))
    casters = {}
    for caster, names in scenes.items():
        casters.setdefault(", ".join(names), []).append(caster)
    return "; ".join(f"{', '.join(some)} on {names}" for names, some in casters.items())


def _words(table):
    """What the caption says of this table."""
    most = max(int(row["beams timed"]) for row in table if row["end"] == "done")
    words = (f"The default scan, {most:,} beams without a limit of the range, best of many; errors "
             "against exact arithmetic. LMS3D's methods: the filter's whole update, all its "
             "arrays; those of Python make points, too; the others get directions and give ranges. "
             "★ and the black line: all that is quicker has a larger worst error, or misses or "
             "invents beams. Faint: of as few beams as the name tells, since it takes long; the "
             "worst of few errors is smaller.")
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
        axes.set_title(f"{drawing.name_scene(scene)}, {int(rows[0]['triangles']):,} triangles: "
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
