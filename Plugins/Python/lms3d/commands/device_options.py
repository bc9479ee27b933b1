# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Options of the commands that scan: the device, the errors of its ranges, and its platform."""

from .. import vtkLMS3DRangeErrorFilter, vtkLMS3DScanFilter
from ..device import name_in_vtk, set_errors, set_platform, set_sensor
from ..problems import UsageProblem
from ..properties import DEVICES, MAXIMUM_BEAM_SAMPLES, MOUNTINGS
from .values import bound, count, number, seed

# The options that a device sets: the value None stands for the device's.
_SENSOR = ("beam_diameter", "beam_divergence", "beam_samples", "pulse_length",
           "range_at_ten_percent")
_ERRORS = ("range_bias", "range_noise", "range_resolution")


def beam_samples(text):
    """A number of rays for a beam."""
    return count(text, MAXIMUM_BEAM_SAMPLES)


def add_device(parser):
    """Add the device, and single values in place of its own."""
    group = parser.add_argument_group(
        "device (an ideal sensor has no width, sees every surface, and has no errors)")
    group.add_argument("--device", choices=DEVICES, default="ideal",
                       help="sets --maximum-range and all options of this group and the next, except "
                       "--reflectance and --seed; options beside it replace its values (default: "
                       "ideal)")
    defaults = vtkLMS3DScanFilter()
    for name, convert, unit, text in (
            ("beam-diameter", bound, "M", "metres; diameter of the beam at the sensor; needs "
             "--beam-samples above 1 (LMS 200: 0.012)"),
            ("beam-divergence", bound, "D", "metres for each metre of range; growth of the diameter; "
             "needs --beam-samples above 1 (LMS 200: 0.0044)"),
            ("beam-samples", beam_samples, "N", "number of rays that stand for a beam, up to "
             f"{MAXIMUM_BEAM_SAMPLES}; 1 is a beam without width, 7 and 19 complete a ring"),
            ("pulse-length", bound, "M", "metres; surfaces within this of the nearest mix to one "
             "range, farther ones do not"),
            ("range-at-ten-percent", bound, "M", "metres; up to this range the device sees a surface "
             "that reflects 10 percent; 0 sees every surface (LMS 200: 10)")):
        value = getattr(defaults, "Get" + name.title().replace("-", ""))()
        group.add_argument(f"--{name}", type=convert, metavar=unit,
                           help=f"{text} (default: the device's; ideal: {value:g})")
    group.add_argument("--reflectance", metavar="NAME",
                       help="cell array of the scene with the reflectance of each cell, 0.1 for 10 "
                       "percent, or with colours, which stand for their luminance: Color for VRML "
                       "(default: every surface reflects all)")
    _add_errors(parser)


def _add_errors(parser):
    """Add the errors of the device's ranges."""
    group = parser.add_argument_group("errors of the device (default: the device's; ideal: none)")
    group.add_argument("--range-bias", type=number, metavar="M",
                       help="metres; added to every range (the data sheet of the LMS 200 allows "
                       "-0.015 to 0.015)")
    group.add_argument("--range-noise", type=bound, metavar="M",
                       help="metres; one standard deviation of normally distributed noise along "
                       "the beam (LMS 200: 0.005)")
    group.add_argument("--range-resolution", type=bound, metavar="M",
                       help="metres; ranges are rounded to the nearest multiple, after bias and "
                       "noise (LMS 200: 0.001 or 0.01)")
    group.add_argument("--seed", type=seed, metavar="N", default=0,
                       help="number of the noise: the same seed gives the same noise, another "
                       "seed other noise (default: 0)")


def add_platform(parser, may_move=False):
    """Add how the platform carries and turns the sensor."""
    group = parser.add_argument_group("platform")
    group.add_argument("--mounting", choices=MOUNTINGS, default="yawing",
                       help="the axis that the platform turns: yawing, the vertical through both "
                       "ends of the fan (default); yawing-top, the vertical through its middle; pitching, "
                       "the level axis through both ends; rolling, the level axis through its middle")
    group.add_argument("--axis-offset", nargs=3, type=number, metavar=("X", "Y", "Z"),
                       default=(0.0, 0.0, 0.0),
                       help="metres; the centre of the mirror, along the sensor's axes while beta is "
                       "0; it turns with the platform (default: 0 0 0)")
    group.add_argument("--turn-rate", type=number, metavar="DEG", default=0.0,
                       help="degrees a second that the platform turns during each fan (default: 0, "
                       "it stands still)")
    if may_move:
        group.add_argument("--motion-during-scan", action="store_true",
                           help="with --trajectory: each beam leaves from the pose at its own time, "
                           "between the poses of the trajectory, so that the scan is skewed")


def add_arrays(group):
    """Add the arrays that points can have in addition."""
    for name, text in (
            ("incidence", "add Incidence (degrees, 0: perpendicular)"),
            ("intensity", "add Intensity, the reflectance times the cosine of the incidence"),
            ("time", "add Time (seconds), when the beam left"),
            ("poses", "add SensorPosition (metres) and SensorOrientation (w x y z), the pose when "
             "the beam left (.vtp, .pvd)"),
            ("status", "add Status of all beams to the field data (.vtp, .pvd) and to the range "
             "image: 0 return, 1 nothing met, 2 beyond the range, 3 too weak, 4 too near; with "
             "--fused always on if beams may be lost: with --minimum-range, --range-at-ten-percent or "
             "errors of ranges")):
        group.add_argument(f"--{name}", action="store_true", help=text)


def given(options):
    """The options of device and platform that are given, as words of a command."""
    words = [] if options.device == "ideal" else ["--device", options.device]
    for name in (*_SENSOR, "reflectance", *_ERRORS):
        if getattr(options, name) is not None:
            words += _words(name, [getattr(options, name)])
    return words + (["--seed", str(options.seed)] if options.seed else []) + changed(options)


def changed(options):
    """The options of the platform that do not have their default value, as words of a command."""
    words = [] if options.mounting == "yawing" else ["--mounting", options.mounting]
    if any(options.axis_offset):
        words += _words("axis_offset", options.axis_offset)
    return words + (_words("turn_rate", [options.turn_rate]) if options.turn_rate else [])


def changed_names(options):
    """The names of these options."""
    return [word for word in changed(options) if word.startswith("--")]


def given_names(options):
    """The names of the options of device and platform that are given."""
    return [word for word in given(options) if word.startswith("--")]


def _words(name, values):
    return ["--" + name.replace("_", "-"),
            *(value if isinstance(value, str) else f"{value:.15g}" for value in values)]


def get_maximum_range(options):
    """The maximum range of the options, or of their device."""
    return _get_value(options, "maximum_range")


def check(options):
    """Raise UsageProblem if the device's options are invalid, or have no effect."""
    if "device" in options:
        _check_device(options)
    if getattr(options, "motion_during_scan", False) and not options.trajectory:
        raise UsageProblem("--motion-during-scan: needs --trajectory")


def _check_device(options):
    divergence = options.beam_divergence
    if divergence is not None and divergence > 1:
        raise UsageProblem(f"--beam-divergence {divergence:g}: must be from 0 to 1")
    if _get_value(options, "beam_samples") == 1:
        for name in ("beam_diameter", "beam_divergence"):
            if getattr(options, name):
                raise UsageProblem(f"--{name.replace('_', '-')}: needs --beam-samples above 1")
    needs_light = _get_value(options, "range_at_ten_percent") > 0
    if options.reflectance and not (needs_light or getattr(options, "intensity", False)):
        raise UsageProblem("--reflectance: has an effect only with a --device, with "
                           "--range-at-ten-percent, or, in lms3d scan, with --intensity")


def _get_value(options, name):
    """The value of an option, or of its device."""
    value = getattr(options, name)
    if value is not None:
        return value
    device = DEVICES[getattr(options, "device", "ideal")]
    return vtkLMS3DScanFilter.GetDeviceValue(device, name_in_vtk(name))


def apply_platform(sensor, options):
    """Set the sensor's platform from the options."""
    set_platform(sensor, options.mounting, options.axis_offset, options.turn_rate)


def apply_device(sensor, options):
    """Set the sensor's device from the options."""
    set_sensor(sensor, options.device, vars(options))
    sensor.SetReflectanceArray(options.reflectance)


def make_errors(options):
    """Return a filter with the errors of the options' device, and whether there are any."""
    errors = vtkLMS3DRangeErrorFilter()
    has_errors = set_errors(errors, options.device, vars(options))
    errors.SetNoiseSeed(options.seed)
    errors.SetNumberOfThreads(options.threads)
    return errors, has_errors


def apply(simulation, options):
    """Set the sensor's device and platform from the options, and add the errors, if there are any."""
    apply_device(simulation.sensor, options)
    apply_platform(simulation.sensor, options)
    errors, has_errors = make_errors(options)
    if has_errors:
        simulation.add_errors(errors)
