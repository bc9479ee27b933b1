#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Moves a scanner, fetches its scans and local maps, and watches it, with omniORBpy.

Needs the package jeteve-omniorb and stubs from its omniidl; see Documentation/corba.md.
"""

import argparse
import contextlib
import os
import pathlib
import sys
import time

from omniORB import CORBA

import LMS3D

# Longer than the server's longest wait, so that only a server that hangs exceeds it.
ORB_OPTIONS = ["-ORBclientCallTimeOutPeriod", "15000"]
WAIT_MILLISECONDS = 10_000
# The interval of checks if the server has no place for another waiting call.
PAUSE_SECONDS = 0.5
# Beams, points or triangles per message. 50,000 points are 1.2 MB; a message has 2 MiB at most.
PART = 50_000
MAXIMUM_TRIES = 5


def connect(reference):
    """Return the scanner of an IOR or a corbaloc."""
    orb = CORBA.ORB_init(ORB_OPTIONS)
    scanner = orb.string_to_object(reference)._narrow(LMS3D.LaserScanner)
    if scanner is None:
        raise ValueError(f"the object at {reference} is not a scanner of LMS3D")
    return scanner


def move(scanner, position):
    """Move the sensor and return the generation of its scans."""
    pose = scanner.getPose()
    pose.position = LMS3D.Vector3(*position)
    return scanner.setPose(pose)


def get_parts(operation, number, count):
    """Return all elements of scan `number` from an operation that returns parts."""
    elements = []
    for first in range(0, count, PART):
        elements += operation(number, first, min(PART, count - first))
    return elements


def wait_once(scanner, after, generation):
    """Return the header of the next scan, or raise NoScanYet.

    If the server has no place for another waiting call, pause and then check the newest scan.
    """
    try:
        return scanner.waitForScan(after, generation, WAIT_MILLISECONDS)
    except LMS3D.LimitExceeded:
        time.sleep(PAUSE_SECONDS)
    header = scanner.getHeader()
    if header.number <= after or header.generation < generation:
        raise LMS3D.NoScanYet(header.number)
    return header


def wait_for_scan(scanner, after=0, generation=0):
    """Return the header of the next scan. Wait as long as the server lives and makes scans."""
    while True:
        try:
            return wait_once(scanner, after, generation)
        except LMS3D.NoScanYet:
            status = scanner.getStatus()
            if status.problem:
                raise ValueError(f"the server has no scan: {status.problem}") from None
            if status.newest < after or status.generation < generation:
                raise ValueError("the server was restarted") from None


def take_scan(scanner, generation=0):
    """Return the newest scan of a generation: header, ranges, the map's coordinates and triangles.

    The server drops old scans, so a slow client may have to try again.
    """
    for attempt in range(1, MAXIMUM_TRIES + 1):
        header = wait_for_scan(scanner, generation=generation)
        try:
            return (header,
                    get_parts(scanner.getRanges, header.number, header.beams),
                    get_parts(scanner.getMapPoints, header.number, header.mapPoints),
                    get_parts(scanner.getMapTriangles, header.number, header.mapTriangles))
        except LMS3D.ScanGone:
            if attempt == MAXIMUM_TRIES:
                raise


def get_angles(axis):
    """Return the angles of an axis in degrees, as LMS3DScanner.idl defines them."""
    is_circle = abs(axis.stop - axis.start - 360) <= 1e-6
    steps = max(1, axis.count if is_circle else axis.count - 1)
    return [axis.start + (axis.stop - axis.start) * i / steps for i in range(axis.count)]


def print_beams(header, ranges):
    """Print range, alpha and beta of each beam."""
    beams = iter(ranges)
    elevations = get_angles(header.settings.alpha)
    for turn in get_angles(header.settings.beta):
        for elevation in elevations:
            print(next(beams), elevation, turn, sep="\t")


def write_map(path, coordinates, numbers):
    """Write a local map as a Wavefront OBJ file, which counts points from 1.

    Write a temporary file and rename it, so that the map is complete or not there.
    """
    temporary = path.with_name(f".{path.stem}.{os.getpid()}{path.suffix}")
    try:
        with open(temporary, "w", encoding="ascii") as file:
            for i in range(0, len(coordinates), 3):
                print("v", *coordinates[i:i + 3], file=file)
            for i in range(0, len(numbers), 3):
                print("f", *(number + 1 for number in numbers[i:i + 3]), file=file)
        os.replace(temporary, path)
    except OSError as problem:
        raise ValueError(f"cannot write '{path}': {problem.strerror}") from problem
    finally:
        with contextlib.suppress(OSError):
            temporary.unlink()


def fetch(scanner, _):
    """Print range, alpha and beta of each beam, with the paper's interface."""
    triples = scanner.fetch()
    for i in range(0, len(triples), 3):
        print(*triples[i:i + 3], sep="\t")


def scan(scanner, options):
    """Print the same for a scan of a given device from a given position, and save its local map."""
    generation = scanner.selectPreset(options.device) if options.device else 0
    generation = move(scanner, options.position) if options.position else generation
    header, ranges, coordinates, numbers = take_scan(scanner, generation)
    if generation not in (0, header.generation):
        raise ValueError("another client has changed the settings meanwhile")
    if options.map:
        write_map(options.map.resolve(), coordinates, numbers)
    print_beams(header, ranges)


def watch(scanner, options):
    """Print a line for each scan as soon as it is made."""
    last = 0
    for _ in range(options.count):
        header = wait_for_scan(scanner, after=last)
        print(f"scan {header.number}, generation {header.generation}, of {header.scene}: "
              f"{header.returns} of {header.beams} beams returned", flush=True)
        last = header.number


def take_changes(scanner, since):
    """Return what changed in the map of all poses since a state: header, regions, points, triangles."""
    for attempt in range(1, MAXIMUM_TRIES + 1):
        header = scanner.getFusedMapHeader(since)

        def get(operation, count, number=header.number):
            return get_parts(lambda *part: operation(number, since, *part[1:]), number, count)

        try:
            return (header, get(scanner.getFusedRegions, header.regions),
                    get(scanner.getFusedPoints, header.points),
                    get(scanner.getFusedTriangles, header.triangles))
        except LMS3D.FusedMapGone:
            if attempt == MAXIMUM_TRIES:
                raise


def follow_map(scanner, regions, since):
    """Bring the regions of a map up to date, and return the header: id -> points, triangles."""
    header, changed, points, triangles = take_changes(scanner, since)
    if header.isWhole:
        regions.clear()
    for region in changed:
        regions[region.id] = points[:3 * region.points], triangles[:3 * region.triangles]
        del points[:3 * region.points], triangles[:3 * region.triangles]
        if not region.triangles:
            del regions[region.id]
    return header


def grow(scanner, options):
    """Move to one position after the other, and save the map of all poses. Only changes are fetched."""
    regions, since = {}, 0
    for start in range(0, len(options.positions), 3):
        wait_for_scan(scanner, generation=move(scanner, options.positions[start:start + 3]))
        header = follow_map(scanner, regions, since)
        since = header.number
        size = 12 * (header.regions + header.points + header.triangles)
        print(f"{header.scans} scans, {header.allTriangles} triangles, {size} bytes", flush=True)
    origin = header.origin.x, header.origin.y, header.origin.z
    coordinates, numbers = [], []
    for _, (points, triangles) in sorted(regions.items()):
        first = len(coordinates) // 3
        coordinates += [origin[i % 3] + offset for i, offset in enumerate(points)]
        numbers += [first + number for number in triangles]
    write_map(options.map.resolve(), coordinates, numbers)


def parse_arguments():
    """Parse the scanner, the command and its options."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scanner", help="an IOR or a corbaloc")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    for command in (fetch, scan, watch, grow):
        words = commands.add_parser(command.__name__, help=command.__doc__)
        words.set_defaults(run=command)
        if command is scan:
            words.add_argument("--position", type=float, nargs=3, metavar=("X", "Y", "Z"),
                               help="move the sensor there first, metres")
            words.add_argument("--device", metavar="NAME",
                               help="select a preset first, such as lms200-mm or ideal")
            words.add_argument("--map", type=pathlib.Path, metavar="FILE.obj")
        if command is grow:
            words.add_argument("map", type=pathlib.Path, metavar="FILE.obj")
            words.add_argument("positions", type=float, nargs="+", metavar="X Y Z",
                               help="where the sensor goes, metres")
        if command is watch:
            words.add_argument("count", type=int)
    return parser.parse_args()


def main():
    """Run one command."""
    options = parse_arguments()
    try:
        options.run(connect(options.scanner), options)
    except (LMS3D.InvalidArgument, LMS3D.NoFusedMap) as problem:
        sys.exit(f"{type(problem).__name__}: {problem.reason}")
    except ValueError as problem:
        sys.exit(str(problem))
    except (CORBA.Exception, OSError) as problem:
        sys.exit(repr(problem))


if __name__ == "__main__":
    main()
