# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Chart C: where methods of ray casting fail, as a heat map."""

import subprocess

import drawing
import numpy
from matplotlib import colors, pyplot
from places import BENCHMARK

LETTER = "C"
NAME = "stability"
SUMMARY = "the share of beams that each method misses, invents or measures wrongly"

GROUPS = (
    ("LMS3D", 5),
    ("paper's sum\nof angles", 4),
    ("Embree,\nsingle precision", 3),
    ("VTK's locators,\ntolerance 1e-9 m or 0", 6),
)
NO_FAILURE = "#d6e6f4"
MINIMUM, MAXIMUM = 0.03, 100.0  # percent
UNITS = {"grazing angle": "rad", "offset": "m", "scale": "m", "denormals": "m",
         "far targets": "radii", "nested shells": "radii", "slivers": ": 1"}


def measure(quick, csv_file):
    """Run the suite."""
    command = [BENCHMARK, "stability", "--csv", csv_file] + ["--quick"] * quick
    subprocess.run(command, stdout=subprocess.DEVNULL, check=True)


def _unique(table, *keys):
    return list(dict.fromkeys(tuple(row[key] for key in keys) for row in table))


def _shares(table):
    """Percent of the beams, by situation and method; not a number where a method did not end."""
    rows = {key: i for i, key in enumerate(_unique(table, "situation", "parameter"))}
    columns = {key: i for i, (key,) in enumerate(_unique(table, "method"))}
    shares = numpy.full((len(rows), len(columns)), numpy.nan)
    for row in table:
        if row["end"] == "done":
            failures = sum(int(row[kind]) for kind in ("missed", "false", "wrong"))
            place = rows[row["situation"], row["parameter"]], columns[row["method"]]
            shares[place] = 100 * failures / int(row["beams"])
    return shares


def _format(share):
    if share == 0:
        return ""
    if share < 0.1:
        return "<.1"
    return f"{share:.1f}" if share < 9.95 else f"{share:.0f}"


def _draw_cells(axes, shares):
    scale = colors.LogNorm(MINIMUM, MAXIMUM)
    palette = pyplot.get_cmap("YlOrBr").copy()
    palette.set_bad(NO_FAILURE)
    image = axes.pcolormesh(numpy.ma.masked_less_equal(shares, 0), cmap=palette, norm=scale,
                            edgecolors="white", linewidth=0.5)
    for (row, column), share in numpy.ndenumerate(shares):
        if numpy.isnan(share):
            axes.add_patch(pyplot.Rectangle((column, row), 1, 1, color="black"))
            axes.text(column + 0.5, row + 0.52, "×", ha="center", va="center", color="white")
        else:
            axes.text(column + 0.5, row + 0.52, _format(share), ha="center", va="center",
                      fontsize=7, color="white" if share > 12 else "black")
    return image


def _label_rows(axes, situations):
    start = 0
    names = [name for name, _ in situations]
    for name in dict.fromkeys(names):
        count = names.count(name)
        axes.text(-1.9, start + count / 2, name, ha="right", va="center")
        axes.axhline(start, color="#444444", linewidth=0.8, xmin=-0.27, clip_on=False)
        start += count
    axes.set_yticks(numpy.arange(len(situations)) + 0.5)
    axes.set_yticklabels([f"{parameter} {UNITS.get(name, '')}".rstrip()
                          for name, parameter in situations], fontsize=7)


def _label_columns(axes, methods):
    axes.xaxis.tick_top()
    axes.set_xticks(numpy.arange(len(methods)) + 0.5)
    axes.set_xticklabels(methods, rotation=55, ha="left", rotation_mode="anchor", fontsize=8)
    start = 0
    for name, count in GROUPS:
        axes.axvline(start, color="#444444", linewidth=1.2)
        axes.text(start + count / 2 + 1.6, -6.6, name, ha="center", va="bottom", weight="bold",
                  fontsize=8)
        start += count


def draw(table, machine):
    """The heat map: a row for each situation, a column for each method."""
    situations = _unique(table, "situation", "parameter")
    methods = [method for method, in _unique(table, "method")]
    figure = pyplot.figure(figsize=(9.2, 13.2))
    axes = figure.add_axes((0.25, 0.075, 0.665, 0.765))
    axes.grid(False)
    image = _draw_cells(axes, _shares(table))
    axes.set_ylim(len(situations), 0)
    axes.tick_params(length=0)
    for spine in axes.spines.values():
        spine.set_visible(False)
    _label_rows(axes, situations)
    _label_columns(axes, methods)
    figure.suptitle("Where ray casting fails: beams missed, invented or measured wrongly",
                    x=0.01, ha="left", y=0.99, fontsize=13, weight="bold")
    bar = figure.colorbar(image, cax=figure.add_axes((0.45, 0.060, 0.465, 0.007)),
                          orientation="horizontal", format="%g", ticks=(0.1, 1, 10, 100))
    bar.ax.tick_params(labelsize=7, length=2)
    figure.text(0.25, 0.059, "blue: none     percent of the beams:", fontsize=7)
    drawing.add_caption(figure, drawing.caption(
        f"{int(table[0]['beams']):,} beams in each cell, the same in each run, held against exact "
        "arithmetic; wrong is a range that is off by more than a millionth of it; × is a method "
        "that crashes or does not end.", machine), 165)
    return figure
