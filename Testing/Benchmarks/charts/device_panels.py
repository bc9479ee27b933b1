# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The panels of chart F: a row for each effect, a mark for each number."""

import drawing
from matplotlib import ticker

# The label of a panel, its columns with their names, colours and markers, and its scale.
PANELS = (
    ("change of a range, mm", (("median mm", "median", 0, "o"), ("95% mm", "95 %", 1, "D"),
                               ("max mm", "largest", 3, "s")), "log"),
    ("returns lost, %", (("lost %", "", 0, "o"),), "linear"),
    ("map to scene, mm", (("map to scene mean mm", "mean", 0, "o"),
                          ("map to scene 95% mm", "95 %", 1, "D")), "log"),
    ("triangles of the map", (("triangles", "", 0, "o"),), "linear"),
    ("time of the scan, x ideal", (("x ideal", "", 0, "o"),), "log"),
)
SMALLEST = 0.01  # of what a logarithmic axis shows; smaller numbers are left out


def draw_all(axes, table):
    """Draw each panel and name the rows."""
    for panel, (label, columns, scale) in zip(axes, PANELS):
        for column, name, color, marker in columns:
            _draw_column(panel, [float(row[column]) for row in table], scale, name,
                         drawing.COLORS[color], marker)
        panel.set_xscale(scale)
        panel.set_xlabel(label, fontsize=8)
        panel.xaxis.set_major_formatter(lambda x, _: f"{x:,.0f}" if x >= 1 else f"{x:g}")
        panel.xaxis.set_minor_formatter(ticker.NullFormatter())
        panel.tick_params(labelsize=7)
        if len(columns) > 1:
            panel.legend(fontsize=7, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncol=len(columns),
                         handletextpad=0.1, columnspacing=0.6, borderpad=0.1)
    axes[0].set_yticks(range(len(table)), [_name(row) for row in table], fontsize=7)
    axes[0].set_ylim(len(table) - 0.4, -0.6)


def _name(row):
    return row["effect"] if row["value"] == "-" else f"{row['effect']}, {row['value']}"


def _draw_column(panel, values, scale, name, color, marker):
    shown = [(value, place) for place, value in enumerate(values)
             if scale == "linear" or value >= SMALLEST]
    panel.plot(*zip(*shown), marker, color=color, markersize=5, label=name)
