# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The panels of chart D."""

import drawing
import numpy
from matplotlib import pyplot, ticker

BEAMS = 361 * 360


def _is_thinned(row):
    return (row["work"] == "scan" and row["against"] != "beams"
            and int(row["beams"]) < BEAMS)


def get_seconds(row):
    """The time; that of fewer beams than a default scan's stands for one with all of them."""
    return float(row["ms"]) / 1000 * (BEAMS / int(row["beams"]) if _is_thinned(row) else 1)


def get_megabytes(row):
    """The most memory at any time, megabytes; the least is a page."""
    return max(0.004, float(row["peak MB"]))


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
# Each a row of panels: what is drawn, and which part of it in each column.
TIMES = ("build", "scan", "map")
MEMORY = {"triangles": ("build", STYLES), "threads": ("build", STYLES),
          "beams": ("", ("Exact", "plain grid", "map within 10 mm"))}
MINIMUM_MEMORY = 0.1  # megabytes; what is less is not drawn


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


def label_ends(axes, ends):
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
        thinned = [point for *point, row in zip(x, y, line) if _is_thinned(row)]
        if thinned:
            axes.plot(*zip(*thinned), marker, markersize=3.5, color=color, markerfacecolor="white")
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


def draw_row(panels, lines, name):
    """What is done, against all that grows."""
    value, exponent = (get_megabytes, "memory exponent") if name == "memory" else (
        get_seconds, "time exponent")
    ends = {}
    for axes, against in zip(panels, COLUMNS):
        ends[axes] = _draw_lines(axes, _choose(lines, name, against), value, exponent)
        _style_panel(axes, against, name)
    if name == "memory":
        panels[0].set_ylim(bottom=MINIMUM_MEMORY)
    panels[0].set_ylabel("most memory taken" if name == "memory" else name)
    return ends


def draw_legend(axes):
    """In the panel that stays empty: building does not know of beams."""
    axes.axis("off")
    marks = [pyplot.Line2D([], [], color=color, marker=marker, markersize=4, label=name)
             for name, (color, marker) in STYLES.items()]
    axes.legend(handles=marks, loc="center", fontsize=8.5,
                title="Numbers beside the lines:\nfitted exponents", title_fontsize=8.5)


def draw_figure_7(axes, lines):
    """One thread against two, for every method."""
    names = [name for name in STYLES if ("scan", name, "threads") in lines]
    for place, name in enumerate(names):
        rows = {int(row["threads"]): get_seconds(row) for row in lines["scan", name, "threads"]}
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
