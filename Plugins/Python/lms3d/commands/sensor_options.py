# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Options that several commands share: the scene, the sensor in it and the local map."""

import argparse
import math
import re

import numpy as np

from .. import vtkLMS3DScanFilter, vtkLMS3DSurfaceReconstructionFilter
from ..problems import UsageProblem
from ..scene import READERS, UP_AXES, read_scene
from ..simulation import Simulation


# By the filter's names, as options are written: AngleSum is angle-sum.
METHODS = {
    re.sub(r"(?<!^)(?=[A-Z])", "-", vtkLMS3DScanFilter.GetIntersectionMethodName(i)).lower(): i
    for i in range(vtkLMS3DScanFilter.GetNumberOfIntersectionMethods())
}

# What vtkLMS3DScanFilter takes. A count is an int to VTK.
_LARGEST_COUNT = 2**31 - 1
_MOST_THREADS = 1024
_FARTHEST = 1e18  # metres


def number(text):
    """A finite number."""
    value = float(text)
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{text.strip()} is not a finite number")
    return value


def positive(text):
    """A finite number above zero."""
    value = number(text)
    if value <= 0:
        raise argparse.ArgumentTypeError(f"{text.strip()} is not above 0")
    return value


def bound(text):
    """A finite number from zero."""
    value = number(text)
    if value < 0:
        raise argparse.ArgumentTypeError(f"{text.strip()} is below 0")
    return value


def count(text, most=_LARGEST_COUNT):
    """A whole number from 1 to `most`."""
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text.strip()} is below 1")
    if value > most:
        raise argparse.ArgumentTypeError(f"{text.strip()} is above {most}")
    return value


def thread_count(text):
    """A whole number from 0, which stands for all cores."""
    return 0 if int(text) == 0 else count(text, _MOST_THREADS)


def add_scene(parser, is_needed=True):
    """Add the scene and how its axes are meant."""
    parser.add_argument("scene", metavar="SCENE", nargs=None if is_needed else "?",
                        help="the file to read: " + " ".join(READERS))
    parser.add_argument("--up-axis", choices=UP_AXES, default="file",
                        help="file: leave the axes as they are, z is up (default); "
                        "y: the file is y-up, as most VRML is, turn it to z-up")
    parser.add_argument("--scene-root", metavar="FOLDER",
                        help="where the other files that a VRML scene needs have to be, or below "
                        "(default: the scene's folder)")


def read(options):
    """The scene of the options."""
    return read_scene(options.scene, options.up_axis, options.scene_root)


def add_sensor(parser, position_needed, may_move=False, with_resolution=True):
    """Add the sensor's pose, or its trajectory, angles, ranges and way of working."""
    where = "" if position_needed else " (default: the middle of the scene)"
    add_pose(parser.add_argument_group("pose of the sensor in the scene"), position_needed, where,
             may_move)
    add_angles(parser.add_argument_group("beams"), with_resolution)
    measurement = parser.add_argument_group("measurement")
    add_ranges(measurement)
    _add_method(measurement)
    add_threads(measurement)


def add_pose(group, position_needed, where, may_move=False):
    """Add position and orientation; `where` says where the sensor is without a position."""
    place = group.add_mutually_exclusive_group(required=position_needed)
    place.add_argument("--position", nargs=3, type=number, metavar=("X", "Y", "Z"),
                       help=f"metres{where}")
    if may_move:
        place.add_argument("--trajectory", metavar="FILE",
                           help="one scan for each point of a polyline or point set: .vtp, "
                           "optionally with the point arrays Orientation (quaternions w x y z) and "
                           "Time (increasing)")
    group.add_argument("--orientation", nargs=3, type=number, metavar=("RX", "RY", "RZ"),
                       default=(0.0, 0.0, 0.0),
                       help="degrees, turned about z, then x, then y, as VTK's props are "
                       "(default: 0 0 0)")


def add_angles(group, with_resolution=True):
    """Add the angles of the beams, and how many there are."""
    defaults = vtkLMS3DScanFilter()
    for name, meaning in (("alpha", "elevation in the fan, within -90 90, both ends included"),
                          ("beta", "turn of the support, clockwise seen from above; the end of a "
                           "full circle is left out")):
        angles = getattr(defaults, f"Get{name.title()}Range")()
        resolution = getattr(defaults, f"Get{name.title()}Resolution")()
        group.add_argument(f"--{name}-range", nargs=2, type=number, metavar=("A", "B"),
                           default=angles,
                           help=f"degrees, {meaning} (default: {angles[0]:g} {angles[1]:g})")
        if with_resolution:
            group.add_argument(f"--{name}-resolution", type=count, metavar="N", default=resolution,
                               help=f"number of {name} angles (default: {resolution})")


def add_ranges(group):
    """Add the ranges within which a beam returns."""
    defaults = vtkLMS3DScanFilter()
    for name, word in (("minimum", "nearer"), ("maximum", "farther")):
        value = getattr(defaults, f"Get{name.title()}Range")()
        group.add_argument(f"--{name}-range", type=number, metavar="M", default=value,
                           help=f"metres, what is {word} gives no return (default: {value:g})")


def _add_method(group):
    group.add_argument("--method", choices=METHODS, default="exact",
                       help="exact: no beam slips through an edge (default); fast: single "
                       "precision; the others are slow, for comparison: the paper's sum of angles, "
                       "Moeller-Trumbore, VTK's locator")


def add_threads(group):
    """Add the number of threads."""
    group.add_argument("--threads", type=thread_count, metavar="N", default=0,
                       help="cores to use, up to 1024; the result is the same for any number "
                       "(default: 0, all)")


def add_map(parser):
    """Add what shapes the local map."""
    error = vtkLMS3DSurfaceReconstructionFilter().GetMaximumError()
    parser.add_argument("--maximum-error", type=bound, metavar="M", default=error,
                        help="metres, no return is farther from the map than this, which has as "
                        "few triangles as that allows; 0 keeps every return as a corner "
                        f"(default: {error:g})")
    add_depth_step(parser)


def add_depth_step(parser):
    """Add where the local map is torn."""
    step = vtkLMS3DSurfaceReconstructionFilter().GetDepthStep()
    parser.add_argument("--depth-step", type=positive, metavar="M", default=step,
                        help="metres, the map is torn where neighbouring ranges differ by more "
                        f"than this (default: {step:g})")


def differing(options):
    """Those of the pose's and beams' options, but the position, that are not at their default."""
    defaults = vtkLMS3DScanFilter()
    names = ("orientation", "alpha_range", "alpha_resolution", "beta_range", "beta_resolution")
    return ["--" + name.replace("_", "-") for name in names
            if np.any(np.not_equal(getattr(options, name),
                                   getattr(defaults, "Get" + name.title().replace("_", ""))()))]


def check(options):
    """Raise UsageProblem where the sensor cannot be so, before anything is read."""
    if any(abs(x) > _FARTHEST for x in options.position or ()):
        raise UsageProblem("--position {:g} {:g} {:g}: must lie within {:g} of 0".format(
            *options.position, _FARTHEST))
    beams = options.alpha_resolution * options.beta_resolution
    if beams > _LARGEST_COUNT:
        raise UsageProblem(
            f"--alpha-resolution {options.alpha_resolution} --beta-resolution "
            f"{options.beta_resolution}: {beams} beams, at most {_LARGEST_COUNT} are possible")
    low, high = options.alpha_range
    if not (-90 <= low and high <= 90 and _rises(low, high, options.alpha_resolution)):
        raise UsageProblem(f"--alpha-range {low:g} {high:g}: must rise and lie within -90 90")
    low, high = options.beta_range
    if not (high - low <= 360 and _rises(low, high, options.beta_resolution)):
        raise UsageProblem(f"--beta-range {low:g} {high:g}: must rise, by 360 at most")
    low, high = options.minimum_range, options.maximum_range
    if not (0 <= low <= high and high > 0):
        raise UsageProblem(f"--minimum-range {low:g} --maximum-range {high:g}: must rise, from 0 "
                           "or more to above 0")


def _rises(low, high, resolution):
    """Whether a range has two ends, or the one end that a single angle needs."""
    return low < high or (low == high and resolution == 1)


def simulation(options):
    """Read the scene and put the sensor of the options into it; nothing is scanned yet."""
    scene = read(options)
    scene.tell_losses()
    result = Simulation(scene)
    sensor = result.sensor
    place(sensor, options, result.scene)
    sensor.SetNumberOfThreads(options.threads)
    sensor.SetIntersectionMethod(METHODS[options.method])
    result.reconstruction.SetMaximumError(options.maximum_error)
    result.reconstruction.SetDepthStep(options.depth_step)
    return result


def place(sensor, options, scene):
    """Give the sensor the pose, the beams and the ranges of the options."""
    sensor.SetPosition(options.position or scene.surface.GetCenter())
    sensor.SetOrientation(options.orientation)
    sensor.SetAlphaRange(options.alpha_range)
    sensor.SetAlphaResolution(options.alpha_resolution)
    sensor.SetBetaRange(options.beta_range)
    sensor.SetBetaResolution(options.beta_resolution)
    sensor.SetMinimumRange(options.minimum_range)
    sensor.SetMaximumRange(options.maximum_range)
