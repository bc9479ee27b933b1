# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d demo: makes the paper's Figures 5 and 6, and pictures of a real device's errors and map.

The scenes are installed with LMS3D.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from .. import vtkLMS3DRangeErrorFilter, vtkLMS3DSurfaceReconstructionFilter
from ..data import scene_file
from ..device import set_device
from ..device_figure import DeviceFigure, DeviceMapFigure, range_errors
from ..execution import update
from ..figure import Figure, check_display
from ..problems import Problem
from ..results import ResultFiles
from ..scene import UP_AXES, read_scene
from ..simulation import Simulation
from . import values

NAME = "demo"
SUMMARY = "scan the room and the teapot of the paper; write all results and four pictures"
DESCRIPTION = """\
Scan the two scenes of the paper. For each, write the points (.vtp), the range image (.vti),
the local map (.vtp) and a picture of scene and map (.png), and print a line of numbers.
The time is the shortest of several scans, each after a move of the sensor.

The third picture shows the scan of the room twice: ideal, and as an LMS 200 reports it, coloured by
the error of each range. The reported points (.vtp) have the errors as RangeError (metres). The fourth
shows the room and the map of these points (.vtp), within 2 cm.
"""
EPILOG = """\
example:
  lms3d demo --output demo
"""


@dataclass(frozen=True)
class Experiment:
    """A scene of the paper, and the sensor and map settings for it (metres, degrees)."""

    name: str
    figure: str
    position: tuple
    maximum_error: float = 0.01
    depth_step: float = 0.1
    alpha_range: tuple = (-90.0, 90.0)
    alpha_resolution: int = 361
    beta_range: tuple = (0.0, 360.0)
    beta_resolution: int = 360


ROOM = Experiment("room", "figure5", position=(0.3, -0.2, 1.0))

TEAPOT = Experiment("teapot", "figure6", position=(0.1, -0.38, 0.28),
                    maximum_error=0.001, depth_step=0.02,
                    alpha_range=(-45.0, -5.0), alpha_resolution=401,
                    beta_range=(235.0, 305.0), beta_resolution=701)

DEVICE = "lms200-mm"
SEED = 1
DEVICE_ERROR = 0.02  # metres, four standard deviations of the device's noise

_COLUMNS = ("scene", "triangles", "beams", "returns", "scan ms", "map triangles")


def add_arguments(parser):
    """Add the options of this command."""
    parser.add_argument("--output", metavar="DIR", default="demo",
                        help="folder for the files, created if missing (default: demo)")
    parser.add_argument("--data", metavar="DIR",
                        help="folder of room.wrl and teapot.wrl (default: the environment variable "
                        "LMS3D_DATA_DIR, else the folder installed with LMS3D)")
    parser.add_argument("--maximum-error", type=values.bound, metavar="M",
                        help="bound on the distance of every return from its map, metres; 0 makes "
                        f"every return a vertex (default: {ROOM.maximum_error:g} for the room, "
                        f"{TEAPOT.maximum_error:g} for the teapot)")


def run(options):
    """Run both experiments and print the table."""
    check_display()
    folder = Path(options.output)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Problem(f"cannot make the folder '{folder}': {error.strerror}") from error

    rows, names = [_COLUMNS], []
    with ResultFiles() as files:
        for experiment in (ROOM, TEAPOT):
            simulation = simulate(experiment, options.data, options.maximum_error)
            milliseconds = 1000 * simulation.scan_time()
            rows.append(_row(experiment, simulation, milliseconds))
            names += _write(experiment, simulation, folder, files)
            if experiment is ROOM:
                summary, written = _write_device(simulation, folder, files)
                names += written
    _print_table(rows)
    print(f"\n{summary}\nscenes: {UP_AXES['file']}\nwrote {folder}/: " + " ".join(names))


def simulate(experiment, data=None, maximum_error=None):
    """Scan and reconstruct the scene of an experiment; `maximum_error` replaces its own."""
    simulation = Simulation(read_scene(scene_file(f"{experiment.name}.wrl", data)))
    simulation.sensor.SetPosition(experiment.position)
    simulation.sensor.SetAlphaRange(experiment.alpha_range)
    simulation.sensor.SetAlphaResolution(experiment.alpha_resolution)
    simulation.sensor.SetBetaRange(experiment.beta_range)
    simulation.sensor.SetBetaResolution(experiment.beta_resolution)
    simulation.reconstruction.SetMaximumError(
        experiment.maximum_error if maximum_error is None else maximum_error)
    simulation.reconstruction.SetDepthStep(experiment.depth_step)
    simulation.run()
    simulation.reconstruct()
    return simulation


def report(simulation):
    """Repeat a scan with DEVICE; returns what it reports, with the array RangeError.

    The simulation's scan is ideal again afterwards, and has normals.
    """
    simulation.sensor.SurfaceAttributesOn()
    simulation.run()
    ideal = simulation.scan.NewInstance()
    ideal.ShallowCopy(simulation.scan)
    errors = vtkLMS3DRangeErrorFilter()
    errors.SetInputConnection(simulation.sensor.GetOutputPort())
    errors.SetNoiseSeed(SEED)
    for target in (simulation.sensor, errors):
        set_device(target, DEVICE)
    update(errors, "scanning", "cannot scan")
    reported = errors.GetOutput()
    values = numpy_to_vtk(range_errors(ideal, reported), deep=True)
    values.SetName("RangeError")
    reported.GetPointData().AddArray(values)
    set_device(simulation.sensor, "ideal")
    simulation.run()
    return reported


def reconstruct(reported):
    """Return the filter that made the map of a reported scan."""
    reconstruction = vtkLMS3DSurfaceReconstructionFilter()
    reconstruction.SetInputData(reported)
    reconstruction.SetMaximumError(DEVICE_ERROR)
    reconstruction.SetDepthStep(ROOM.depth_step)
    update(reconstruction, "mapping", "cannot build the local map")
    return reconstruction


def _write_device(simulation, folder, files):
    """Write the reported scan, its map and their pictures; returns a line about it, and the names."""
    reported = report(simulation)
    mapping = reconstruct(reported)
    errors = vtk_to_numpy(reported.GetPointData().GetArray("RangeError"))
    results = {"room_reported.vtp": reported,
               "room_reported_map.vtp": mapping.GetOutput(),
               "device_room.png": DeviceFigure(simulation, reported, DEVICE).image(),
               "device_map_room.png": DeviceMapFigure(simulation, mapping).image()}
    for name, data in results.items():
        files.save(data, folder / name)
    return (f"{DEVICE}: {len(errors):,} returns, half of the range errors within "
            f"{1000 * np.nanmedian(np.abs(errors)):.1f} mm, the largest "
            f"{1000 * np.nanmax(np.abs(errors)):.0f} mm, "
            f"{mapping.GetOutput().GetNumberOfCells():,} map triangles"), list(results)


def _write(experiment, simulation, folder, files):
    results = {
        f"{experiment.name}_scan.vtp": simulation.scan,
        f"{experiment.name}_range.vti": simulation.range_image,
        f"{experiment.name}_map.vtp": simulation.map,
        f"{experiment.figure}_{experiment.name}.png": Figure(simulation).image(),
    }
    for name, data in results.items():
        files.save(data, folder / name)
    return list(results)


def _row(experiment, simulation, milliseconds):
    return (experiment.name, f"{simulation.scene.triangles:,}", f"{simulation.beams:,}",
            f"{simulation.returns:,}", f"{milliseconds:.1f}",
            f"{simulation.map.GetNumberOfCells():,}")


def _print_table(rows):
    """Print rows of text as columns: the first is aligned left, the others right."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    for first, *numbers in rows:
        cells = [f"{text:>{width}}" for text, width in zip(numbers, widths[1:])]
        print("  ".join([f"{first:<{widths[0]}}"] + cells))
