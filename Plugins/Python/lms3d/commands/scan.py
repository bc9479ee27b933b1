# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d scan: scans a scene and writes the results."""

from contextlib import ExitStack
from pathlib import Path

from ..bag import Bag, is_bag
from ..device import set_arrays
from ..figure import Figure, check_display
from ..problems import UsageProblem
from ..results import STREAM, ResultFiles, check_targets, reports, sort_targets
from ..scene import check_readable
from . import (device_options, fusion_options, journey, picture_options, scene_options,
               sensor_options)

NAME = "scan"
SUMMARY = "scan a scene; write points, range image, maps, picture"
DESCRIPTION = """\
Scan a scene once and write any of: the points, the range image, the local map, a picture.

The file ending chooses the format. A .vtp file keeps everything in full precision. A .ply or
.stl file has coordinates in single precision only. A .csv file has the columns
x,y,z,Range,Alpha,Beta,BeamId,CellId; a .ply file of points has these properties. Incidence,
Intensity and Time follow if they are asked for.

  points      grid     no return  pose  time  coordinates
  .vtp        BeamId   left out   yes   no    the scene's, double precision; all arrays
  .csv        BeamId   left out   no    no    the scene's, all digits
  .ply        BeamId   left out   no    no    the scene's, single precision
  .pcd        yes      NaN        yes   no    the scene's, single precision
  .ptx        yes      0 0 0      yes   no    the sensor's, 9 digits
  .e57        indices  left out   yes   no    the sensor's, double precision; needs pye57
  .las .laz   BeamId   left out   no    *     the scene's, steps of 0.1 mm; need laspy, lazrs
  .db3 .mcap  yes      +inf, NaN  yes   yes   the sensor's, single precision; need rosbags

  * gps_time, if the points have the array Time

.db3 and .mcap are ROS 2 bags: folders with LaserScan, PointCloud2 and tf. A bag does not replace
what exists. The libraries are in Plugins/Python/requirements-formats.txt.

The files get their names together, when all are complete. In place of a file, - is the standard
output: points are then written as .csv, the range image as .vti, a map as .ply, and the picture
as .png. The lines that the command prints go to the error stream then.

With --trajectory there is one scan for each pose, and with --map also one local map. Each of these
is a .pvd file, which lists the files of all steps and their times; ParaView plays it. A bag has the
scans of all poses. --fused joins the local maps of all poses to one map: every return that its local
map explains is within --maximum-error. The poses are in the scene's coordinates, after --up-axis.
Without the point array Orientation the sensor looks along the polyline; without a polyline its
orientation is --orientation.

By default the sensor is ideal. --device lms200-mm makes the scan that of an LMS 200: a beam has a
width and mixes near and far surfaces at edges, dark surfaces do not return it, and ranges have
errors (bias, then noise, then resolution). All results have these ranges. Each scan of a trajectory
has its own noise.
"""
EPILOG = """\
examples:
  lms3d scan room.wrl --position 0.3 -0.2 1 -o scan.vtp
  lms3d scan model.stl --up-axis y --position 0 0 1.5 --beta-range -45 45 \\
      --beta-resolution 181 -o points.csv --map map.stl --picture figure.png
  lms3d scan room.wrl --position 0.3 -0.2 1 -o - | gzip > points.csv.gz
  lms3d scan room.wrl --trajectory path.vtp -o scans.pvd --map maps.pvd
  lms3d scan building.wrl --trajectory path.vtp --fused building.vtp --maximum-error 0.02
  lms3d scan hall.glb --position 2 3 1.2 -o hall.e57
  lms3d scan room.wrl --trajectory path.vtp -o journey.mcap
  lms3d scan room.wrl --position 0.3 -0.2 1 -o labelled.vtp --surface-attributes
  lms3d scan room.wrl --position 0.3 -0.2 1 -o reported.vtp --device lms200-mm --seed 1 \\
      --map map.vtp --maximum-error 0.03
  lms3d scan room.wrl --position 0.3 -0.2 1 -o noisy.vtp --range-noise 0.005 --time
"""

# The formats of points that keep all arrays.
_COMPLETE = (".vtp", ".pvd")


def add_arguments(parser):
    """Add the options of this command."""
    scene_options.add_scene(parser)
    sensor_options.add_sensor(parser, position_needed=True, may_move=True)
    results = parser.add_argument_group("results, at least one")
    results.add_argument("-o", "--output", metavar="FILE",
                         help="points: .vtp .ply .csv .pcd .ptx .e57 .las .laz .db3 .mcap, or - for "
                         ".csv on the standard output; with --trajectory .pvd .db3 .mcap")
    results.add_argument("--surface-attributes", action="store_true",
                         help="the points (.vtp, .pvd) also have what they hit: Normals, Incidence "
                         "(degrees, 0: perpendicular) and the scene's cell arrays, for VRML ShapeId "
                         "and Color; the field data ShapeNames has the names of the shapes")
    results.add_argument("--range-image", metavar="FILE",
                         help="grid of ranges, NaN without a return: .vti, or -")
    results.add_argument("--map", metavar="FILE",
                         help="triangles: .vtp .ply .stl, or - for .ply; with --trajectory .pvd")
    results.add_argument("--fused", metavar="FILE",
                         help="with --trajectory: one map of all poses, triangles: .vtp .ply .stl, or "
                         "- for .ply")
    sensor_options.add_map(results)
    fusion_options.add_fusion(results)
    device_options.add_arrays(parser.add_argument_group("further arrays of the points"))
    results.add_argument("--picture", metavar="FILE",
                         help="scene in blue beside its local map in green: .png, or - (needs a "
                         "display)")
    picture_options.add_picture(results)


def run(options):
    """Check the options, scan, write."""
    _check(options)
    with reports(_targets(options)):
        _scan(options)


def _scan(options):
    simulation = sensor_options.simulation(options)
    sensor = simulation.sensor
    sensor.SetSurfaceAttributes(options.surface_attributes)
    sensor.SetMotionDuringScan(options.motion_during_scan)
    set_arrays(sensor, options.incidence, options.intensity, options.time, options.status,
               options.poses)
    print(f"scene    {simulation.scene}")
    if options.trajectory:
        journey.scan(options, simulation)
    else:
        _scan_once(options, simulation)


def _scan_once(options, simulation):
    simulation.run()
    print(f"scan     {simulation.beams:,} beams, {simulation.returns:,} returns, ranges "
          f"{simulation.ranges().min():.3f} to {simulation.ranges().max():.3f} m")
    if options.map or options.picture:
        simulation.reconstruct()
        triangles = simulation.map.GetNumberOfCells()
        print(f"map      {triangles:,} triangle{'s' * (triangles != 1)}")

    _write(options, simulation)


def _targets(options):
    if options.trajectory:
        return journey.list_targets(options)
    paths = (("scan", options.output), ("range image", options.range_image),
             ("map", options.map), ("picture", options.picture))
    return [(result, path) for result, path in paths if path]


def _check(options):
    targets = _targets(options)
    journey.check(options)
    if not targets:
        raise UsageProblem("nothing to write: give a file name by -o, --range-image, --map, --fused "
                           "or --picture")
    _check_arrays(options)
    sensor_options.check(options)
    inputs = {"trajectory": options.trajectory} if options.trajectory else {}
    check_targets(targets, options.scene, **inputs)
    check_readable(options.scene)
    if options.picture:
        check_display()


def _check_arrays(options):
    """Raise UsageProblem if no file would have the arrays of the options."""
    is_complete = Path(options.output or "").suffix.lower() in _COMPLETE
    for name in ("surface_attributes", "poses"):
        if getattr(options, name) and not is_complete:
            raise UsageProblem(f"--{name.replace('_', '-')}: only points in a .vtp or .pvd file hold "
                               "them; give its name by -o")
    if options.status and not (is_complete or options.range_image):
        raise UsageProblem("--status: only points in a .vtp or .pvd file and the range image hold "
                           "it; give a name by -o or --range-image")
    for name in ("incidence", "intensity", "time"):
        if getattr(options, name) and not options.output:
            raise UsageProblem(f"--{name}: an array of the points; give their file by -o")


def _write(options, simulation):
    results = {
        "scan": lambda: simulation.scan,
        "range image": lambda: simulation.range_image,
        "map": lambda: simulation.map,
        "picture": lambda: Figure(simulation, options.size, edges=options.edges).image(),
    }
    targets = sort_targets(_targets(options))
    with ExitStack() as stack:
        bag = is_bag(options.output or "") and stack.enter_context(Bag(options.output, simulation))
        with ResultFiles() as files:
            for result, path in targets:
                if is_bag(path):
                    bag.add(results[result](), 0.0)
                    bag.finish(files)
                else:
                    files.save(results[result](), path, result)
    for _, path in targets:
        print(f"wrote    {path}")
