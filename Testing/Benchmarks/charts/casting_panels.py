# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The panels of chart A, each of the rows of one scene."""

import math

import drawing
from matplotlib import colors, pyplot, ticker
from peers_casters import CASTERS

ERRORS = {"median error": 0.5, "99.9% error": 0.001, "worst error": 0.0}

NO_ERROR, MAXIMUM_ERROR = 1e-17, 10.0  # where errors of 0 are drawn, and the end of the axis
NO_FAILURE = 1e-6  # where shares of 0 are drawn
DOMINATED = "#f0f0f0"
FAINT = 0.35
# Group, colour, and how its names begin; LMS3D's methods are all the others.
GROUPS = (
    ("LMS3D", drawing.COLORS[0], ()),
    ("Embree, single precision", drawing.COLORS[1], ("Embree",)),
    ("VTK's locators", drawing.COLORS[2], ("vtk",)),
    ("called from Python", drawing.COLORS[3], tuple(CASTERS)),
)
MARKERS = {"median error": "o", "99.9% error": "|", "worst error": "D"}


def _color(caster):
    return next((color for _, color, starts in GROUPS[1:] if caster.startswith(starts)),
                GROUPS[0][1])


def get_time(row):
    """Nanoseconds."""
    return float(row["ns/beam"])


def _error(row, name="worst error"):
    """Not a number where nothing was hit."""
    return max(NO_ERROR, float(row[name])) if row[name] != "-" else math.nan


def _has_few_beams(row, rows):
    return int(row["beams timed"]) < max(int(other["beams timed"]) for other in rows)


def _fails(row):
    return int(row["misses"]) + int(row["false hits"]) > 0


def _frontier(rows):
    """Those that fail for no beam, while all that are quicker fail for some or err more."""
    chosen = []
    for row in sorted(rows, key=lambda row: (get_time(row), _error(row))):
        if not _fails(row) and (not chosen or _error(row) < _error(chosen[-1])):
            chosen.append(row)
    return chosen


def _draw_frontier(axes, chosen):
    """A staircase; everything beyond it is slower and errs more than something on it."""
    x = [MAXIMUM_ERROR] + [_error(row) for row in chosen for _ in range(2)]
    y = [get_time(row) for row in chosen for _ in range(2)] + [axes.get_ylim()[1]]
    axes.fill_between(x, y, axes.get_ylim()[1], color=DOMINATED, zorder=0, linewidth=0)
    axes.plot(x, y, color="black", linewidth=0.9, zorder=1)


def _format_time(x, _):
    return next(f"{x / unit:g} {name}"
                for unit, name in ((1e6, "ms"), (1e3, "µs"), (1, "ns"), (1e-3, "ps")) if x >= unit)


def _mark_color(row, rows):
    """Faint where it had fewer beams than others; mixed with the panel's grey, not transparent."""
    strength = FAINT if _has_few_beams(row, rows) else 1.0
    return [strength * x + (1 - strength) * y
            for x, y in zip(colors.to_rgb(_color(row["caster"])), colors.to_rgb(DOMINATED))]


def _draw_marks(axes, rows):
    times = [get_time(row) for row in rows]
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(NO_ERROR / 4, MAXIMUM_ERROR)
    axes.set_ylim(min(times) / 2, max(times) * 2)
    axes.grid(False)
    for row in rows:
        color = _mark_color(row, rows)
        errors = [_error(row, name) for name in ERRORS]
        axes.plot([errors[0], errors[-1]], [get_time(row)] * 2, color=color, linewidth=1.2)
        for error, marker in zip(errors, MARKERS.values()):
            axes.plot(error, get_time(row), marker, color=color, clip_on=False,
                      markersize=8 if marker == "|" else 4,
                      markerfacecolor="white" if marker == "o" else color)
    axes.set_xticks([NO_ERROR, *(10.0 ** power for power in range(-15, 1, 3))])
    axes.xaxis.set_major_formatter(lambda x, _: "0" if x == NO_ERROR else f"{x:.0e}")
    axes.xaxis.set_minor_locator(ticker.NullLocator())
    axes.yaxis.set_major_formatter(_format_time)


def _draw_labels(axes, rows, chosen):
    """A name for each, in the order of the times, tied to its mark."""
    for place, row in enumerate(rows):
        height = (place + 0.5) / len(rows)
        here = axes.transAxes.inverted().transform(axes.transData.transform((1, get_time(row))))[1]
        color = _color(row["caster"])
        axes.plot([_error(row), MAXIMUM_ERROR], [get_time(row)] * 2, color=color, linewidth=0.4,
                  alpha=0.6, zorder=0.5)
        axes.plot([1.0, 1.05, 1.07], [here, height, height], transform=axes.transAxes,
                  color=color, linewidth=0.6, clip_on=False)
        is_best = row in chosen
        few = f" ({int(row['beams timed']):,})" if _has_few_beams(row, rows) else ""
        axes.text(1.08, height, row["caster"] + " ★" * is_best + few, va="center", fontsize=8,
                  transform=axes.transAxes, color=color, weight="bold" if is_best else "normal")


def draw_errors(axes, rows):
    """Times and errors, those that nothing else beats in both, and the names."""
    _draw_marks(axes, rows)
    chosen = _frontier(rows)
    _draw_frontier(axes, chosen)
    _draw_labels(axes, rows, chosen)


def draw_failures(axes, rows):
    """The shares of the beams that are missed and invented, in the order of the times."""
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


def draw_key(figure, top):
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
