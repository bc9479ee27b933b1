# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Chart A: the time of a beam against the error of its range, for all that casts beams."""

import os
import pathlib
import subprocess
import sys
import tempfile

import drawing
import numpy
from matplotlib import pyplot, ticker

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import compare_peers  # noqa: E402  (of the folder above)
import peers_casters  # noqa: E402
import peers_scene  # noqa: E402

LETTER = "A"
NAME = "casting"
SUMMARY = "time of a beam against the error of its range, for every method and other casters"

# Their names in peers_casters.py, and on the chart.
PEERS = {"Open3D RaycastingScene": "Open3D", "trimesh + embreex": "trimesh"}
SECONDS = 2.0
ERRORS = {"median error": 0.5, "99.9% error": 0.001, "worst error": 0.0}


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
    numpy.savez(scene_file, reach=peers_scene.MAXIMUM_RANGE, **_load(folder, scene))
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
    ranges, true_ranges = result["ranges"][asked], truth[asked]
    is_hit, is_true = numpy.isfinite(ranges), numpy.isfinite(true_ranges)
    both = is_hit & is_true
    errors = numpy.sort(numpy.abs(ranges[both] - true_ranges[both]) / true_ranges[both])
    return {"beams timed": len(truth), "ns/beam": f"{1e9 * result['scan'] / len(truth):.1f}",
            "beams compared": int(asked.sum()), "hits": int(is_true.sum()),
            "misses": int((is_true & ~is_hit).sum()),
            "false hits": int((is_hit & ~is_true).sum()),
            **{name: f"{errors[len(errors) - 1 - int(len(errors) * above)]:.1e}"
               for name, above in ERRORS.items()}}


NO_ERROR, MOST_ERROR = 1e-17, 10.0  # where errors of 0 are drawn, and the end of the axis
NO_FAILURE = 1e-6  # where shares of 0 are drawn
DOMINATED = "#f0f0f0"
# Group, colour, and how its names begin; LMS3D's methods are all the others.
GROUPS = (
    ("LMS3D", drawing.COLORS[0], ()),
    ("Embree, single precision", drawing.COLORS[1], ("Embree",)),
    ("VTK's locators", drawing.COLORS[2], ("vtk",)),
    ("called from Python", drawing.COLORS[3], tuple(PEERS.values())),
)
MARKERS = {"median error": "o", "99.9% error": "|", "worst error": "D"}


def _color(caster):
    return next((color for _, color, starts in GROUPS[1:] if caster.startswith(starts)),
                GROUPS[0][1])


def _time(row):
    return float(row["ns/beam"])


def _error(row, name="worst error"):
    return max(NO_ERROR, float(row[name]))


def _fails(row):
    return int(row["misses"]) + int(row["false hits"]) > 0


def frontier(rows):
    """Those that fail for no beam, while all that are quicker fail for some or err more."""
    chosen = []
    for row in sorted(rows, key=lambda row: (_time(row), _error(row))):
        if not _fails(row) and (not chosen or _error(row) < _error(chosen[-1])):
            chosen.append(row)
    return chosen


def _draw_frontier(axes, chosen):
    """A staircase; whatever is beyond it is slower and errs more than something on it."""
    x = [MOST_ERROR] + [_error(row) for row in chosen for _ in range(2)]
    y = [_time(row) for row in chosen for _ in range(2)] + [axes.get_ylim()[1]]
    axes.fill_between(x, y, axes.get_ylim()[1], color=DOMINATED, zorder=0, linewidth=0)
    axes.plot(x, y, color="black", linewidth=0.9, zorder=1)


def _format_time(x, _):
    return next(f"{x / unit:g} {name}"
                for unit, name in ((1e6, "ms"), (1e3, "µs"), (1, "ns"), (1e-3, "ps")) if x >= unit)


def _draw_errors(axes, rows):
    times = [_time(row) for row in rows]
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(NO_ERROR / 4, MOST_ERROR)
    axes.set_ylim(min(times) / 2, max(times) * 2)
    axes.grid(False)
    for row in rows:
        color = _color(row["caster"])
        errors = [_error(row, name) for name in ERRORS]
        axes.plot([errors[0], errors[-1]], [_time(row)] * 2, color=color, linewidth=1.2)
        for error, marker in zip(errors, MARKERS.values()):
            axes.plot(error, _time(row), marker, color=color, markersize=8 if marker == "|" else 4,
                      markerfacecolor="white" if marker == "o" else color, clip_on=False)
    axes.set_xticks([NO_ERROR, *(10.0 ** power for power in range(-15, 1, 3))])
    axes.xaxis.set_major_formatter(lambda x, _: "0" if x == NO_ERROR else f"{x:.0e}")
    axes.xaxis.set_minor_locator(ticker.NullLocator())
    axes.yaxis.set_major_formatter(_format_time)


def _draw_labels(axes, rows, chosen):
    """A name for each, in the order of the times, tied to its mark."""
    for place, row in enumerate(rows):
        height = (place + 0.5) / len(rows)
        here = axes.transAxes.inverted().transform(axes.transData.transform((1, _time(row))))[1]
        color = _color(row["caster"])
        axes.plot([_error(row), MOST_ERROR], [_time(row)] * 2, color=color, linewidth=0.4,
                  alpha=0.6, zorder=0.5)
        axes.plot([1.0, 1.05, 1.07], [here, height, height], transform=axes.transAxes,
                  color=color, linewidth=0.6, clip_on=False)
        is_best = row in chosen
        axes.text(1.08, height, row["caster"] + (" ★" if is_best else ""), va="center", fontsize=8,
                  transform=axes.transAxes, color=color, weight="bold" if is_best else "normal")


def _draw_failures(axes, rows):
    axes.set_xscale("log")
    axes.set_xlim(NO_FAILURE / 2, 1.0)
    axes.set_ylim(0, len(rows))
    for place, row in enumerate(rows):
        color = _color(row["caster"])
        for kind, marker in (("misses", "<"), ("false hits", ">")):
            share = int(row[kind]) / int(row["beams compared"])
            if share > 0:
                axes.plot([NO_FAILURE, share], [place + 0.5] * 2, color=color, linewidth=1)
                axes.plot(share, place + 0.5, marker, color=color, markersize=5, clip_on=False)
        if not _fails(row):
            axes.text(NO_FAILURE, place + 0.5, "0", ha="center", va="center", color="#888888",
                      fontsize=7)
    axes.set_yticks([])
    axes.spines["left"].set_visible(False)
    axes.set_xticks([NO_FAILURE, 1e-4, 1e-2, 1.0])
    axes.xaxis.set_minor_locator(ticker.NullLocator())
    axes.xaxis.set_major_formatter(lambda x, _: "0" if x == NO_FAILURE else f"{100 * x:g} %")


def _draw_key(figure, top):
    """The colours and the marks, in a line under the title."""
    groups = [pyplot.Line2D([], [], color=color, linewidth=3, label=name)
              for name, color, _ in GROUPS]
    marks = [pyplot.Line2D([], [], linestyle="", marker=marker, color="black", label=label,
                           markersize=8 if marker == "|" else 4,
                           markerfacecolor="white" if marker == "o" else "black")
             for marker, label in zip(MARKERS.values(), ("median", "99.9 %", "worst error"))]
    figure.legend(handles=groups + marks, ncols=len(groups + marks), loc="center left",
                  bbox_to_anchor=(0.0, top), fontsize=8.5, handlelength=1.0, handletextpad=0.4,
                  columnspacing=1.3)


def _list(rows):
    """Casters by scene, as in "a, b on room"."""
    scenes = dict.fromkeys(row["scene"] for row in rows)
    return "; ".join(", ".join(row["caster"] for row in rows if row["scene"] == scene)
                     + f" on {scene}" for scene in scenes)


def _words(table):
    """What the caption says of this table."""
    most = max(int(row["beams timed"]) for row in table if row["end"] == "done")
    few = [row for row in table if row["end"] == "done" and int(row["beams timed"]) < most]
    words = (f"The default scan, {most:,} beams, best of many; errors against exact arithmetic. "
             "LMS3D's methods: the filter's whole update, all its arrays; those of Python make "
             "points, too; the others get directions and give ranges. ★ and the black line: all "
             "that is quicker has a larger worst error, or misses or invents beams.")
    if few:
        count = " or ".join(f"{x:,}" for x in sorted({int(row["beams timed"]) for row in few}))
        words += f" Of {count} beams, since they take long: {_list(few)}."
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
                      key=_time)
        bottom = 1 - (head + step * number + tall) / height
        axes = figure.add_axes((0.078, bottom, 0.49, tall / height))
        chosen = frontier(rows)
        _draw_errors(axes, rows)
        _draw_frontier(axes, chosen)
        _draw_labels(axes, rows, chosen)
        axes.set_title(f"{scene}, {int(rows[0]['triangles']):,} triangles: time per beam",
                       loc="left")
        failures = figure.add_axes((0.80, bottom, 0.165, tall / height))
        _draw_failures(failures, rows)
        failures.set_title("missed ◀   invented ▶", loc="left", fontsize=8.5)
    axes.set_xlabel("relative error of the range")
    failures.set_xlabel("share of the beams")
    figure.suptitle("Casting: what a beam costs, and how far off its range is", x=0.01, ha="left",
                    y=1 - 0.12 / height, fontsize=13, weight="bold")
    _draw_key(figure, 1 - 0.52 / height)
    drawing.add_caption(figure, drawing.caption(_words(table), machine), 165)
    return figure
