# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Options that several commands share: the sensor in a scene, and the local map."""

import numpy as np

from .. import vtkLMS3DScanFilter, vtkLMS3DSurfaceReconstructionFilter
from ..problems import UsageProblem
from ..properties import MAXIMUM_COUNT, METHODS
from ..simulation import Simulation
from . import device_options, scene_options
from .values import bound, count, gap_size, group_size, number, positive, thread_count

_MAXIMUM_COORDINATE = 1e18  # metres, as in vtkLMS3DScanFilter


def add_sensor(parser, position_needed, may_move=False, with_resolution=True):
    """Add all options of the sensor: pose or trajectory, angles, measurement, device, platform."""
    where = "" if position_needed else " (default: the middle of the scene)"
    add_pose(parser.add_argument_group("pose of the sensor in the scene"), position_needed, where,
             may_move)
    add_angles(parser.add_argument_group("beams"), with_resolution)
    measurement = parser.add_argument_group("measurement")
    add_ranges(measurement, ", or what the --device reaches")
    _add_method(measurement)
    add_threads(measurement)
    device_options.add_device(parser)
    device_options.add_platform(parser, may_move)


def add_pose(group, position_needed, where, may_move=False):
    """Add position and orientation; `where` is the help text for the default position."""
    either = group.add_mutually_exclusive_group(required=position_needed)
    either.add_argument("--position", nargs=3, type=number, metavar=("X", "Y", "Z"),
                        help=f"metres{where}")
    if may_move:
        either.add_argument("--trajectory", metavar="FILE",
                            help="one scan for each point of a polyline or point set: .vtp, "
                            "optionally with the point arrays Orientation (quaternions w x y z) "
                            "and Time (increasing)")
    group.add_argument("--orientation", nargs=3, type=number, metavar=("RX", "RY", "RZ"),
                       default=(0.0, 0.0, 0.0),
                       help="degrees; turns about z, then x, then y, as in vtkProp3D "
                       "(default: 0 0 0)")


def add_angles(group, with_resolution=True):
    """Add the ranges of the beams' angles, and their resolutions."""
    defaults = vtkLMS3DScanFilter()
    for name, meaning in (("alpha", "elevation in the fan, within -90 90, both ends included"),
                          ("beta", "turn of the support, clockwise seen from above; a full circle "
                           "excludes its end")):
        angles = getattr(defaults, f"Get{name.title()}Range")()
        resolution = getattr(defaults, f"Get{name.title()}Resolution")()
        group.add_argument(f"--{name}-range", nargs=2, type=number, metavar=("A", "B"),
                           default=angles,
                           help=f"degrees, {meaning} (default: {angles[0]:g} {angles[1]:g})")
        if with_resolution:
            group.add_argument(f"--{name}-resolution", type=count, metavar="N", default=resolution,
                               help=f"number of {name} angles (default: {resolution})")


def add_ranges(group, default=""):
    """Add the sensor's minimum and maximum range; `default` is a text about the maximum's default."""
    defaults = vtkLMS3DScanFilter()
    group.add_argument("--minimum-range", type=number, metavar="M",
                       default=defaults.GetMinimumRange(),
                       help="metres; a nearer surface gives no return (default: "
                       f"{defaults.GetMinimumRange():g})")
    group.add_argument("--maximum-range", type=number, metavar="M",
                       help="metres; a farther surface gives no return (default: "
                       f"{defaults.GetMaximumRange():g}{default})")


def _add_method(group):
    group.add_argument("--method", choices=METHODS, default="exact",
                       help="exact: no beam passes between triangles that share an edge (default); "
                       "fast: single precision; the other methods are slow and serve for "
                       "comparison: the paper's sum of angles, Moeller-Trumbore, VTK's locator")


def add_threads(group):
    """Add the number of threads."""
    group.add_argument("--threads", type=thread_count, metavar="N", default=0,
                       help="number of threads, up to 1024; the results are the same for any "
                       "number (default: 0, all cores)")


def add_map(parser):
    """Add the options of the local map."""
    error = vtkLMS3DSurfaceReconstructionFilter().GetMaximumError()
    parser.add_argument("--maximum-error", type=bound, metavar="M", default=error,
                        help="bound on the distance of every return from the map, metres; the map "
                        "has as few triangles as the bound allows, 0 makes every return a vertex "
                        f"(default: {error:g})")
    add_depth_step(parser)
    parser.add_argument("--maximum-gap-size", type=gap_size, metavar="N", default=-1,
                        help="the map closes groups of up to N neighbouring beams without a return, if "
                        "the returns around them lie on one plane; -1: 25 if the scan has the array "
                        "Status, otherwise 0 (default: -1)")
    parser.add_argument("--maximum-speckle-size", type=group_size, metavar="N", default=0,
                        help="the surface goes on behind groups of up to N neighbouring returns that "
                        "lie off the plane around them (default: 0)")
    parser.add_argument("--drop-speckles", action="store_true",
                        help="leave these groups out of the map; otherwise each of their returns gets "
                        "a small triangle")


def add_depth_step(parser):
    """Add the depth step of the local map."""
    step = vtkLMS3DSurfaceReconstructionFilter().GetDepthStep()
    parser.add_argument("--depth-step", type=positive, metavar="M", default=step,
                        help="metres; the map has a gap where neighbouring ranges differ by more "
                        f"than this (default: {step:g})")


def changed(options):
    """The options of orientation and angles that do not have their default value."""
    defaults = vtkLMS3DScanFilter()
    names = ("orientation", "alpha_range", "alpha_resolution", "beta_range", "beta_resolution")
    return ["--" + name.replace("_", "-") for name in names
            if np.any(np.not_equal(getattr(options, name),
                                   getattr(defaults, "Get" + name.title().replace("_", ""))()))]


def check(options):
    """Raise UsageProblem if the sensor's options are invalid. Reads no file."""
    device_options.check(options)
    if any(abs(x) > _MAXIMUM_COORDINATE for x in options.position or ()):
        raise UsageProblem("--position {:g} {:g} {:g}: must lie within {:g} of 0".format(
            *options.position, _MAXIMUM_COORDINATE))
    beams = options.alpha_resolution * options.beta_resolution
    if beams > MAXIMUM_COUNT:
        raise UsageProblem(
            f"--alpha-resolution {options.alpha_resolution} --beta-resolution "
            f"{options.beta_resolution}: {beams} beams, at most {MAXIMUM_COUNT} are possible")
    low, high = options.alpha_range
    if not (-90 <= low and high <= 90 and _is_range(low, high, options.alpha_resolution)):
        raise UsageProblem(f"--alpha-range {low:g} {high:g}: must increase and lie within -90 90")
    low, high = options.beta_range
    if not (high - low <= 360 and _is_range(low, high, options.beta_resolution)):
        raise UsageProblem(f"--beta-range {low:g} {high:g}: must increase, by 360 at most")
    low, high = options.minimum_range, device_options.get_maximum_range(options)
    if not (0 <= low <= high and high > 0):
        raise UsageProblem(f"--minimum-range {low:g} --maximum-range {high:g}: the minimum must be "
                           "0 or more, the maximum above 0 and not below the minimum")


def _is_range(low, high, resolution):
    """Whether a range increases. For a single angle both ends may be equal."""
    return low < high or (low == high and resolution == 1)


def simulation(options):
    """Read the scene and set up the sensor and the map of the options. Does not scan."""
    scene = scene_options.read(options)
    scene.report_losses()
    result = Simulation(scene)
    sensor = result.sensor
    set_sensor(sensor, options, result.scene)
    device_options.apply(result, options)
    sensor.SetNumberOfThreads(options.threads)
    sensor.SetIntersectionMethod(METHODS[options.method])
    result.reconstruction.SetMaximumError(options.maximum_error)
    result.reconstruction.SetDepthStep(options.depth_step)
    result.reconstruction.SetMaximumGapSize(options.maximum_gap_size)
    result.reconstruction.SetMaximumSpeckleSize(options.maximum_speckle_size)
    result.reconstruction.SetKeepSpeckles(not options.drop_speckles)
    return result


def set_sensor(sensor, options, scene):
    """Set the sensor's pose, angles and ranges from the options."""
    sensor.SetPosition(options.position or scene.surface.GetCenter())
    sensor.SetOrientation(options.orientation)
    sensor.SetAlphaRange(options.alpha_range)
    sensor.SetAlphaResolution(options.alpha_resolution)
    sensor.SetBetaRange(options.beta_range)
    sensor.SetBetaResolution(options.beta_resolution)
    sensor.SetMinimumRange(options.minimum_range)
    sensor.SetMaximumRange(device_options.get_maximum_range(options))
