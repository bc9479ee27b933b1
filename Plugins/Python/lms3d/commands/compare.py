# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""lms3d compare: measures the distance of a map from the scene, and of the scene from the map."""

from .. import vtkLMS3DMapComparison
from ..comparison import POSE_ARRAYS, compare, copy_pose, has_pose
from ..problems import Problem, UsageProblem
from ..results import ResultFiles, check_targets, reports, sort_targets
from ..scene import check_readable, read_data
from ..simulation import Simulation
from . import device_options, scene_options, sensor_options, values

NAME = "compare"
SUMMARY = "measure the errors of a local map"
DESCRIPTION = """\
Compare a map with the scene that was scanned, in both directions, at points spread evenly over
both surfaces. Prints:

  map to scene       the distance of the map from the nearest part of the scene
  visible scene to   the distance of the visible scene (within the sensor's angles and ranges, and
    map              not hidden) from the nearest part of the map
  normals            the angle between the planes of the map's triangles and of the scene's; 180
                     degrees minus this angle for triangles that face away from the sensor
  correct, complete  the share of the map within the tolerance of the scene, and of the visible
                     scene within the tolerance of the map; F is their harmonic mean
  free space         the area of the map in space that the sensor has seen to be empty
  closed gaps        if the map closes gaps between returns: their number and area, and how much of it
                     is in front of the scene; this does not count as free space
  returns            with --scan: the share of returns within the tolerance of the map, and the
                     largest distance of a return from it

The command reads the sensor's pose from the map, if it is a .vtp of LMS3D, or from --scan. For
other maps give it by --position and the options beside it.
"""
EPILOG = """\
examples:
  lms3d scan room.wrl --position 0.3 -0.2 1 -o scan.vtp --map map.vtp
  lms3d compare map.vtp room.wrl --scan scan.vtp -o errors.vtp
  lms3d compare other.stl room.wrl --position 0.3 -0.2 1 --tolerance 0.05
"""

_MAP_ENDINGS = (".vtp", ".ply", ".stl", ".obj")


def add_arguments(parser):
    """Add the options of this command."""
    defaults = vtkLMS3DMapComparison()
    parser.add_argument("map", metavar="MAP",
                        help="the map's file: " + " ".join(_MAP_ENDINGS))
    scene_options.add_scene(parser)
    how = parser.add_argument_group("comparison")
    how.add_argument("--tolerance", type=values.positive, metavar="M",
                     default=defaults.GetTolerance(),
                     help="largest distance that counts as correct, metres "
                     f"(default: {defaults.GetTolerance():g})")
    how.add_argument("--samples", type=_sample_count, metavar="N",
                     default=defaults.GetNumberOfSamples(),
                     help="number of points on each surface; they are the same in every run "
                     f"(default: {defaults.GetNumberOfSamples()})")
    sensor_options.add_threads(how)
    results = parser.add_argument_group("results")
    results.add_argument("-o", "--output", metavar="FILE",
                         help="the map with its errors in metres, as point data Error and cell "
                         "data LargestError: .vtp; - is the standard output")
    results.add_argument("--scene-points", metavar="FILE",
                         help="points of the visible scene with their distance from the map as "
                         "Error, which shows what the map lacks: .vtp; - is the standard output")
    sensor = parser.add_argument_group("sensor")
    sensor.add_argument("--scan", metavar="FILE", help="the scan that the map was made from: .vtp")
    sensor_options.add_pose(sensor, False, " (default: from the map or the scan)")
    sensor_options.add_angles(sensor)
    sensor_options.add_ranges(sensor)
    device_options.add_platform(parser)


def run(options):
    """Check the options, read, compare, write."""
    _check(options)
    with reports(_targets(options)):
        _compare(options)


def _compare(options):
    scene = scene_options.read(options)
    scene.report_losses()
    local_map = _read_map(options.map)
    scan = _read_scan(options.scan) if options.scan else None
    position = _find_sensor(options, scene, local_map, scan)
    print(f"scene    {scene}\nsensor   {position[0]:g} {position[1]:g} {position[2]:g} m")

    comparison = compare(local_map, scene.data, scan, options.tolerance, options.samples,
                         (options.minimum_range, device_options.get_maximum_range(options)),
                         options.threads)
    _print(comparison, scan)
    results = {"map with errors": comparison.map, "scene points": comparison.scene_points}
    with ResultFiles() as files:
        for result, path in sort_targets(_targets(options)):
            files.save(results[result], path, result)
    for _, path in _targets(options):
        print(f"wrote    {path}")


def _sample_count(text):
    return values.count(text, vtkLMS3DMapComparison().GetNumberOfSamplesMaxValue())


def _targets(options):
    paths = (("map with errors", options.output), ("scene points", options.scene_points))
    return [(result, path) for result, path in paths if path]


def _check(options):
    sensor_options.check(options)
    if options.scan and options.position:
        raise UsageProblem("--scan and --position: the scan has the sensor's pose, "
                           "give only one of them")
    changed = sensor_options.changed(options) + device_options.changed_names(options)
    if changed and not options.position:
        raise UsageProblem(f"{' '.join(changed)}: needs --position")
    inputs = {"map": options.map, **({"scan": options.scan} if options.scan else {})}
    check_targets(_targets(options), options.scene, **inputs)
    check_readable(options.map, "map", _MAP_ENDINGS)
    check_readable(options.scene)
    if options.scan:
        check_readable(options.scan, "scan", (".vtp",))


def _read_map(path):
    local_map = read_data(path, "map")
    if local_map.GetNumberOfPolys() + local_map.GetNumberOfStrips() == 0:
        raise Problem(f"nothing to compare in the map '{path}': the file holds no triangles")
    return local_map


def _read_scan(path):
    scan = read_data(path, "scan")
    if not has_pose(scan):
        raise Problem(f"cannot use the scan '{path}': it lacks some of the field data "
                      f"{', '.join(POSE_ARRAYS)}; give a file of 'lms3d scan -o'")
    return scan


def _find_sensor(options, scene, local_map, scan):
    """The sensor's position. With --position, the map gets the pose of the options."""
    if options.position:
        simulation = Simulation(scene)
        sensor_options.set_sensor(simulation.sensor, options, scene)
        device_options.apply_platform(simulation.sensor, options)
        simulation.run()
        copy_pose(simulation.scan, local_map)
    elif not (scan or has_pose(local_map)):
        raise UsageProblem(f"the map '{options.map}' does not have the sensor's pose: give "
                           "--scan or --position")
    pose = (scan or local_map).GetFieldData().GetArray("SensorToWorld")
    return [pose.GetValue(i) for i in (3, 7, 11)]


def _print(comparison, scan):
    print(f"map      {comparison.triangles:,} triangles, {comparison.map_area:.4g} m2; "
          f"visible of the scene {comparison.visible_area:.4g} m2\n")
    print(f"{'':22}" + "".join(f"{head:>10}" for head in ("mean", "RMS", "95 %", "max")))
    for name, errors, factor, unit in (
            ("map to scene", comparison.map_to_scene, 1000, "mm"),
            ("visible scene to map", comparison.scene_to_map, 1000, "mm"),
            ("normals", comparison.normal_error, 1, "degrees")):
        print(f"{name:22}" + "".join(f"{factor * x:10.2f}" for x in errors) + f"  {unit}")
    print(f"\nwithin {1000 * comparison.tolerance:g} mm: correct "
          f"{100 * comparison.correctness:.2f} %, complete {100 * comparison.completeness:.2f} %, "
          f"F {100 * comparison.f_score:.2f} %")
    print(f"in free space: {comparison.area_in_free_space:.4g} m2 of the map")
    _print_gaps(comparison)
    if comparison.returns_within_tolerance is not None:
        print(f"returns: {scan.GetNumberOfPoints():,}, "
              f"{100 * comparison.returns_within_tolerance:.2f} % within "
              f"{1000 * comparison.tolerance:g} mm, the farthest "
              f"{1000 * comparison.largest_return_distance:.2f} mm from the map")


def _print_gaps(comparison):
    gaps, area = (comparison.map.GetFieldData().GetArray(name)
                  for name in ("NumberOfClosedGaps", "ClosedGapArea"))
    if gaps and area and gaps.GetTuple1(0):
        print(f"closed gaps: {int(gaps.GetTuple1(0)):,}, {area.GetTuple1(0):.4g} m2, of this "
              f"{comparison.closed_gap_area_in_free_space:.4g} m2 in front of the scene")
