#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Make journey.vtp: a robot drives through room.wrl and the doorway into the smaller room.

    python3 Data/make_journey.py

The file holds a polyline of 17 poses: the sensor is 1 m above the floor and moves 0.5 m to the east
each second. LMS3D Scan and `lms3d scan --trajectory` accept it as a trajectory.
"""

from pathlib import Path

POSES = 17
START_X, STEP, HEIGHT = -2.5, 0.5, 1.0

# From x = -2.5 to 2.5, on the way to the doorway, the robot turns to the north.
SOUTH, NORTH, BEND = -1.2, 0.75, 5.0

FILE = """\
<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian">
  <PolyData>
    <Piece NumberOfPoints="{count}" NumberOfVerts="0" NumberOfLines="1" NumberOfStrips="0"\
 NumberOfPolys="0">
      <PointData>
        <DataArray type="Float64" Name="Time" format="ascii">{times}</DataArray>
      </PointData>
      <Points>
        <DataArray type="Float64" NumberOfComponents="3" format="ascii">
          {points}
        </DataArray>
      </Points>
      <Lines>
        <DataArray type="Int64" Name="connectivity" format="ascii">{indices}</DataArray>
        <DataArray type="Int64" Name="offsets" format="ascii">{count}</DataArray>
      </Lines>
    </Piece>
  </PolyData>
</VTKFile>
"""


def place(i):
    """The sensor's position at pose i, metres."""
    share = min(i * STEP / BEND, 1.0)
    smooth = share * share * (3.0 - 2.0 * share)
    return (START_X + i * STEP, SOUTH + (NORTH - SOUTH) * smooth, HEIGHT)


def main():
    """Write the file beside this script."""
    points = ("{:.4g} {:.4g} {:.4g}".format(*place(i)) for i in range(POSES))
    text = FILE.format(count=POSES, times=" ".join(f"{i}" for i in range(POSES)),
                       points="\n          ".join(points), indices=" ".join(map(str, range(POSES))))
    Path(__file__).with_name("journey.vtp").write_text(text)


main()
