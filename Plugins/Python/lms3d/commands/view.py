# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d view: a window with the scene, and with the local map that follows the sensor."""

from ..figure import Figure, check_display
from ..pose import TURN_STEP
from ..problems import UsageProblem
from ..remote import RemoteScanner
from ..results import check_targets, reports, save
from ..scene import check_readable
from . import device_options, picture_options, scene_options, sensor_options, values

NAME = "view"
SUMMARY = "move the sensor in a window; the local map follows"
DESCRIPTION = """\
Show the scene on the left in blue and the local map on the right in green. With --server, show the
newest scan of a server (lms3d-server) on the left, coloured by range. The window is never larger
than the screen.

  mouse               turns, moves and zooms both views
  arrow keys          move the sensor at its height: left, right, up and down as you see them
  page up, page down  move the sensor along z
  x, y, z             turn the sensor about its red, green and blue axis; with shift, turn it back
  k                   keeps what was seen: the map grows with each pose; again: the local map alone
                      (with --server: the server's map, if it has the option --fused-map)
  r                   resets sensor and camera
  q                   quits
"""
EPILOG = """\
examples:
  lms3d view room.wrl --position 0.3 -0.2 1
  lms3d view room.wrl --position 0.3 -0.2 1 --screenshot figure.png
  lms3d view room.wrl --position 0.3 -0.2 1 --device lms200-mm --maximum-error 0.03
  lms3d view --server corbaloc:iiop:1.2@127.0.0.1:2810/LMS3D
"""


def add_arguments(parser):
    """Add the options of this command."""
    scene_options.add_scene(parser, is_needed=False)
    parser.add_argument("--server", metavar="URL",
                        help="show this server instead of a scene: the URL that it prints "
                        "(corbaloc:..., IOR:...), corbaname:..., or file:PATH with the PATH of its "
                        "--ior; the keys move its sensor for all clients")
    sensor_options.add_sensor(parser, position_needed=False)
    view = parser.add_argument_group("view")
    sensor_options.add_map(view)
    view.add_argument("--step", type=values.positive, metavar="M",
                      help="metres that a key moves the sensor (default: 1/50 of the scene's size)")
    view.add_argument("--turn-step", type=values.positive, metavar="DEG",
                      default=TURN_STEP,
                      help=f"degrees that a key turns the sensor (default: {TURN_STEP:g})")
    view.add_argument("--screenshot", metavar="FILE",
                      help="write a picture to this .png and exit, without a window; - is the "
                      "standard output")
    picture_options.add_picture(view)


def run(options):
    """Check the options, then open the window or draw the picture."""
    if (options.scene is None) == (options.server is None):
        raise UsageProblem("give either a SCENE or --server URL")
    with reports([("picture", options.screenshot)]):
        if options.server is None:
            _view_scene(options)
        else:
            _view_server(options)


def _view_scene(options):
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
        _draw(Figure(simulation, options.size, edges=options.edges), options.screenshot)
    else:
        from ..viewer import Viewer  # text and interaction: only here

        Viewer(simulation, options.size, options.step, options.edges, options.turn_step).run()


def _view_server(options):
    useless = (sensor_options.changed(options) + device_options.given_names(options)
               + ["--position"] * (options.position is not None))
    if useless:
        raise UsageProblem(f"{useless[0]}: the server has its own sensor")
    if options.screenshot:
        check_targets([("picture", options.screenshot)])
    check_display()

    from ..remote_viewer import RemoteFigure, RemoteViewer

    scanner = RemoteScanner(options.server)
    print(f"server   {options.server}")
    if options.screenshot:
        _draw(RemoteFigure(scanner, options.size, edges=options.edges), options.screenshot)
    else:
        RemoteViewer(scanner, options.size, options.server, options.step, options.edges,
                     options.turn_step).run()


def _draw(figure, path):
    save(figure.image(), path, "picture")
    print(f"wrote    {path}")
