# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d scan: scan a scene and write what the sensor measured."""

from ..figure import Figure, check_display
from ..problems import UsageProblem
from ..results import check_targets, save
from ..scene import check_readable
from . import picture_options, sensor_options

NAME = "scan"
SUMMARY = "scan a scene; write points, range image, local map, picture"
DESCRIPTION = """\
Scan a scene once and write any of: the points, the range image, the local map, a picture.

The ending of each name chooses the format. A .vtp keeps everything in full precision; .ply
and .stl hold single precision coordinates only; .csv has the columns
x,y,z,Range,Alpha,Beta,BeamId,CellId.
"""
EPILOG = """\
examples:
  lms3d scan room.wrl --position 0.3 -0.2 1 -o scan.vtp
  lms3d scan model.stl --up-axis y --position 0 0 1.5 --beta-range -45 45 \\
      --beta-resolution 181 -o points.csv --map map.stl --picture figure.png
"""


def add_arguments(parser):
    """Add the options of this command."""
    sensor_options.add_scene(parser)
    sensor_options.add_sensor(parser, position_needed=True)
    results = parser.add_argument_group("results, at least one")
    results.add_argument("-o", "--output", metavar="FILE", help="points: .vtp .ply .csv")
    results.add_argument("--range-image", metavar="FILE",
                         help="grid of ranges, NaN where no beam returned: .vti")
    results.add_argument("--map", metavar="FILE", help="triangles: .vtp .ply .stl")
    sensor_options.add_map(results)
    results.add_argument("--picture", metavar="FILE",
                         help="scene in blue beside its local map in green: .png (needs a display)")
    picture_options.add_picture(results)


def run(options):
    """Check the options, scan, write."""
    _check(options)
    simulation = sensor_options.simulation(options)
    print(f"scene    {simulation.scene}")

    simulation.run()
    print(f"scan     {simulation.beams:,} beams, {simulation.returns:,} returns, ranges "
          f"{simulation.ranges().min():.3f} to {simulation.ranges().max():.3f} m")
    if options.map or options.picture:
        simulation.reconstruct()
        print(f"map      {simulation.map.GetNumberOfCells():,} triangles")

    _write(options, simulation)


def _targets(options):
    paths = (("scan", options.output), ("range image", options.range_image),
             ("map", options.map), ("picture", options.picture))
    return [(result, path) for result, path in paths if path]


def _check(options):
    targets = _targets(options)
    if not targets:
        raise UsageProblem("nothing to write: give -o, --range-image, --map or --picture a name")
    sensor_options.check(options)
    check_targets(targets, options.scene)
    check_readable(options.scene)
    if options.picture:
        check_display()


def _write(options, simulation):
    results = {
        "scan": lambda: simulation.scan,
        "range image": lambda: simulation.range_image,
        "map": lambda: simulation.map,
        "picture": lambda: Figure(simulation, options.size, edges=options.edges).image(),
    }
    for result, path in _targets(options):
        save(results[result](), path)
        print(f"wrote    {path}")
