# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Makes maps of the same scan with LMS3D and other libraries for Python, and compares their errors.

Call it as "./run bench map-peers". The others are installed as those of "./run bench peers" are.
"""

import argparse
import csv
import pathlib
import subprocess
import tempfile
import time

import numpy
from lms3d import vtkLMS3DScanFilter, vtkLMS3DSurfaceReconstructionFilter
from lms3d.comparison import compare
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkBoxMuellerRandomSequence, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

import peers_mappers
import peers_scene
from compare_peers import install, print_table, versions

HERE = pathlib.Path(__file__).resolve().parent
# Those with the names of "./run bench map" are the same.
COLUMNS = ("scene", "map", "noise mm", "ms", "triangles", "to scene mean mm", "to scene 95% mm",
           "to scene max mm", "to map mean mm", "to map 95% mm", "both mean mm", "correct %",
           "complete %", "normals deg", "free space m2", "farthest return mm")
NOISE = 0.005  # metres
TIME_LIMIT = 120  # seconds
RUNS = 20


def make_scan(name):
    """Return the surface of a scene and its scan."""
    points, triangles, sensor = peers_scene.make(name)
    surface = make_surface(points, triangles)
    scan = vtkLMS3DScanFilter()
    scan.SetInputData(surface)
    scan.SetPosition(sensor)
    scan.Update()
    return surface, scan.GetOutput(), sensor


def make_surface(points, triangles):
    """Return vtkPolyData of numpy arrays."""
    vertices = vtkPoints()
    vertices.SetData(numpy_to_vtk(numpy.asarray(points, dtype=float), deep=True))
    cells = vtkCellArray()
    corners = numpy.asarray(triangles, dtype=numpy.int64)
    cells.SetData(3, numpy_to_vtkIdTypeArray(corners.ravel(), deep=True))
    surface = vtkPolyData()
    surface.SetPoints(vertices)
    surface.SetPolys(cells)
    return surface


def add_noise(scan, sensor):
    """Return the scan with the errors along the beams that "./run bench map" gives it."""
    noisy = vtkPolyData()
    noisy.DeepCopy(scan)
    points = vtk_to_numpy(noisy.GetPoints().GetData())
    ranges = vtk_to_numpy(noisy.GetPointData().GetArray("Range"))
    errors = make_errors(len(ranges))
    points += (points - sensor) * (errors / ranges)[:, None]
    ranges += errors
    return noisy


def make_errors(count):
    """Return normally distributed errors, metres."""
    random = vtkBoxMuellerRandomSequence()
    errors = numpy.empty(count)
    for number in range(count):
        errors[number] = random.GetScaledValue(0.0, NOISE)
        random.Next()
    return errors


def map_with_lms3d(scan, maximum_error):
    """Return the map and the shortest time of several runs, seconds."""
    mapper = vtkLMS3DSurfaceReconstructionFilter()
    mapper.SetInputData(scan)
    mapper.SetMaximumError(maximum_error)
    times = []
    for _ in range(RUNS):
        mapper.Modified()
        start = time.perf_counter()
        mapper.Update()
        times.append(time.perf_counter() - start)
    return mapper.GetOutput(), min(times)


def map_with_peer(peer, python, scan, sensor, folder):
    """Return the map and its time in seconds, or a word on why there is none."""
    points_file, map_file = folder / "points.npz", folder / "map.npz"
    numpy.savez(points_file, points=vtk_to_numpy(scan.GetPoints().GetData()), sensor=sensor)
    command = [python, HERE / "peers_mappers.py", peer, points_file, map_file]
    try:
        subprocess.run(command, timeout=TIME_LIMIT, check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.PIPE, text=True)
    except subprocess.TimeoutExpired:
        return f"over {TIME_LIMIT} s"
    except subprocess.CalledProcessError as problem:
        return (problem.stderr.strip().splitlines() or ["failed"])[-1].replace(",", ";")
    result = numpy.load(map_file)
    return make_surface(result["points"], result["triangles"]), float(result["seconds"])


def describe(result, surface, scan):
    """Return the cells of a row after its first three."""
    if isinstance(result, str):
        return [result, *["-"] * (len(COLUMNS) - 4)]
    local_map, seconds = result
    errors = compare(local_map, surface, scan)
    to_scene, to_map = errors.map_to_scene, errors.scene_to_map
    return [f"{1000 * seconds:.2f}", local_map.GetNumberOfCells(), f"{1000 * to_scene.mean:.2f}",
            f"{1000 * to_scene.percentile_95:.1f}", f"{1000 * to_scene.maximum:.0f}",
            f"{1000 * to_map.mean:.2f}", f"{1000 * to_map.percentile_95:.1f}",
            f"{500 * (to_scene.mean + to_map.mean):.2f}",
            f"{100 * errors.correctness:.2f}", f"{100 * errors.completeness:.2f}",
            f"{errors.normal_error.mean:.1f}", f"{errors.area_in_free_space:.3f}",
            f"{1000 * errors.largest_return_distance:.2f}"]


def map_with_peers(scan, sensor, python, folder):
    """Return what each peer makes of a scan, by its name."""
    return {peer: map_with_peer(peer, python, scan, sensor, folder)
            for peer in peers_mappers.PEERS}


def describe_maps(name, noise, maps, surface, scan):
    """Return a row for each map of a scan."""
    return [[name, label, f"{1000 * noise:g}", *describe(result, surface, scan)]
            for label, result in maps.items()]


def compare_maps(name, python, folder):
    """Return a row for each map, without and with noise."""
    surface, exact_scan, sensor = make_scan(name)
    rows = []
    for scan, noise, bound in ((exact_scan, 0, 0.01), (add_noise(exact_scan, sensor), NOISE, 0.02)):
        maps = {"LMS3D grid": map_with_lms3d(scan, 0),
                f"LMS3D map, {1000 * bound:g} mm": map_with_lms3d(scan, bound),
                **map_with_peers(scan, sensor, python, folder)}
        rows += describe_maps(name, noise, maps, surface, scan)
    print_table(COLUMNS, rows)
    return rows


def main():
    """Read the command line, compare, save."""
    parser = argparse.ArgumentParser(prog="./run bench map-peers", description=__doc__)
    parser.add_argument("--scenes", nargs="+", choices=peers_scene.NAMES, default=["room"])
    parser.add_argument("--csv", metavar="FILE", help="save the table")
    options = parser.parse_args()

    python = install()
    print("; ".join(versions(python)) + "\n")
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name in options.scenes:
            rows += compare_maps(name, python, pathlib.Path(folder))
    if options.csv:
        with open(options.csv, "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows([COLUMNS, *rows])


if __name__ == "__main__":
    main()
