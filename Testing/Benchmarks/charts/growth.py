# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Chart D: how time and memory grow with triangles, beams and threads."""

import pathlib
import subprocess
import tempfile

import drawing
import growth_panels
import numpy
import tables
from matplotlib import pyplot
from places import BENCHMARK

LETTER = "D"
NAME = "growth"
SUMMARY = "time and memory of building, scanning and mapping against triangles, beams and threads"


def measure(quick, csv_file):
    """Run the benchmark, and fit what it measured."""
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "table.csv"
        command = [BENCHMARK, "growth", "--csv", table] + ["--quick"] * quick
        subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
        rows = tables.read(table)
    for row in rows:
        row.update({"time exponent": "-", "memory exponent": "-"})
    for line in _lines(rows).values():
        for row in line:
            row.update({"time exponent": _fit(line, growth_panels.get_seconds),
                        "memory exponent": _fit(line, growth_panels.get_megabytes)})
    tables.write(csv_file, rows)


def _lines(table):
    """The rows that were measured, by what was done, with what, and what grew."""
    lines = {}
    for row in table:
        if row["end"] == "done":
            key = row["work"], row["contender"], row["against"]
            lines.setdefault(key, []).append(row)
    return lines


def _fit(line, value):
    """The slope over the upper half of what grew, in logarithms; of two points at least."""
    points = numpy.log([(float(row[row["against"]]), value(row)) for row in line])
    lower = (points[:, 0] < points[[0, -1], 0].mean() - 0.01).sum()
    points = points[min(lower, max(0, len(points) - 2)):]
    if len(points) < 2:
        return "-"
    # Adding 0 makes a 0 of -0.
    return f"{round(numpy.polyfit(*points.T, 1)[0], 2) + 0:.2f}"


def _words(table):
    """Return the caption's words about this table."""
    hills = next(row["triangles"] for row in table
                 if row["work"] == "build" and row["against"] == "threads")
    most = max(int(row["beams"]) for row in table
               if row["work"] == "map" and row["against"] == "beams" and row["end"] == "done")
    words = ("Triangles: hills, seen by the default scan of 129,960 beams. Beams: the room. "
             f"Threads: that scan of the room, its maps, and building of {int(hills):,} triangles, "
             "each number of threads in turn with the others. Building is what the filter makes of "
             "a scene before its first beam. Memory is beside the input: of building, and of scans "
             "and maps where beams grow. Exponents are of the upper half of each line. Scans that "
             "take long have fewer beams, and their time is scaled: hollow marks. Maps end at "
             f"{most:,} beams: ten times as many take ten times the memory, beside the scan.")
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
    for number, name in enumerate((*growth_panels.TIMES, "memory")):
        panels = []
        for column in range(len(growth_panels.COLUMNS)):
            panels.append(figure.add_subplot(grid[number, column],
                                             sharex=top[column] if top else None,
                                             sharey=panels[0] if panels else None))
        top = top or panels
        ends.update(growth_panels.draw_row(panels, lines, name))
    for axes, against in zip(top, growth_panels.COLUMNS):
        axes.set_title(f"against {against}", loc="left")
    growth_panels.draw_legend(top[1])
    for axes, labels in ends.items():
        if labels:
            growth_panels.label_ends(axes, labels)
    growth_panels.draw_figure_7(figure.add_axes((0.145, 0.105, 0.80, 0.135)), lines)
    figure.suptitle("Growth: time and memory against triangles, beams and threads", x=0.01,
                    ha="left", y=0.99, fontsize=13, weight="bold")
    drawing.add_caption(figure, drawing.caption(
        _words(table), machine, "1 thread where no other number stands"), 165)
    return figure
