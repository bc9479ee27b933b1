# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Chart G: how one map of many scans grows with the poses of a journey."""

import subprocess

import drawing
import fusion_peers
import fusion_tables
import tables
from matplotlib import pyplot
from places import BENCHMARK

LETTER = "G"
NAME = "fusion"
SUMMARY = "time, triangles and completeness of one map of many scans against the poses of a journey"

# The time of each step of the pipeline: its column, its name, its colour.
STEPS = (("fusion ms", "fusion", drawing.COLORS[0]), ("map ms", "map", drawing.COLORS[1]),
         ("scan ms", "scan", drawing.COLORS[2]))
# Each number of threads has a kind of line and a mark.
THREADS = {"1": ("-", "o"), "2": (":", "s")}
ONE_MAP, ALL_MAPS = "one map", "all local maps"


def measure(quick, csv_file):
    """Run the benchmark, and give Open3D the first poses."""
    command = [BENCHMARK, "fusion", "--csv", csv_file] + ["--quick"] * quick
    subprocess.run(command, stdout=subprocess.DEVNULL, check=True)
    fusion_peers.measure(quick, csv_file.with_name(fusion_tables.FILE))


def draw(table, machine):
    """Three panels against the number of poses: time, triangles and completeness."""
    figure, (times, triangles, complete) = pyplot.subplots(1, 3, figsize=(9.2, 3.6))
    _draw_times(times, table)
    rows = tables.select(table, threads="1")
    _draw_both(triangles, rows, ("triangles", "triangles of all maps"))
    triangles.set_title("Triangles")
    triangles.yaxis.set_major_formatter(lambda value, _: f"{value:,.0f}")
    _draw_both(complete, rows, ("complete %", "all maps complete %"))
    complete.set_title("Visible scene in the map, %")
    for axes in (times, triangles, complete):
        axes.set_xlabel("poses")
    for axes in (triangles, complete):
        axes.legend(fontsize=8)
    times.set_ylim(0, 1.35 * times.get_ylim()[1])
    times.legend(fontsize=7, ncol=2, loc="upper center", columnspacing=1, handlelength=1.6)
    triangles.set_ylim(bottom=0)
    figure.suptitle("How one map of many scans grows", x=0.01, ha="left", fontsize=13, weight="bold")
    figure.subplots_adjust(left=0.06, right=0.985, top=0.8, bottom=0.25, wspace=0.3)
    drawing.add_caption(figure, drawing.caption(
        "A journey through the building, 361 x 360 beams a pose, maps within 1 cm. Times are the mean "
        "over the poses since the mark before.", machine, "1 and 2 threads"), 165)
    return figure


def _draw_times(axes, table):
    for threads, (line, mark) in THREADS.items():
        rows = tables.select(table, threads=threads)
        for column, name, color in STEPS:
            axes.plot(*_columns(rows, column), line, marker=mark, markersize=3.5, color=color,
                      label=f"{name}, {threads} thread{'s' * (threads != '1')}")
    axes.set_title("Time for each pose, ms")


def _draw_both(axes, rows, columns):
    for column, name, color in zip(columns, (ONE_MAP, ALL_MAPS), drawing.COLORS):
        axes.plot(*_columns(rows, column), "-o", markersize=3.5, color=color, label=name)


def _columns(rows, column):
    """The poses, and a column."""
    return [int(row["poses"]) for row in rows], [float(row[column]) for row in rows]
