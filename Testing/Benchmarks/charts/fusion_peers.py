# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The maps that Open3D makes of the first poses of chart G's journey, beside ours."""

import pathlib
import tempfile
import time

import lms3d
import numpy
import peers
import tables
from lms3d.comparison import compare
from peers_fusers import FUSERS
from peers_scans import make_surface
from places import DATA
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

OURS = "one map"
BOUND = 0.01  # metres
STOPS, STOPS_WHEN_QUICK = (1, 5, 10, 20), (1, 3)
THREADS = (1, 2)
SAMPLES = 50000
BYTES = 12  # of a point, a triangle or a region
# From a comparison: the value, its factor and its digits.
ERRORS = {
    "to scene mean mm": (lambda errors: errors.map_to_scene.mean, 1000, 2),
    "to scene 95% mm": (lambda errors: errors.map_to_scene.percentile_95, 1000, 1),
    "complete %": (lambda errors: errors.completeness, 100, 2),
    "free space m2": (lambda errors: errors.area_in_free_space, 1, 3),
}


def measure(quick, csv_file):
    """Make the maps of a few poses with ours and with Open3D, if it can be installed."""
    stops = STOPS_WHEN_QUICK if quick else STOPS
    surface, scans = _make_scans(stops[-1])
    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        _save(surface, scans, folder / "scans.npz")
        for threads in THREADS:
            rows += _fuse(surface, scans, stops, threads)
            rows += _fuse_with_peers(surface, scans, stops, threads, folder)
    tables.write(csv_file, rows)


def _make_scans(count):
    reader = lms3d.vtkVRMLImporterSource()
    reader.SetFileName(str(DATA / "building.wrl"))
    reader.Update()
    journey = vtkXMLPolyDataReader()
    journey.SetFileName(str(DATA / "building_journey.vtp"))
    journey.Update()
    positions = vtk_to_numpy(journey.GetOutput().GetPoints().GetData())[:count]
    return reader.GetOutput(), [lms3d.scan(reader.GetOutput(), position) for position in positions]


def _save(surface, scans, file):
    points = [vtk_to_numpy(scan.poly.GetPoints().GetData()) for scan in scans]
    mesh = lms3d.mesh.from_vtk(surface)
    numpy.savez(file, points=numpy.concatenate(points),
                firsts=numpy.cumsum([0] + [len(some) for some in points]),
                sensors=[_get_sensor(scan) for scan in scans],
                corners=mesh.vertices, triangles=mesh.triangles)


def _get_sensor(scan):
    matrix = vtk_to_numpy(scan.poly.GetFieldData().GetArray("SensorToWorld")).reshape(4, 4)
    return matrix[:3, 3]


def _fuse(surface, scans, stops, threads):
    """Return our rows. A pose costs its local map, its fusion and the mesh, so none is left to make."""
    fused = lms3d.FusedMap(maximum_error=BOUND, threads=threads)
    rows, done = [], 0
    for stop in stops:
        with peers.real_time():
            start = time.perf_counter()
            for scan in scans[done:stop]:
                revision = fused.revision
                fused.add(scan)
                mesh = fused.poly
            seconds = (time.perf_counter() - start) / (stop - done)
        changes = fused.changes(revision)
        regions = changes.GetFieldData().GetArray("ChangedRegions").GetNumberOfTuples()
        rows.append(_make_row(OURS, threads, stop, (seconds, 0.0), mesh, (surface, scans),
                              changes.GetNumberOfPoints() + changes.GetNumberOfCells() + regions))
        done = stop
    return rows


def _fuse_with_peers(surface, scans, stops, threads, folder):
    try:
        python = peers.install()
        version = peers.find_version(peers.get_versions(python), "Open3D")
    except (OSError, peers.subprocess.CalledProcessError) as problem:
        print(f"Open3D is left out: {problem}")
        return []
    rows = []
    for name in FUSERS if version != "-" else ():
        print(f"   {name}, {threads} threads", flush=True)
        rows += _fuse_with_peer(name, python, (surface, scans), stops, threads, folder)
    return rows


def _fuse_with_peer(name, python, places, stops, threads, folder):
    """Return a row for each map that was made within the time limit."""
    file = folder / "maps.npz"
    try:
        result = peers.run(python, "peers_fusers.py", name, folder / "scans.npz",
                           ",".join(map(str, stops)), result_file=file,
                           environment={"OMP_NUM_THREADS": str(threads)})
    except peers.PeerProblem as problem:
        print(f"   {name}: {problem}", flush=True)
        result = dict(numpy.load(file)) if file.exists() else {}
    rows = []
    for stop in stops:
        if f"points{stop}" in result:
            points, triangles = result[f"points{stop}"], result[f"triangles{stop}"]
            rows.append(_make_row(name, threads, stop,
                                  (float(result[f"add{stop}"]), float(result[f"make{stop}"])),
                                  make_surface(points, triangles), places,
                                  len(points) + len(triangles)))
    return rows


def _make_row(name, threads, stop, seconds, fused, places, items):
    """Return the cells of a map. "seconds" are for adding a pose, and for making the map."""
    return {
        "map": name, "threads": threads, "poses": stop,
        "pose ms": f"{1000 * seconds[0]:.1f}", "mesh ms": f"{1000 * seconds[1]:.1f}",
        "triangles": fused.GetNumberOfCells(),
        **_measure_errors(fused, places, stop),
        "kB a pose": f"{BYTES * items / 1000:.1f}",
    }


def _measure_errors(fused, places, stop):
    """Return the means over what the first and the last pose see; "-" for a map without triangles."""
    if fused.GetNumberOfCells() == 0:
        return dict.fromkeys(ERRORS, "-")
    surface, scans = places
    errors = [compare(fused, surface, scans[pose].poly, BOUND, SAMPLES)
              for pose in sorted({0, stop - 1})]
    return {name: f"{factor * sum(map(get, errors)) / len(errors):.{digits}f}"
            for name, (get, factor, digits) in ERRORS.items()}

