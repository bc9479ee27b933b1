# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Chart B: what maps cost in time and triangles, and how far they are from the scene."""

import pathlib
import statistics
import subprocess
import tempfile

# This first: it adds the folder of the two below.
import drawing
import compare_map_peers
import compare_peers
from matplotlib import lines, patheffects, pyplot

LETTER = "B"
NAME = "mapping"
SUMMARY = "time and triangles of maps against their error, without and with noise"

# A map's name without its depth, what the picture calls it, and its colour and marker.
METHODS = (
    ("LMS3D map", "bounded map", drawing.COLORS[0], "o"),
    ("LMS3D grid", "plain grid", drawing.COLORS[4], "s"),
    ("LMS3D grid + vtkQuadricDecimation", "grid + vtkQuadricDecimation", drawing.COLORS[1], "^"),
    ("LMS3D grid + vtkDecimatePro", "grid + vtkDecimatePro", drawing.COLORS[5], "v"),
    ("vtkSurfaceReconstructionFilter", "vtkSurfaceReconstructionFilter", drawing.COLORS[2], "P"),
    ("Open3D Poisson", "Open3D Poisson", drawing.COLORS[3], "X"),
)
DASHED = (0, (3, 2))
HALO = patheffects.withStroke(linewidth=2, foreground="white")
# What stands beside the scene's own triangles: the label, the map, its noise and its bound.
COUNTED = (
    ("map within 10 mm", "LMS3D map", "0", "10"),
    ("with noise, 20 mm", "LMS3D map", "5", "20"),
    ("plain grid", "LMS3D grid", "0", "0"),
)
SCENES = ("room", "teapot", "terrain1e5")
SCENES_WHEN_QUICK = ("room", "teapot")


def measure(quick, csv_file):
    """Run the benchmark of VTK's maps and ours, and give Open3D the same scans."""
    python, version = (None, None) if quick else _install()
    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for scene in SCENES_WHEN_QUICK if quick else SCENES:
            print(f"   {scene}", flush=True)
            some = [{**row, "version": "-"} for row in _run_benchmark(scene, quick, folder)]
            rows += some
            if version:
                same = {key: some[0][key] for key in ("scene triangles", "hit triangles")}
                same["version"] = version
                rows += _map_with_peers(scene, {**dict.fromkeys(some[0], "-"), **same}, python,
                                        folder)
    drawing.write_table(csv_file, rows)


def _install():
    """The Python that has Open3D, and what that is; None where it cannot be installed."""
    try:
        python = compare_peers.install()
        names = [x for x in compare_peers.versions(python) if x.startswith("open3d")]
    except (OSError, subprocess.CalledProcessError) as problem:
        print(f"Open3D is left out: {problem}")
        return None, None
    return python, next(iter(names), None)


def _run_benchmark(scene, quick, folder):
    table = folder / "map.csv"
    command = [drawing.BENCHMARK, "map", "--scenes", scene, "--csv", table] + ["--quick"] * quick
    subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
    return drawing.read_table(table)


def _map_with_peers(scene, same, python, folder):
    """Rows with all columns; of those that no peer fills, what is the same in all of them."""
    surface, exact, sensor = compare_map_peers.make_scan(scene)
    noise = compare_map_peers.NOISE
    rows = []
    for scan, sigma in ((exact, 0), (compare_map_peers.add_noise(exact, sensor), noise)):
        maps = compare_map_peers.map_with_peers(scan, sensor, python, folder)
        for cells in compare_map_peers.describe_maps(scene, sigma, maps, surface, scan):
            rows.append({**same, **dict(zip(compare_map_peers.COLUMNS, cells))})
    return rows


def _method(row):
    return row["map"].split(" depth ")[0]


def _select(table, **wanted):
    """Rows with a map whose error is known, and with such values."""
    return [row for row in table if row["both mean mm"] != "-"
            and all(row[key.replace("_", " ")] == value for key, value in wanted.items())]


def _draw_series(axes, rows, key, style):
    """A method's maps of one scan; joined against triangles, since times go to and fro."""
    _, _, color, marker = style
    noise = rows[0]["noise mm"]
    rows = sorted(rows, key=lambda row: int(row["triangles"]))
    line = "none" if key == "ms" else "-" if noise == "0" else DASHED
    values = [float(row[key]) for row in rows]
    errors = [(float(row["to scene mean mm"]), float(row["to map mean mm"])) for row in rows]
    axes.vlines(values, *zip(*errors), color=color, linewidth=1, alpha=0.5)
    axes.plot(values, [float(row["both mean mm"]) for row in rows], color=color, linewidth=1.2,
              linestyle=line, marker=marker, markersize=6,
              markerfacecolor=_fill(color, noise), markeredgewidth=1.2)


def _fill(color, noise):
    return color if noise == "0" else "white"


# Where a name stands: beside the marker, or below the thin line.
LEFT = {"xytext": (-7, 0), "ha": "right", "va": "center"}, statistics.mean
BELOW = {"xytext": (0, -2), "ha": "center", "va": "top"}, min
# The noise and bound of the maps that are named.
NAMED = (("0", "50", LEFT), ("0", "1", BELOW), ("5", "10", BELOW))


def _name_bounds(axes, table):
    """Name some maps by their bounds, against triangles, which are the same on any machine."""
    for noise, bound, (place, choose) in NAMED:
        row, = _select(table, map="LMS3D map", noise_mm=noise, bound_mm=bound)
        error = choose((float(row["to scene mean mm"]), float(row["to map mean mm"])))
        axes.annotate(f"{bound} mm", (int(row["triangles"]), error), textcoords="offset points",
                      fontsize=7, color=METHODS[0][2], path_effects=[HALO], **place)


def _draw_panel(axes, table, key):
    for style in reversed(METHODS):
        for noise in dict.fromkeys(row["noise mm"] for row in table):
            rows = [row for row in _select(table, noise_mm=noise) if _method(row) == style[0]]
            if rows:
                _draw_series(axes, rows, key, style)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.margins(x=0.06, y=0.08)
    axes.xaxis.set_major_formatter(_format)
    axes.yaxis.set_major_formatter(_format)


def _format(x, _=None):
    return f"{x:,.0f}" if x >= 1 else f"{x:g}"


def _draw_counts(axes, table):
    """The triangles of the scene above those of its maps."""
    counts = [("the scene itself", table[0]["scene triangles"], "#222222", "D", "0"),
              ("of these, hit", table[0]["hit triangles"], "#222222", "D", "0")]
    for label, name, noise, bound in COUNTED:
        row, = _select(table, map=name, noise_mm=noise, bound_mm=bound)
        color, marker = next(style[2:] for style in METHODS if style[0] == name)
        counts.append((label, row["triangles"], color, marker, noise))
    for place, (_, count, color, marker, noise) in enumerate(counts):
        axes.plot(int(count), place, marker, color=color, markersize=6, markeredgewidth=1.2,
                  markerfacecolor=_fill(color, noise))
        axes.annotate(f"{int(count):,}", (int(count), place), (7, 0), va="center", fontsize=8,
                      textcoords="offset points")
    axes.set_yticks(range(len(counts)), [label for label, *_ in counts])
    axes.set_ylim(len(counts) - 0.4, -0.6)
    axes.set_xscale("log")
    axes.set_xlim(100, 3e6)
    axes.set_xticks((1e3, 1e5))
    axes.xaxis.set_major_formatter(_format)


def _draw_scene(table, time, triangles, counts):
    name = drawing.name_scene(table[0]["scene"])
    _draw_panel(time, table, "ms")
    _draw_panel(triangles, table, "triangles")
    time.set_title(name, loc="left")
    time.set_ylabel("mean error, mm")
    _draw_counts(counts, table)
    counts.set_title(f"triangles: {name}", loc="left")


def _add_legend(figure, table, top):
    drawn = {_method(row) for row in table}
    handles = [lines.Line2D([], [], color=color, marker=marker, label=label, linewidth=1.2)
               for name, label, color, marker in METHODS if name in drawn]
    handles += [lines.Line2D([], [], color="#444444", marker="o", label="ideal ranges"),
                lines.Line2D([], [], color="#444444", marker="o", markerfacecolor="white",
                             linestyle=DASHED, label="5 mm of noise")]
    figure.legend(handles=handles, ncol=4, loc="upper left", bbox_to_anchor=(0.0, top), fontsize=8)


def _words(table):
    """What the caption says of this table."""
    words = (
        "The same scans of 361 x 360 beams for all. Mean error: the mean of map to scene and "
        "visible scene to map, the ends of the upright lines. Bounded maps: within 1, 5, "
        "10, 20 and 50 mm, as named at the top right. Decimation gets as many triangles as those "
        "within 1 (with noise 10), 10 (20) and 50 mm have, vtkDecimatePro as the second. Times: "
        "the best of several runs, of what takes seconds the only one.")
    others = {row["version"] for row in _select(table)} - {"-"}
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
        _draw_scene([row for row in table if row["scene"] == name], *panels, counts)
    _name_bounds(above[0][1], [row for row in table if row["scene"] == names[0]])
    above[-1][0].set_xlabel("time from the scan to the map, ms")
    above[-1][1].set_xlabel("triangles of the map")
    figure.align_ylabels(above[:, 0])
    figure.suptitle("What a map costs, and how far it is from the scene", x=0.01, ha="left",
                    y=1 - 0.1 / height, fontsize=13, weight="bold")
    _add_legend(figure, table, 1 - 0.3 / height)
    drawing.add_caption(figure, drawing.caption(_words(table), machine), 165)
    return figure
