# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d advise: finds the coarsest scan, and its coarsest map, that meet a tolerance."""

import argparse
import shlex

import numpy as np

from .. import vtkLMS3DScanFilter, vtkLMS3DSurfaceReconstructionFilter
from ..problems import Problem
from ..sampling import advise
from ..scene import check_readable
from . import device_options, scene_options, sensor_options, values

NAME = "advise"
SUMMARY = "find the coarsest scan and map of a scene that meet a tolerance"
DESCRIPTION = """\
Find the coarsest step of both angles that is good enough, and for this step the largest
--maximum-error of the map. Good enough means: the given share of the map is within the tolerance
of the scene, and the same share of the visible scene is within the tolerance of the map ("correct"
and "complete" of lms3d compare).

The command measures: it tries steps from 8 degrees down to --finest, and for each step maps with
bounds from 8 times the tolerance down to 1/8 of it, until one is good enough. By default the sensor
is ideal; then leave room in the tolerance for the errors of a real one, or choose it by --device.
"""
EPILOG = """\
examples:
  lms3d advise room.wrl --position 0.3 -0.2 1 --tolerance 0.02
  lms3d advise room.wrl --position 0.3 -0.2 1 --tolerance 0.05 --share 0.9 --finest 0.5
  lms3d advise room.wrl --position 0.3 -0.2 1 --tolerance 0.05 --device lms200-mm
"""

# Finer steps need too much time and memory.
_MINIMUM_STEP = 0.05


def add_arguments(parser):
    """Add the options of this command."""
    scene_options.add_scene(parser)
    goal = parser.add_argument_group("goal")
    goal.add_argument("--tolerance", type=values.positive, metavar="M", required=True,
                      help="largest distance between map and scene that counts as correct, metres")
    goal.add_argument("--share", type=_share, metavar="S", default=0.95,
                      help="share of each surface, above 0 and below 1 (default: 0.95)")
    goal.add_argument("--finest", type=_step, metavar="DEG", default=0.25,
                      help=f"smallest step to try, degrees, {_MINIMUM_STEP:g} to 8 (default: 0.25)")
    sensor_options.add_depth_step(parser)
    sensor_options.add_sensor(parser, position_needed=True, with_resolution=False)
    # The trials set these. A range needs at least two angles.
    parser.set_defaults(alpha_resolution=2, beta_resolution=2, maximum_error=0.0,
                        maximum_gap_size=-1, maximum_speckle_size=0, drop_speckles=False)


def run(options):
    """Check the options, read the scene, measure, print."""
    sensor_options.check(options)
    check_readable(options.scene)
    simulation = sensor_options.simulation(options)
    x, y, z = simulation.sensor.GetPosition()
    print(f"scene    {simulation.scene}\nsensor   {x:g} {y:g} {z:g} m")
    found, best = advise(simulation, options.tolerance, options.share, options.finest)
    if not found:
        raise Problem(_no_advice(options, best))
    _print(found, options)


def _share(text):
    value = values.positive(text)
    if value >= 1:
        raise argparse.ArgumentTypeError(f"{text.strip()} is not below 1")
    return value


def _step(text):
    value = values.positive(text)
    if not _MINIMUM_STEP <= value <= 8:
        raise argparse.ArgumentTypeError(f"{text.strip()} is not within {_MINIMUM_STEP:g} to 8")
    return value


def _quality(sample):
    comparison = sample.comparison
    return (f"{comparison.correctness:.2%} of the map and {comparison.completeness:.2%} of the "
            f"visible scene are within {1000 * comparison.tolerance:g} mm")


def _no_advice(options, best):
    if best is None:
        return (f"no scan with steps of {options.finest:g} degrees or more has enough returns for "
                "a map: move the sensor, widen its ranges or angles, or lower --finest")
    return (f"no map with steps of {options.finest:g} degrees or more is good enough for a share "
            f"of {options.share:g}: at best (step {best.step:g}, --maximum-error "
            f"{best.maximum_error:g}) {_quality(best)}; raise --tolerance, lower --share or "
            "lower --finest")


def _print(sample, options):
    beams = sample.alpha_resolution * sample.beta_resolution
    print(f"angles   {sample.alpha_resolution} elevations x {sample.beta_resolution} turns, steps "
          f"of {sample.step:g} degrees: {beams:,} beams, {sample.returns:,} returns\n"
          f"map      --maximum-error {sample.maximum_error:g} m: "
          f"{sample.comparison.triangles:,} triangles\n"
          f"result   {_quality(sample)}\n\n{_command(sample, options)}")


def _command(sample, options):
    """The lms3d scan command for a sample; without options that have their default value."""
    words = ["lms3d", "scan", options.scene]
    if options.up_axis != "file":
        words += ["--up-axis", options.up_axis]
    if options.scene_root is not None:
        words += ["--scene-root", options.scene_root]
    for name, value in scene_options.limits(options).items():
        words += [f"--scene-{name}", str(value)]
    words += _numbers("position", options.position)
    for name, default in _defaults().items():
        if getattr(options, name) is not None and not np.array_equal(getattr(options, name), default):
            words += _numbers(name, getattr(options, name))
    if options.method != "exact":
        words += ["--method", options.method]
    words += device_options.given(options)
    for name in ("alpha_resolution", "beta_resolution", "maximum_error"):
        words += _numbers(name, getattr(sample, name))
    return shlex.join(words + ["-o", "scan.vtp", "--map", "map.vtp"])


def _defaults():
    sensor = vtkLMS3DScanFilter()
    names = ("orientation", "alpha_range", "beta_range", "minimum_range", "maximum_range")
    return {**{name: getattr(sensor, "Get" + name.title().replace("_", ""))() for name in names},
            "depth_step": vtkLMS3DSurfaceReconstructionFilter().GetDepthStep()}


def _numbers(name, values):
    return ["--" + name.replace("_", "-"), *(f"{x:.15g}" for x in np.atleast_1d(values))]
