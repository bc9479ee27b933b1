# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Chart F: how each effect of a real device changes the ranges and the map of the room."""

import time

import device_panels
import drawing
import numpy
import tables
from device_effects import DEPTH_STEP, EFFECTS, IDEAL, MAXIMUM_ERROR, POSITION, make_path
from lms3d import vtkLMS3DRangeErrorFilter
from lms3d.comparison import compare
from lms3d.scene import read_scene
from lms3d.simulation import Simulation
from matplotlib import pyplot
from places import DATA
from vtkmodules.util.numpy_support import vtk_to_numpy

LETTER = "F"
NAME = "device"
SUMMARY = "ranges and map of the room with each effect of a real device, and with all"

ROUNDS, ROUNDS_WHEN_QUICK = 15, 3
SAMPLES, SAMPLES_WHEN_QUICK = 200_000, 20_000
CHANGE = 0.001  # metres; ranges that differ by less count as equal


def measure(quick, csv_file):
    """Scan the room with each effect, with all of them, and without any."""
    scene = read_scene(DATA / "room.wrl")
    simulations = {effect: _make(scene, effect) for effect in EFFECTS}
    times = _measure_times(simulations, ROUNDS_WHEN_QUICK if quick else ROUNDS)
    ideal = simulations[IDEAL]
    rows = []
    for effect, simulation in simulations.items():
        print(f"   {effect.name}", flush=True)
        simulation.reconstruct()
        errors = compare(simulation.map, scene.data, simulation.scan,
                         samples=SAMPLES_WHEN_QUICK if quick else SAMPLES)
        rows.append({
            "effect": effect.name, "value": effect.value,
            **_compare_ranges(_get_ranges(simulation), _get_ranges(ideal)),
            "ms": f"{1000 * times[effect]:.2f}",
            "x ideal": f"{times[effect] / times[IDEAL]:.2f}",
            **_summarize_map(errors),
        })
    tables.write(csv_file, rows)


def _make(scene, effect):
    simulation = Simulation(scene)
    sensor, mapping = simulation.sensor, simulation.reconstruction
    sensor.SetPosition(POSITION)
    sensor.SetNumberOfThreads(1)
    mapping.SetMaximumError(MAXIMUM_ERROR)
    mapping.SetDepthStep(DEPTH_STEP)
    if effect.speed:
        sensor.SetTrajectoryData(make_path(effect.speed))
        sensor.MotionDuringScanOn()
    _set(sensor, effect.sensor)
    if effect.errors:
        errors = vtkLMS3DRangeErrorFilter()
        _set(errors, {**effect.errors, "NumberOfThreads": 1})
        simulation.add_errors(errors)
    return simulation


def _set(algorithm, values):
    for name, value in values.items():
        getattr(algorithm, f"Set{name}")(value)


def _measure_times(simulations, rounds):
    """Return the shortest time of each scan; all take turns, so that a disturbance meets all."""
    times = {}
    for number in range(rounds + 1):
        for effect, simulation in simulations.items():
            simulation.sensor.Modified()
            start = time.perf_counter()
            simulation.run()
            if number > 0:
                times[effect] = min(times.get(effect, numpy.inf), time.perf_counter() - start)
    return times


def _get_ranges(simulation):
    return vtk_to_numpy(simulation.range_image.GetPointData().GetArray("Range"))


def _compare_ranges(ranges, ideal):
    both = ~numpy.isnan(ranges) & ~numpy.isnan(ideal)
    changes = numpy.abs(ranges - ideal)[both]
    lost = numpy.isnan(ranges) & ~numpy.isnan(ideal)
    return {
        "changed %": f"{100 * numpy.mean(changes > CHANGE):.2f}",
        "median mm": f"{1000 * numpy.median(changes):.3f}",
        "95% mm": f"{1000 * numpy.percentile(changes, 95):.3f}",
        "max mm": f"{1000 * changes.max():.1f}",
        "lost %": f"{100 * numpy.mean(lost):.3f}",
    }


def _summarize_map(errors):
    return {
        "triangles": errors.triangles,
        "map to scene mean mm": f"{1000 * errors.map_to_scene.mean:.3f}",
        "map to scene 95% mm": f"{1000 * errors.map_to_scene.percentile_95:.3f}",
        "scene to map mean mm": f"{1000 * errors.scene_to_map.mean:.3f}",
        "complete %": f"{100 * errors.completeness:.2f}",
        "free space m2": f"{errors.area_in_free_space:.3f}",
    }


def draw(table, machine):
    """Draw a row of marks for each effect."""
    figure, axes = pyplot.subplots(1, len(device_panels.PANELS), sharey=True,
                                   figsize=(9.2, 2.0 + 0.3 * len(table)))
    device_panels.draw_all(axes, table)
    figure.suptitle("What a real device does to the ranges and the map of the room", x=0.01,
                    ha="left", fontsize=13, weight="bold")
    figure.subplots_adjust(left=0.24, right=0.985, top=0.85, bottom=0.17, wspace=0.1)
    drawing.add_caption(figure, drawing.caption(
        f"361 x 360 beams, maps within {1000 * MAXIMUM_ERROR:g} mm. Changes are against the ideal "
        "scan from the same pose; the map is compared with the visible scene.", machine), 165)
    return figure
