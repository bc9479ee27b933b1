# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Chart D: how time and memory grow with triangles, beams and threads."""

import pathlib
import subprocess
import tempfile

import drawing
import numpy
from matplotlib import pyplot, ticker

LETTER = "D"
NAME = "growth"
SUMMARY = "time and memory of building, scanning and mapping against triangles, beams and threads"

BEAMS = 361 * 360


def measure(quick, csv_file):
    """Run the benchmark, and fit what it measured."""
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "table.csv"
        command = [drawing.BENCHMARK, "growth", "--csv", table] + ["--quick"] * quick
        subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
        rows = drawing.read_table(table)
    for row in rows:
        row.update({"time exponent": "-", "memory exponent": "-"})
    for line in _lines(rows).values():
        for row in line:
            row.update({"time exponent": _fit(line, _seconds),
                        "memory exponent": _fit(line, _peak)})
    drawing.write_table(csv_file, rows)


def _lines(table):
    """The rows that were measured, by what was done, with what, and what grew."""
    lines = {}
    for row in table:
        if row["end"] == "done":
            key = row["work"], row["contender"], row["against"]
            lines.setdefault(key, []).append(row)
    return lines


def _seconds(row):
    """The time; that of fewer beams than a default scan's stands for one with all of them."""
    is_thinned = row["work"] == "scan" and row["against"] != "beams"
    return float(row["ms"]) / 1000 * (BEAMS / int(row["beams"]) if is_thinned else 1)


def _peak(row):
    """The most memory that was taken at any time, megabytes, of which a page is the least."""
    return max(0.004, float(row["peak MB"]))


def _fit(line, value):
    """The slope over the upper half of what grew, in logarithms; of two points at least."""
    points = numpy.log([(float(row[row["against"]]), value(row)) for row in line])
    lower = (points[:, 0] < points[[0, -1], 0].mean() - 0.01).sum()
    points = points[min(lower, max(0, len(points) - 2)):]
    if len(points) < 2:
        return "-"
    # Adding 0 makes a 0 of -0.
    return f"{round(numpy.polyfit(*points.T, 1)[0], 2) + 0:.2f}"


# A colour and a mark for each, since lines may lie on one another.
STYLES = {
    "Exact": (drawing.COLORS[0], "o"),
    "Fast": (drawing.COLORS[1], "s"),
    "StaticCellLocator": (drawing.COLORS[2], "^"),
    "MollerTrumbore": (drawing.COLORS[3], "D"),
    "AngleSum": (drawing.COLORS[4], "v"),
    "plain grid": (drawing.COLORS[5], "P"),
    "map within 10 mm": ("#000000", "X"),
}
COLUMNS = ("triangles", "beams", "threads")
# Each a row of panels: what is drawn, and what of it by the column.
TIMES = ("build", "scan", "map")
MEMORY = {"triangles": ("build", STYLES), "threads": ("build", STYLES),
          "beams": ("", ("Exact", "plain grid", "map within 10 mm"))}
LEAST_MEMORY = 0.1  # megabytes; what is less is not drawn


def _format_seconds(x, _):
    return next(f"{x * factor:g} {unit}" for limit, factor, unit in (
        (0.999e-3, 1e6, "µs"), (0.999, 1e3, "ms"), (float("inf"), 1, "s")) if x < limit)


def _format_short(seconds):
    return next(f"{seconds * factor:.3g} {unit}" for limit, factor, unit in (
        (1e-3, 1e6, "µs"), (1.0, 1e3, "ms"), (float("inf"), 1, "s")) if seconds < limit)


def _format_megabytes(x, _):
    return f"{x / 1000:g} GB" if x >= 1000 else f"{x:g} MB"


def _spread(heights, least):
    """Heights in the order given, moved apart by at least so much."""
    order = numpy.argsort(heights)
    moved = numpy.array(heights, float)
    for _ in range(50):
        for low, high in zip(order, order[1:]):
            lack = least - (moved[high] - moved[low])
            if lack > 0:
                moved[low] -= lack / 2
                moved[high] += lack / 2
    return moved


def _label_ends(axes, ends):
    """The exponents beside the ends of the lines, apart where several end at the same place."""
    places = axes.transAxes.inverted().transform(
        [axes.transData.transform(point) for _, point, _ in ends])
    for x in dict.fromkeys(places[:, 0]):
        here = numpy.flatnonzero(places[:, 0] == x)
        for i, height in zip(here, _spread(places[here, 1], 0.095)):
            text, point, color = ends[i]
            axes.annotate(text, point, (x + 16 / axes.bbox.width, height),
                          textcoords="axes fraction", color=color, fontsize=8, va="center",
                          annotation_clip=False,
                          bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5},
                          arrowprops={"arrowstyle": "-", "color": color, "linewidth": 0.5,
                                      "shrinkA": 0, "shrinkB": 3})


def _draw_lines(axes, lines, value, exponent):
    ends = []
    for line in lines:
        color, marker = STYLES[line[0]["contender"]]
        x = [float(row[row["against"]]) for row in line]
        y = [value(row) for row in line]
        axes.plot(x, y, marker=marker, markersize=3.5, color=color, linewidth=1.3)
        if line[-1][exponent] != "-":
            ends.append((line[-1][exponent], (x[-1], y[-1]), color))
    return ends


def _style_panel(axes, against, name):
    axes.set_xscale("log", base=2 if against == "threads" else 10)
    axes.set_yscale("log")
    axes.yaxis.set_major_formatter(_format_megabytes if name == "memory" else _format_seconds)
    axes.yaxis.set_minor_locator(ticker.NullLocator())
    axes.tick_params(labelsize=8)
    if against == "threads":
        axes.xaxis.set_major_formatter(lambda x, _: f"{x:g}")
        axes.margins(x=0.2)


def _choose(lines, name, against):
    """The lines of a panel."""
    work, contenders = MEMORY[against] if name == "memory" else (name, STYLES)
    return [line for (done, contender, grown), line in lines.items()
            if work in ("", done) and contender in contenders and grown == against]


def _draw_row(panels, lines, name):
    """What is done, against all that grows."""
    value, exponent = (_peak, "memory exponent") if name == "memory" else (
        _seconds, "time exponent")
    ends = {}
    for axes, against in zip(panels, COLUMNS):
        ends[axes] = _draw_lines(axes, _choose(lines, name, against), value, exponent)
        _style_panel(axes, against, name)
    if name == "memory":
        panels[0].set_ylim(bottom=LEAST_MEMORY)
    panels[0].set_ylabel("most memory taken" if name == "memory" else name)
    return ends


def _draw_legend(axes):
    """In the panel that stays empty: building does not know of beams."""
    axes.axis("off")
    marks = [pyplot.Line2D([], [], color=color, marker=marker, markersize=4, label=name)
             for name, (color, marker) in STYLES.items()]
    axes.legend(handles=marks, loc="center", fontsize=8.5,
                title="Numbers beside the lines:\nfitted exponents", title_fontsize=8.5)


def _draw_figure_7(axes, lines):
    """One thread against two, for every method."""
    names = [name for name in STYLES if ("scan", name, "threads") in lines]
    for place, name in enumerate(names):
        rows = {int(row["threads"]): _seconds(row) for row in lines["scan", name, "threads"]}
        color = STYLES[name][0]
        axes.plot([rows[2], rows[1]], [place] * 2, color=color, linewidth=2)
        axes.plot(rows[1], place, "o", color=color, markersize=7)
        axes.plot(rows[2], place, "o", color=color, markersize=7, markerfacecolor="white")
        axes.annotate(f"{_format_short(rows[1])} → {_format_short(rows[2])}, "
                      f"{rows[1] / rows[2]:.2f} times as fast", (max(rows[1], rows[2]), place),
                      (9, 0), textcoords="offset points", va="center", fontsize=8, color=color)
    axes.set_xscale("log")
    axes.set_xlim(right=axes.get_xlim()[1] * 30)
    axes.set_ylim(len(names) - 0.5, -0.5)
    axes.set_yticks(range(len(names)), names)
    axes.xaxis.set_major_formatter(_format_seconds)
    axes.grid(axis="y", visible=False)
    axes.set_title("The paper's Figure 7 for every method: a scan of the room, 804 triangles, "
                   "with one thread ● and with two ○", loc="left")


def _words(table):
    """What the caption says of this table."""
    hills = next(row["triangles"] for row in table
                 if row["work"] == "build" and row["against"] == "threads")
    words = ("Triangles: hills, seen by the default scan of 129,960 beams. Beams: the room. "
             f"Threads: that scan of the room, its maps, and building of {int(hills):,} triangles. "
             "Building is a first update with one beam. Memory is beside the input: of building, "
             "and of scans and maps where beams grow. Exponents are of the upper half of each "
             "line. Scans that take long have fewer beams, and their time is scaled.")
    for end in dict.fromkeys(row["end"] for row in table if row["end"] != "done"):
        left = [row for row in table if row["end"] == end]
        words += f" Left out ({end}): {_list(left)}."
    return words


def _list(left):
    """The contenders, each from the least that was left out on."""
    least = {}
    for row in left:
        key = row["contender"], row["against"]
        least[key] = min(least.get(key, 10 ** 12), int(row[row["against"]]))
    return ", ".join(f"{contender} from {count:,} {against} on"
                     for (contender, against), count in least.items())


def draw(table, machine):
    """Rows for what is done, columns for what grows, and the paper's Figure 7."""
    lines = _lines(table)
    figure = pyplot.figure(figsize=(9.2, 12.6))
    grid = figure.add_gridspec(4, 3, width_ratios=(1.25, 1.25, 0.5), wspace=0.47, hspace=0.22,
                               left=0.095, right=0.945, top=0.935, bottom=0.30)
    ends = {}
    top = None
    for number, name in enumerate((*TIMES, "memory")):
        panels = []
        for column in range(len(COLUMNS)):
            panels.append(figure.add_subplot(grid[number, column],
                                             sharex=top[column] if top else None,
                                             sharey=panels[0] if panels else None))
        top = top or panels
        ends.update(_draw_row(panels, lines, name))
    for axes, against in zip(top, COLUMNS):
        axes.set_title(f"against {against}", loc="left")
    _draw_legend(top[1])
    for axes, labels in ends.items():
        if labels:
            _label_ends(axes, labels)
    _draw_figure_7(figure.add_axes((0.145, 0.105, 0.80, 0.135)), lines)
    figure.suptitle("Growth: time and memory against triangles, beams and threads", x=0.01,
                    ha="left", y=0.99, fontsize=13, weight="bold")
    drawing.add_caption(figure, drawing.caption(
        _words(table), machine, "1 thread where no other number stands"), 165)
    return figure
