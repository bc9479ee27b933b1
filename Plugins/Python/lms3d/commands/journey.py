# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The part of lms3d scan that scans from each pose of a trajectory."""

from contextlib import ExitStack

from ..bag import Bag, is_bag
from ..messages import say
from ..problems import Problem, UsageProblem
from ..results import ResultFiles
from ..scene import check_readable, read_data
from ..trajectory import Series, TrajectoryScan, check_names
from . import fusion_options


def list_targets(options):
    """The results that the options ask for, with their paths."""
    paths = (("series of scans", options.output), ("series of maps", options.map),
             ("fused map", options.fused))
    return [(result, path) for result, path in paths if path]


def check(options):
    """Raise a Problem if the options cannot be used for a trajectory."""
    if not options.trajectory:
        for name in ("fused", "forget_seen_through", "drop_returns"):
            if getattr(options, name):
                raise UsageProblem(f"--{name.replace('_', '-')}: one map is made of the maps of many "
                                   "poses; give them by --trajectory")
        return
    check_readable(options.trajectory, "trajectory", (".vtp",))
    if options.range_image or options.picture:
        raise UsageProblem("with --trajectory only -o, --map and --fused can be written")
    if options.fused:
        fusion_options.check(options)
    for name in ("forget_seen_through", "drop_returns"):
        if getattr(options, name) and not options.fused:
            raise UsageProblem(f"--{name.replace('_', '-')}: only for the map that --fused writes")
    check_names(path for result, path in list_targets(options)
                if result != "fused map" and not is_bag(path))


def scan(options, simulation):
    """Scan from each pose; writes no file before the last scan is done."""
    if options.fused:
        fusion_options.connect(simulation, options)
    scans = TrajectoryScan(simulation, read_data(options.trajectory, "trajectory"))
    with ExitStack() as stack:
        series = _open_series(options, simulation, scans.times, stack)
        for time in scans.run(with_map=bool(options.map)):
            for _, data, files in series:
                files.add(data(), time)
        if not any(scans.returns):
            raise Problem("no beam returned from any pose: move the trajectory, or widen the "
                          "sensor's ranges or angles")
        with ResultFiles() as together:
            for _, _, files in series:
                files.finish(together)
            if options.fused:  # last: it may be written to the standard output
                together.save(simulation.fused_map, options.fused, "fused map")
    _report(options, simulation, scans, series)


def _open_series(options, simulation, times, stack):
    """The files of each series: its path, what gives the data of a step, and the files."""
    data = {"series of scans": lambda: simulation.scan, "series of maps": lambda: simulation.map}
    inputs = [path for path in (options.scene, options.trajectory, options.fused) if path]
    return [(path, data[result], stack.enter_context(
        Bag(path, simulation, times) if is_bag(path) else Series(path, len(times), inputs)))
        for result, path in list_targets(options) if result in data]


def _report(options, simulation, scans, series):
    print(f"scans    {len(scans.times):,} from time {scans.times[0]:g} to "
          f"{scans.times[-1]:g}, {sum(scans.returns):,} returns")
    if 0 in scans.returns:
        say(f"warning: no beam returned from {scans.returns.count(0)} of the poses")
    if options.fused:
        print(f"fused    {simulation.fused_map.GetNumberOfCells():,} triangles from "
              f"{simulation.fusion.GetNumberOfScans():,} scans")
    for path, _, files in series:
        if is_bag(path):
            _print_bag(path, files)
        else:
            print(f"wrote    {path} and the {len(scans.times):,} files that it lists")
    if options.fused:
        print(f"wrote    {options.fused}")


def _print_bag(path, bag):
    if bag.delayed:
        print(f"bag      {bag.delayed:,} scans begin after the time of their pose, when the scan "
              "before has ended")
    print(f"wrote    {path}")
