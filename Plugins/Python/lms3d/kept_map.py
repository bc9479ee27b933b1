# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The map of all that a moving sensor has seen, for a window."""

from . import vtkLMS3DMapFusion
from .messages import VTKMessages


class KeptMap:
    """Joins the local maps of a simulation. `port` is the output port of the map."""

    def __init__(self, simulation):
        simulation.find_lost_beams()
        self._simulation = simulation
        self._fusion = vtkLMS3DMapFusion()
        self._fusion.SetMaximumError(simulation.reconstruction.GetMaximumError())
        self._fusion.SetNumberOfThreads(simulation.sensor.GetNumberOfThreads())
        self._last_added = None
        self._problem = ""

    @property
    def port(self):
        """The output port of the map."""
        return self._fusion.GetOutputPort()

    def grow(self):
        """Add what the sensor sees now, unless it was added before."""
        made = self._simulation.map.GetMTime()
        if made == self._last_added:
            return
        self._last_added = made
        with VTKMessages() as messages:
            self._fusion.AddScan(self._simulation.map, self._simulation.scan)
        self._problem = " ".join(messages.errors)

    def describe(self):
        """What the window says of the map."""
        if self._problem:
            return self._problem
        self._fusion.Update()
        return describe_kept(self._fusion.GetNumberOfScans(), self._fusion.GetOutput().GetNumberOfCells())


def describe_kept(scans, triangles):
    """What a window says of a map of many scans."""
    return f"kept: {scans:,} scan{'s' * (scans != 1)}, {triangles:,} triangles"
