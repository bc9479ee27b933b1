# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Chart E: what the steps between the beams and the bound of the map cost in error."""

import dataclasses

import drawing
import tables
from lms3d.sampling import measure as measure_sample
from lms3d.sampling import steps_down_to
from lms3d.scene import read_scene
from lms3d.simulation import Simulation
from matplotlib import lines, pyplot
from places import DATA

LETTER = "E"
NAME = "sampling"
SUMMARY = "error, completeness and triangles of the map against the steps between the beams"


@dataclasses.dataclass(frozen=True)
class Subject:
    """A scene, where its sensor is, and what of it counts as right, metres."""

    name: str
    position: tuple
    tolerance: float
    bounds: tuple
    depth_step: float


SUBJECTS = (
    Subject("room", (0.3, -0.2, 1.0), 0.01, (0.0, 0.001, 0.01, 0.05), 0.1),
    Subject("teapot", (0.10, -0.33, 0.30), 0.001, (0.0, 0.0001, 0.001, 0.005), 0.02),
)
MINIMUM_ERROR = 0.01  # millimetres; what is less is not drawn
SAMPLES, SAMPLES_WHEN_QUICK = 200_000, 20_000


def measure(quick, csv_file):
    """Scan, map and compare with every step and bound."""
    rows = []
    for subject in SUBJECTS:
        print(f"   {subject.name}", flush=True)
        simulation = Simulation(read_scene(DATA / f"{subject.name}.wrl"))
        simulation.sensor.SetPosition(subject.position)
        simulation.reconstruction.SetDepthStep(subject.depth_step)
        for step in steps_down_to(1.0 if quick else 0.25):
            for bound in subject.bounds:
                rows.append(_row(subject, measure_sample(
                    simulation, step, bound, subject.tolerance,
                    SAMPLES_WHEN_QUICK if quick else SAMPLES)))
    tables.write(csv_file, rows)


def _row(subject, sample):
    comparison = sample.comparison
    return {
        "scene": subject.name, "step deg": f"{sample.step:g}",
        "bound mm": f"{1000 * sample.maximum_error:g}",
        "tolerance mm": f"{1000 * subject.tolerance:g}",
        "beams": sample.alpha_resolution * sample.beta_resolution, "returns": sample.returns,
        "triangles": comparison.triangles,
        "correct": f"{comparison.correctness:.4f}", "complete": f"{comparison.completeness:.4f}",
        "map to scene mean mm": f"{1000 * comparison.map_to_scene.mean:.4g}",
        "map to scene 95% mm": f"{1000 * comparison.map_to_scene.percentile_95:.4g}",
        "scene to map mean mm": f"{1000 * comparison.scene_to_map.mean:.4g}",
        "scene to map 95% mm": f"{1000 * comparison.scene_to_map.percentile_95:.4g}",
    }


# Each a row of panels: its label, the columns of the whole and of the dashed line, their names, and
# the scale.
PANELS = (
    ("error, 95 % of the area, mm", ("scene to map 95% mm", "map to scene 95% mm"),
     ("visible scene to map", "map to scene"), "log"),
    ("within the tolerance, %", ("complete", "correct"),
     ("of the visible scene", "of the map"), "linear"),
    ("triangles of the map", ("triangles",), (), "log"),
)
STYLES = ("-", "--")
# They distinguish lines that lie on one another.
MARKERS = "os^D"


def _name_bound(bound):
    return "plain grid" if bound == "0" else f"map within {bound} mm"


def _draw_panel(axes, table, panel):
    label, columns, _, scale = panel
    for number, bound in enumerate(dict.fromkeys(row["bound mm"] for row in table)):
        rows = [row for row in table if row["bound mm"] == bound]
        steps = [float(row["step deg"]) for row in rows]
        for column, style in zip(columns, STYLES):
            factor = 100 if scale == "linear" else 1
            axes.plot(steps, [factor * float(row[column]) for row in rows], style,
                      marker=MARKERS[number], markersize=4, color=drawing.COLORS[number],
                      label=_name_bound(bound) if style == "-" else None)
    axes.set_xscale("log", base=2)
    axes.set_yscale(scale)
    axes.set_ylabel(label)
    axes.xaxis.set_major_formatter(lambda x, _: f"{x:g}")


def _add_legend_of_styles(axes, names, place):
    handles = [lines.Line2D([], [], color="#444444", linestyle=style, label=name)
               for style, name in zip(STYLES, names)]
    axes.legend(handles=handles, fontsize=8, loc=place)


def draw(table, machine):
    """A column of panels for each scene."""
    names = list(dict.fromkeys(row["scene"] for row in table))
    figure, grid = pyplot.subplots(len(PANELS), len(names), figsize=(9.2, 10.2), sharex="col",
                                   squeeze=False)
    for column, name in enumerate(names):
        rows = [row for row in table if row["scene"] == name]
        grid[0][column].set_title(f"{name}, tolerance {rows[0]['tolerance mm']} mm", loc="left")
        for axes, panel in zip(grid[:, column], PANELS):
            _draw_panel(axes, rows, panel)
        # A grid with returns on all planes is right to the last digits.
        grid[0][column].set_ylim(bottom=max(MINIMUM_ERROR, grid[0][column].get_ylim()[0]))
        # An axes keeps one legend of its own.
        grid[0][column].add_artist(grid[0][column].legend(fontsize=8, loc="upper left"))
        for axes, panel, place in zip(grid[:, column], PANELS, ("lower right", "lower left")):
            _add_legend_of_styles(axes, panel[2], place)
        grid[-1][column].set_xlabel("step between beams and between turns, degrees")
    figure.suptitle("How fine a scan has to be", x=0.01, ha="left", fontsize=13, weight="bold")
    figure.tight_layout(rect=(0, 0.045, 1, 1))
    drawing.add_caption(figure, drawing.caption(
        "Top: how far the visible scene is from the map, and the map from the scene. Middle: what "
        "share of either is within the tolerance of the other. Ranges without noise. Errors below "
        f"{MINIMUM_ERROR} mm are not drawn.", machine, "a thread on each"), 165)
    return figure
