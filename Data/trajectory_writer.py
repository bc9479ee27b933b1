# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Write the poses of a moving sensor as a readable .vtp file: a polyline with the array Time."""

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


def trajectory(places):
    """The text of the file: the sensor is at the first place at 0 s, at the next at 1 s, and so on."""
    points = ["{:.4g} {:.4g} {:.4g}".format(*place) for place in places]
    numbers = " ".join(map(str, range(len(points))))
    return FILE.format(count=len(points), times=numbers, points="\n          ".join(points),
                       indices=numbers)
