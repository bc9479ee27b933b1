# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The panels of chart B, each of the rows of one scene."""

import statistics

import drawing
import tables
from matplotlib import lines, patheffects

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


def _method(row):
    return row["map"].split(" depth ")[0]


def select(table, **wanted):
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


def name_bounds(axes, table):
    """Name some maps by their bounds, against triangles, which are the same on any machine."""
    for noise, bound, (place, choose) in NAMED:
        row, = select(table, map="LMS3D map", noise_mm=noise, bound_mm=bound)
        error = choose((float(row["to scene mean mm"]), float(row["to map mean mm"])))
        axes.annotate(f"{bound} mm", (int(row["triangles"]), error), textcoords="offset points",
                      fontsize=7, color=METHODS[0][2], path_effects=[HALO], **place)


def _draw_panel(axes, table, key):
    for style in reversed(METHODS):
        for noise in dict.fromkeys(row["noise mm"] for row in table):
            rows = [row for row in select(table, noise_mm=noise) if _method(row) == style[0]]
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
    """The triangles of the scene above the triangles of its maps."""
    counts = [("the scene itself", table[0]["scene triangles"], "#222222", "D", "0"),
              ("of these, hit", table[0]["hit triangles"], "#222222", "D", "0")]
    for label, name, noise, bound in COUNTED:
        row, = select(table, map=name, noise_mm=noise, bound_mm=bound)
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


def draw_scene(table, time, triangles, counts):
    """Time and triangles against error, and the scene's own triangles."""
    name = tables.name_scene(table[0]["scene"])
    _draw_panel(time, table, "ms")
    _draw_panel(triangles, table, "triangles")
    time.set_title(name, loc="left")
    time.set_ylabel("mean error, mm")
    _draw_counts(counts, table)
    counts.set_title(f"triangles: {name}", loc="left")


def add_legend(figure, table, top):
    """The methods that were drawn, and the kinds of lines."""
    drawn = {_method(row) for row in table}
    handles = [lines.Line2D([], [], color=color, marker=marker, label=label, linewidth=1.2)
               for name, label, color, marker in METHODS if name in drawn]
    handles += [lines.Line2D([], [], color="#444444", marker="o", label="ideal ranges"),
                lines.Line2D([], [], color="#444444", marker="o", markerfacecolor="white",
                             linestyle=DASHED, label="5 mm of noise")]
    figure.legend(handles=handles, ncol=4, loc="upper left", bbox_to_anchor=(0.0, top), fontsize=8)
