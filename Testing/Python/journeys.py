# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A trajectory of three poses in the room, and what a command writes for each of them."""

from xml.etree import ElementTree

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from command_line import CommandLineTest, read, write

PLACES = np.array(((-1.0, 0.0, 1.0), (0.0, 0.5, 1.0), (0.3, -0.2, 1.0)))


def trajectory(line=False, **arrays):
    """Poses at PLACES with point arrays."""
    poses = vtkPolyData()
    poses.SetPoints(vtkPoints())
    poses.GetPoints().SetDataTypeToDouble()
    for place in PLACES:
        poses.GetPoints().InsertNextPoint(place)
    if line:
        poses.SetLines(vtkCellArray())
        poses.GetLines().InsertNextCell(len(PLACES), range(len(PLACES)))
    for name, values in arrays.items():
        values = numpy_to_vtk(np.asarray(values, dtype=float), deep=True)
        values.SetName(name)
        poses.GetPointData().AddArray(values)
    return poses


class TrajectoryTest(CommandLineTest):
    """Writes trajectories, and deletes all files after each test."""

    def path(self, **options):
        """The file of a trajectory."""
        path = self.folder / "path.vtp"
        write(vtkXMLPolyDataWriter(), trajectory(**options), path)
        return path

    def steps(self, name):
        """What a .pvd lists: times, and the data of each step."""
        listed = ElementTree.parse(self.folder / name).getroot().findall("Collection/DataSet")
        return ([float(entry.get("timestep")) for entry in listed],
                [read(vtkXMLPolyDataReader(), self.folder / entry.get("file")) for entry in listed])

    def tearDown(self):
        for path in self.folder.iterdir():
            path.rmdir() if path.is_dir() else path.unlink()
