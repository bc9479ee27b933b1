# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""The VTK pipeline of a simulation: a scene, the sensor that scans it, and the local map."""

import time
from dataclasses import dataclass, field
from typing import Optional

from vtkmodules.util.numpy_support import vtk_to_numpy

from . import (
    vtkLMS3DMapFusion,
    vtkLMS3DRangeErrorFilter,
    vtkLMS3DScanFilter,
    vtkLMS3DSurfaceReconstructionFilter,
)
from .execution import update
from .problems import Problem
from .scene import Scene


@dataclass
class Simulation:
    """A sensor in a scene and the local map of what it sees.

    `sensor` and `reconstruction` are connected VTK filters: set the properties of sensor and map
    there. `scan`, `range_image` and `map` are their outputs. `errors` is None, or the filter between
    them that `add_errors` made; then scan, range image and map have reported ranges. `fusion` is None,
    or the filter that `add_fusion` connected, which joins the maps of many poses.
    """

    scene: Scene
    sensor: vtkLMS3DScanFilter = field(default_factory=vtkLMS3DScanFilter)
    reconstruction: vtkLMS3DSurfaceReconstructionFilter = field(
        default_factory=vtkLMS3DSurfaceReconstructionFilter
    )
    errors: Optional[vtkLMS3DRangeErrorFilter] = field(default=None, init=False)
    fusion: Optional[vtkLMS3DMapFusion] = field(default=None, init=False)

    def __post_init__(self):
        self.sensor.SetInputDataObject(self.scene.data)
        self.reconstruction.SetInputConnection(self.sensor.GetOutputPort())

    def add_errors(self, errors):
        """Put a filter that adds errors to ranges between sensor and map."""
        self.errors = errors
        self.errors.SetInputConnection(self.sensor.GetOutputPort())
        self.reconstruction.SetInputConnection(self.errors.GetOutputPort())

    def add_fusion(self, fusion):
        """Let a filter join the maps of all poses that it is updated for; call add_errors before."""
        self.find_lost_beams()
        self.fusion = fusion
        fusion.SetInputConnection(self.reconstruction.GetOutputPort())
        fusion.SetScanConnection(self._last.GetOutputPort())

    def find_lost_beams(self):
        """Let scans have Status if beams that meet a surface may give no return.

        Fused maps open where beams met nothing.
        """
        if self.may_lose_beams or self.errors:
            self.sensor.SetComputeStatus(True)

    @property
    def may_lose_beams(self):
        """Whether the sensor may give no return of a surface, which is too dark or too near."""
        return self.sensor.GetRangeAtTenPercent() > 0 or self.sensor.GetMinimumRange() > 0

    @property
    def steps(self):
        """What makes a scan: VTK filters, each with its label and the beginning of its errors."""
        steps = [(self.sensor, "scanning", "cannot scan")]
        if self.errors:
            steps.append((self.errors, "adding errors", "cannot add errors to the ranges"))
        return steps

    @property
    def scan(self):
        """The returns as vtkPolyData, one vertex each."""
        return self._last.GetOutput()

    @property
    def range_image(self):
        """The grid of all ranges as vtkImageData (metres, NaN: no return)."""
        return self._last.GetOutputDataObject(1)

    @property
    def map(self):
        """The local map as vtkPolyData: triangles that face the sensor."""
        return self.reconstruction.GetOutput()

    @property
    def fused_map(self):
        """The one map of all poses as vtkPolyData."""
        return self.fusion.GetOutput()

    @property
    def beams(self):
        """Number of beams of one scan."""
        return self.sensor.GetAlphaResolution() * self.sensor.GetBetaResolution()

    @property
    def returns(self):
        """Number of returns."""
        return self.scan.GetNumberOfPoints()

    def ranges(self):
        """The measured ranges in metres, as a numpy view."""
        return vtk_to_numpy(self.scan.GetPointData().GetArray("Range"))

    def run(self):
        """Scan; raises Problem if VTK reports an error or no beam returns."""
        for algorithm, label, failure in self.steps:
            update(algorithm, label, failure)
        if self.returns == 0:
            raise Problem(self._no_return())

    def reconstruct(self):
        """Build the local map of the scan."""
        update(self.reconstruction, "mapping", "cannot build the local map")

    def scan_time(self, repetitions=5):
        """Shortest time of a scan right after a move of the sensor, in seconds.

        Call `run` before, since it reports errors. The scan is the same afterwards.
        """
        x, y, z = self.sensor.GetPosition()
        times = []
        for _ in range(repetitions):
            for height in (z + 1e-3, z):
                self.sensor.SetPosition(x, y, height)
                start = time.perf_counter()
                self.sensor.Update()
                times.append(time.perf_counter() - start)
        return min(times)

    @property
    def _last(self):
        return self.errors or self.sensor

    def _no_return(self):
        if self.sensor.GetOutput().GetNumberOfPoints() > 0:
            return ("no range is above 0 after the errors of the device: choose a larger bias, or a "
                    "smaller resolution")
        bounds = self.scene.surface.GetBounds()
        box = " x ".join(f"{a:.3g}..{b:.3g}" for a, b in zip(bounds[::2], bounds[1::2]))
        position = " ".join(f"{x:g}" for x in self.sensor.GetPosition())
        return (
            f"no beam returned to the sensor at {position}: the scene fills {box} m and the sensor "
            f"measures {self.sensor.GetMinimumRange():g} to {self.sensor.GetMaximumRange():g} m; "
            "move the sensor, widen its ranges or angles, or choose a device that sees darker "
            "surfaces"
        )
