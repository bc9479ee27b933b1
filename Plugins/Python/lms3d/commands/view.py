# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d view: a window with the scene and the local map that follows the sensor."""

from ..figure import Figure, check_display
from ..results import check_targets, save
from ..scene import check_readable
from . import picture_options, sensor_options

NAME = "view"
SUMMARY = "move the sensor in a window; the local map follows"
DESCRIPTION = """\
Show the scene on the left in blue and the local map on the right in green.

  mouse               turns, moves and zooms both views
  arrow keys          move the sensor along x and y
  page up, page down  move the sensor along z
  r                   put sensor and camera back
  q                   quit
"""
EPILOG = """\
examples:
  lms3d view room.wrl --position 0.3 -0.2 1
  lms3d view room.wrl --position 0.3 -0.2 1 --screenshot figure.png
"""


def add_arguments(parser):
    """Add the options of this command."""
    sensor_options.add_scene(parser)
    sensor_options.add_sensor(parser, position_needed=False)
    view = parser.add_argument_group("view")
    sensor_options.add_map(view)
    view.add_argument("--step", type=sensor_options.positive, metavar="M",
                      help="metres that a key moves the sensor (default: a fiftieth of the scene)")
    view.add_argument("--screenshot", metavar="FILE",
                      help="draw once into this .png and exit, without a window")
    picture_options.add_picture(view)


def run(options):
    """Check the options, then open the window or draw the picture."""
    sensor_options.check(options)
    if options.screenshot:
        check_targets([("picture", options.screenshot)], options.scene)
    check_readable(options.scene)
    check_display()

    simulation = sensor_options.simulation(options)
    print(f"scene    {simulation.scene}")
    simulation.run()
    simulation.reconstruct()
    if options.screenshot:
        figure = Figure(simulation, options.size, edges=options.edges)
        save(figure.image(), options.screenshot)
        print(f"wrote    {options.screenshot}")
    else:
        from ..viewer import Viewer  # text and interaction: only here

        Viewer(simulation, options.size, options.step, options.edges).run()
