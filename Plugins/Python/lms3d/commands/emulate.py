# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d emulate: an LMS 200 on a pseudo-terminal."""

import argparse
import gc
import os
import time
from contextlib import ExitStack
from pathlib import Path

from .. import vtkLMS3DScanFilter
from ..emulation.angle_lines import AngleLines
from ..emulation.device import Device
from ..emulation.emulator import Emulator
from ..emulation.ending import closed_terminal, stop_descriptor
from ..emulation.fans import LiveFans, StoredFans
from ..emulation.link import check_link, linked
from ..emulation.measured_values import CENTIMETRES, MILLIMETRES
from ..emulation.platform import Stepped, Turning
from ..emulation.poses import interpolate_poses
from ..emulation.state import FIRMWARES, make_state
from ..emulation.terminal import Terminal
from ..execution import update
from ..messages import VTKMessages
from ..problems import UsageProblem
from ..results import STREAM, check_apart, check_writable, reports, writing
from ..scene import check_readable, read_data
from ..simulation import Simulation
from ..trajectory import TrajectoryScan
from . import device_options, scene_options, sensor_options, values

NAME = "emulate"
SUMMARY = "answer the telegrams of an LMS 200 on a pseudo-terminal"
DESCRIPTION = """\
Answer the serial telegrams of a SICK LMS 200 on a pseudo-terminal. Programs with a driver for the
device open it like a serial port, and receive the fans of a simulated sensor in a scene. With
--scan, they receive the fans of a stored scan.

The platform turns in steps by default: to the next angle when the host has received a fan, so the
telegrams are a whole scan in its order, and then the next scan. With --turn RATE it turns steadily,
and fans are lost on a slow line, as on the device. The telegrams do not contain the angle of the
platform; --angles writes it beside them.

The device starts at 9600 Bd, in a variant of 180 degrees by 0.5, and sends nothing before it is
requested. Value i of a telegram is beam i of the fan: alpha is -90 degrees + i/2. The measuring mode
limits the ranges, so --device does not change --maximum-range here.

Once the port is printed, the command runs until Ctrl-C, SIGTERM, or the end of its terminal; that is
a success. Hosts may come and go. If the reader of --angles goes away, the command ends with an error.
Documentation/drivers.md explains how to start the drivers of robots' software.
"""
EPILOG = """\
examples:
  lms3d emulate room.wrl --position 0.3 -0.2 1 --link /tmp/lms200
  lms3d emulate room.wrl --position 0.3 -0.2 1 --device lms200-mm --seed 1 --turn 10 \\
      --link /tmp/lms200 --angles angles.csv
  lms3d emulate --scan scan.vtp --unit cm --pace mirror
"""

_STEPPED = "stepped"
_UNITS = {"mm": MILLIMETRES, "cm": CENTIMETRES}
_PACES = ("line", "mirror")
_MAXIMUM_TURN_RATE = 3600.0
# Options that a stored scan has decided.
_WITHOUT_SCAN = ("up_axis", "orientation", "beta_range", "beta_resolution", "minimum_range",
                 "maximum_range")


def _turn(text):
    """--turn: "stepped" or degrees a second."""
    if text.strip() == _STEPPED:
        return None
    try:
        value = values.number(text)
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"'{text}' is neither {_STEPPED} nor a number") from None
    if abs(value) > _MAXIMUM_TURN_RATE:
        raise argparse.ArgumentTypeError(
            f"{text.strip()} is not within {-_MAXIMUM_TURN_RATE:g} to {_MAXIMUM_TURN_RATE:g}")
    return value


def add_arguments(parser):
    """Add the options of this command."""
    scene_options.add_scene(parser, is_needed=False)
    parser.add_argument("--scan", metavar="FILE",
                        help="in place of a scene: play the fans of a scan, a .vtp of "
                        "'lms3d scan'; only variants whose beams it has are possible")
    sensor_options.add_pose(parser.add_argument_group("pose of the sensor in the scene"), False, "",
                            may_move=True)
    _add_platform(parser.add_argument_group("platform"))
    measurement = parser.add_argument_group("measurement")
    sensor_options.add_ranges(measurement)
    device_options.add_device(parser)
    _add_line(parser.add_argument_group("device and line"))
    # The fan is the device's, and a single fan needs no threads.
    sensor = vtkLMS3DScanFilter()
    parser.set_defaults(alpha_range=sensor.GetAlphaRange(), threads=1, method="exact",
                        alpha_resolution=sensor.GetAlphaResolution(),
                        # The measuring mode limits the ranges, and not the device.
                        maximum_range=sensor.GetMaximumRange())
    parser.set_defaults(without_scan={each: parser.get_default(each) for each in _WITHOUT_SCAN})


def _add_platform(group):
    group.add_argument("--turn", type=_turn, default=_STEPPED, metavar="stepped|RATE",
                       help="stepped: to the next angle after each fan (default); or degrees a "
                       "second, from the first angle of --beta-range on, without an end")
    defaults = vtkLMS3DScanFilter()
    first, last = defaults.GetBetaRange()
    group.add_argument("--beta-range", nargs=2, type=values.number, metavar=("A", "B"),
                       default=(first, last),
                       help="degrees, turn of the platform, clockwise seen from above; a full "
                       f"circle excludes its end (default: {first:g} {last:g})")
    count = defaults.GetBetaResolution()
    group.add_argument("--beta-resolution", type=values.count, metavar="N", default=count,
                       help=f"number of steps (default: {count})")
    group.add_argument("--angles", metavar="FILE",
                       help="write a line for each fan that a host has received: index of the "
                       "mirror's turn, index of the telegram, time, angle of the platform; - is "
                       "the standard output. The time is in seconds since 1970. Telegrams have "
                       "the same indices if bit 1 of the availability is set")


def _add_line(group):
    group.add_argument("--link", metavar="PATH",
                       help="a symbolic link to the pseudo-terminal, which is removed at the end")
    group.add_argument("--pace", choices=_PACES, default=_PACES[0],
                       help="line: the rate of the line limits the number of fans of a stream, as on "
                       "the device (default); mirror: every scan of the mirror arrives, at any rate")
    group.add_argument("--unit", choices=_UNITS, default="mm",
                       help="the unit that the device was left with (default: mm)")
    group.add_argument("--firmware", choices=FIRMWARES, default=FIRMWARES[0],
                       help="the configuration has 34 bytes with 2.30 (default), 32 with 2.10")


def run(options):
    """Check the options, then serve hosts."""
    _check(options)
    with reports([("angles", options.angles)]):
        _serve(options)


def _check(options):
    if (options.scene is None) == (options.scan is None):
        raise UsageProblem("give either a SCENE or --scan FILE")
    if options.scan:
        if options.position or options.trajectory:
            raise UsageProblem("--scan: a stored scan has its own pose")
        for name, default in options.without_scan.items():
            if getattr(options, name) != default:
                raise UsageProblem(f"--scan: a stored scan has its own --{name.replace('_', '-')}")
        check_readable(options.scan, "scan", (".vtp",))
    else:
        if not options.position and not options.trajectory:
            raise UsageProblem("a scene needs --position X Y Z or --trajectory FILE")
        sensor_options.check(options)
        check_readable(options.scene)
    if options.trajectory:
        check_readable(options.trajectory, "trajectory", (".vtp",))
    if options.angles not in (None, STREAM):
        check_writable("angles", options.angles)
        check_apart("angles", options.angles, scene=options.scene, scan=options.scan,
                    trajectory=options.trajectory)
    if options.link is not None:
        check_link(options.link)
        if options.angles and os.path.abspath(options.angles) == os.path.abspath(options.link):
            raise UsageProblem(f"'{options.link}' is both angles and link: choose two names")


def _serve(options):
    with ExitStack() as stack:
        fans = _stored_fans(options) if options.scan else _live_fans(options, stack)
        lines = _open_lines(options.angles, stack)  # a pipe waits here for its reader
        stop = stack.enter_context(stop_descriptor())
        terminal = stack.enter_context(Terminal())
        stack.enter_context(linked(options.link, terminal.name))
        device = _make_device(options, fans)
        with closed_terminal():
            print(f"device   {device.state.type_name.decode().strip()}, ranges {options.device}, "
                  f"{options.unit}, {device.rate} Bd, pace of the {options.pace}")
            print(f"port     {terminal.name}" + (f", link {options.link}" if options.link else ""),
                  flush=True)
        # The objects that exist now stay; a search for garbage among them would delay fans.
        gc.collect()
        gc.freeze()
        emulator = Emulator(device, terminal, stop, lines)
        emulator.run()
        if lines:
            lines.finish()
    with closed_terminal():
        print(f"ended    after {emulator.fans:,} fan{'s' * (emulator.fans != 1)}", flush=True)


def _live_fans(options, stack):
    scene = scene_options.read(options)
    scene.report_losses()
    print(f"scene    {scene}")
    simulation = Simulation(scene)
    sensor_options.set_sensor(simulation.sensor, options, scene)
    simulation.sensor.SetNumberOfThreads(options.threads)
    times = ()
    if options.trajectory:
        trajectory = read_data(options.trajectory, "trajectory")
        times = TrajectoryScan(simulation, trajectory).times
        if options.turn is not None:
            simulation.sensor.SetTrajectoryData(
                interpolate_poses(trajectory, simulation.sensor.GetOrientation(), times))
    device_options.apply_device(simulation.sensor, options)
    errors, has_errors = device_options.make_errors(options)
    messages = stack.enter_context(VTKMessages())
    return LiveFans(simulation.sensor, lambda: _check_messages(messages),
                    errors if has_errors else None, times)


def _stored_fans(options):
    """The fans of a stored scan. The filter for errors checks its data, too."""
    print(f"scan     {Path(options.scan).name}")
    errors, _ = device_options.make_errors(options)
    errors.SetInputDataObject(read_data(options.scan, "scan"))
    update(errors, "adding errors", f"cannot play '{options.scan}'")
    return StoredFans(errors.GetOutput(), errors.GetRangeImage(), options.scan)


def _check_messages(messages):
    if messages.errors:
        messages.report("cannot scan")


def _open_lines(path, stack):
    if path is None:
        return None
    if path == STREAM:
        descriptor, name = 1, "the standard output"
    else:
        with writing(path):
            descriptor = stack.enter_context(open(path, "wb", buffering=0)).fileno()
        name = f"'{path}'"
    return AngleLines(descriptor, name, time.time() - time.monotonic())


def _make_device(options, fans):
    now = time.monotonic()
    platform = Stepped(fans) if options.turn is None else Turning(fans, options.turn, now)
    state = make_state(_UNITS[options.unit], options.firmware, fans.variants)
    return Device(state, platform, now, options.pace == _PACES[0])
