#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Make images/mrpt_map.png: the map that MRPT's programs make while an emulated LMS 200 drives.

    apt-get install mrpt-apps
    ./run python Documentation/make_mrpt_picture.py

rawlog-grabber reads the fans with MRPT's own driver, and icp-slam estimates the way and the map from
the fans alone. The sensor drives through Data/building.wrl with a level fan.
"""

import math
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from lms3d.results import save
from lms3d.scene import read_data
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkImagingCore import vtkExtractVOI

ROOT = Path(__file__).resolve().parents[1]
SCENE, JOURNEY = ROOT / "Data/building.wrl", ROOT / "Data/building_journey.vtp"
PICTURE = ROOT / "Documentation/images/mrpt_map.png"

FANS_PER_POSE = 5  # of the journey
AHEAD = 15  # the sensor looks to the place that it reaches this many fans later
FASTEST_TURN = 0.05  # radians from fan to fan
FANS_PER_SECOND = 37.5
MARGIN = 20  # pixels around the known cells

DRIVER = """
driver = CSickLaserSerial
sensorLabel = LMS200
process_rate = 100
COM_port_LIN = {port}
COM_baudRate = 500000
mm_mode = 1
FOV = 180
resolution = 50
pose_x = 0
pose_y = 0
pose_z = 0
pose_yaw = 0
pose_pitch = 0
pose_roll = 0
"""

GRABBER = """
[global]
rawlog_prefix = drive
time_between_launches = 300
use_sensoryframes = 0
GRABBER_PERIOD_MS = 100
[LMS200]
""" + DRIVER

SLAM = """
[ICP]
maxIterations = 80
minAbsStep_trans = 1e-6
minAbsStep_rot = 1e-6
thresholdDist = 0.3
thresholdAng_DEG = 5
ALFA = 0.8
smallestThresholdDist = 0.05
onlyClosestCorrespondences = true
onlyUniqueRobust = true
ICP_algorithm = icpClassic
corresponding_points_decimation = 2
[MappingApplication]
rawlog_file = {rawlog}
rawlog_offset = 0
logOutput_dir = log
LOG_FREQUENCY = 100000
SAVE_3D_SCENE = 0
SAVE_POSE_LOG = 0
SHOW_PROGRESS_3D_REAL_TIME = 0
SHOW_PROGRESS_3D_REAL_TIME_DELAY_MS = 0
CAMERA_3DSCENE_FOLLOWS_ROBOT = 0
SHOW_LASER_SCANS_3D = 0
localizationLinDistance = 0.1
localizationAngDistance = 2
insertionLinDistance = 0.2
insertionAngDistance = 5
minICPgoodnessToAccept = 0.3
matchAgainstTheGrid = 0
occupancyGrid_count = 1
pointsMap_count = 1
likelihoodMapSelection = -1
[MappingApplication_occupancyGrid_00_creationOpts]
resolution = 0.025
[MappingApplication_pointsMap_00_insertOpts]
minDistBetweenLaserPoints = 0.03
isPlanarMap = 1
"""


def make_places():
    """The places of the fans, and the yaw angle of the sensor at each."""
    journey = vtk_to_numpy(read_data(JOURNEY, "trajectory").GetPoints().GetData())
    steps = np.arange(0, len(journey) - 1, 1 / FANS_PER_POSE)
    places = np.stack(
        [np.interp(steps, range(len(journey)), journey[:, axis]) for axis in range(3)], axis=1)
    ways = places[AHEAD:] - places[:-AHEAD]
    wanted = np.unwrap(np.arctan2(ways[:, 1], ways[:, 0]))
    yaws = [wanted[0]]
    for angle in wanted[1:]:
        yaws.append(yaws[-1] + np.clip(angle - yaws[-1], -FASTEST_TURN, FASTEST_TURN))
    return places[:-AHEAD], yaws


def save_drive(file):
    """A trajectory on which the fan is level and begins at the right. Returns its number of fans."""
    places, yaws = make_places()
    half = math.sqrt(0.5)  # the sensor's z axis points to the left: a roll of -90 degrees
    turns = np.array([(half * math.cos(yaw / 2), -half * math.cos(yaw / 2),
                       -half * math.sin(yaw / 2), half * math.sin(yaw / 2)) for yaw in yaws])
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    drive = vtkPolyData()
    drive.SetPoints(points)
    orientations = numpy_to_vtk(turns, deep=True)
    orientations.SetName("Orientation")
    drive.GetPointData().AddArray(orientations)
    save(drive, file)
    return len(places)


def run_mrpt(program, folder, settings, seconds):
    """Run a program of MRPT until it ends. After the seconds it gets the key that ends it."""
    file = folder / f"{program}.ini"
    file.write_text(settings)
    with open(folder / f"{program}.log", "w", encoding="utf-8") as log:
        process = subprocess.Popen([program, file.name], cwd=folder, text=True,
                                   stdin=subprocess.PIPE, stdout=log, stderr=log)
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            process.communicate("\n")


def grab(folder, trajectory, fans):
    """Drive, and return the file in which MRPT's driver has stored the fans."""
    port = folder / "lms200"
    emulator = subprocess.Popen([
        sys.executable, "-m", "lms3d", "emulate", SCENE, "--trajectory", trajectory,
        "--beta-range", "0", "0", "--beta-resolution", "1", "--device", "lms200-mm", "--link", port])
    try:
        while not port.exists() and emulator.poll() is None:
            time.sleep(0.1)
        run_mrpt("rawlog-grabber", folder, GRABBER.format(port=port), 5 + fans / FANS_PER_SECOND)
    finally:
        emulator.terminate()
        emulator.wait()
    return next(folder.glob("drive*.rawlog"))


def save_known(grid):
    """Save the part of a picture of a grid map around the cells that a beam has reached."""
    reader, part = vtkPNGReader(), vtkExtractVOI()
    reader.SetFileName(str(grid))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    grey = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width)
    rows, columns = np.nonzero(grey != grey[0, 0])
    part.SetInputConnection(reader.GetOutputPort())
    part.SetVOI(max(columns.min() - MARGIN, 0), min(columns.max() + MARGIN, width - 1),
                max(rows.min() - MARGIN, 0), min(rows.max() + MARGIN, height - 1), 0, 0)
    part.Update()
    save(part.GetOutput(), PICTURE, "picture")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        trajectory = folder / "drive.vtp"
        rawlog = grab(folder, trajectory, save_drive(trajectory))
        run_mrpt("icp-slam", folder, SLAM.format(rawlog=rawlog.name), 600)
        save_known(next((folder / "log").glob("*GridMap2D*.png")))


if __name__ == "__main__":
    main()
