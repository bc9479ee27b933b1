# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A sensor on its way: one scan for each pose of a trajectory, written as ParaView's .pvd series."""

import os
import shutil
from pathlib import Path
from xml.sax.saxutils import quoteattr

from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

from .execution import update
from .problems import Problem, UsageProblem
from .results import save, save_text


class Journey:
    """The scans of a simulation whose sensor follows a trajectory, one after the other."""

    def __init__(self, simulation, trajectory):
        self._simulation = simulation
        simulation.sensor.SetTrajectoryData(trajectory)
        simulation.sensor.UpdateInformation()
        information = simulation.sensor.GetOutputInformation(0)
        self.times = information.Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()) or ()
        if not self.times:
            simulation.run()  # tells what is wrong with the trajectory
        self.returns = []

    def scans(self, with_map=False):
        """Go from pose to pose; the simulation holds the scan, and the map, of each time given."""
        works = [(self._simulation.sensor, "scanning", "cannot scan")]
        if with_map:
            works.append(
                (self._simulation.reconstruction, "mapping", "cannot build the local map"))
        whole = len(self.times) * len(works)
        done = 0
        for step, time in enumerate(self.times, 1):
            for algorithm, label, failure in works:
                update(algorithm, f"{label} {step}", failure, time=time,
                       share=(done / whole, (done + 1) / whole))
                done += 1
            self.returns.append(self._simulation.returns)
            yield time


class Series:
    """Files of one result, NAME_0000.vtp and so on beside NAME.pvd, which lists them.

    Used in a ``with`` block, at whose good end they all appear; after a failure there is nothing, and
    what was there before is still there.
    """

    def __init__(self, path, steps, inputs):
        self._path = Path(path).resolve()
        self._names = [f"{self._path.stem}_{i:0{max(4, len(str(steps - 1)))}}.vtp"
                       for i in range(steps)]
        self._folder = self._path.with_name(f".{self._path.stem}.{os.getpid()}")
        self._times = []
        taken = {self._path.with_name(name) for name in self._names}
        for given in inputs:
            if Path(given).resolve() in taken:
                raise UsageProblem(f"'{given}' would be replaced by a step of '{path}': "
                                   "choose another name")

    def __enter__(self):
        try:
            self._folder.mkdir()
        except OSError as error:
            raise Problem(f"cannot write '{self._path}': {error.strerror}") from error
        return self

    def add(self, data, time):
        """Write the result of the next step."""
        save(data, self._folder / self._names[len(self._times)])
        self._times.append(time)

    def __exit__(self, failure, *_):
        try:
            if failure is None:
                self._publish()
        finally:
            shutil.rmtree(self._folder, ignore_errors=True)

    def _publish(self):
        for name in self._names:
            os.replace(self._folder / name, self._path.with_name(name))
        entries = "".join(f'    <DataSet timestep="{time!r}" file={quoteattr(name)}/>\n'
                          for time, name in zip(self._times, self._names))
        save_text('<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n'
                  f"  <Collection>\n{entries}  </Collection>\n</VTKFile>\n", self._path)
