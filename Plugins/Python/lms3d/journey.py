# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A sensor on its way: one scan for each pose of a trajectory, written as ParaView's .pvd series."""

import os
import shutil
from pathlib import Path
from xml.sax.saxutils import quoteattr

from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

from .execution import update
from .problems import UsageProblem
from .results import check_place, save, save_text, writing


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


def check_names(paths):
    """Make sure that no two series would have steps of the same names."""
    known = {}
    for path in paths:
        other = known.setdefault(Path(path).resolve().with_suffix(""), path)
        if other != path:
            raise UsageProblem(f"the steps of '{other}' and of '{path}' would have the same names: "
                               "choose names that differ before the ending")


class Series:
    """Files of one result, NAME_0000.vtp and so on beside NAME.pvd, which lists them.

    Used in a ``with`` block, at whose good end the files take their places, one after the other and
    the list last; after a failure in the block nothing has changed. Raises Problem at once where a
    step could not take its place.
    """

    def __init__(self, path, steps, inputs):
        self._path = Path(path).resolve()
        self._names = [f"{self._path.stem}_{i:0{max(4, len(str(steps - 1)))}}.vtp"
                       for i in range(steps)]
        self._folder = self._path.with_name(f".{self._path.stem}.{os.getpid()}")
        self._times = []
        self._check_places(inputs)

    def _check_places(self, inputs):
        taken = {Path(given).resolve(): given for given in inputs}
        for place in map(self._path.with_name, self._names):
            if place in taken:
                raise UsageProblem(f"'{taken[place]}' would be replaced by a step of "
                                   f"'{self._path}': choose another name")
            check_place(f"step of '{self._path.name}'", place)

    def __enter__(self):
        with writing(self._path):
            self._folder.mkdir()
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
            place = self._path.with_name(name)
            with writing(place):
                os.replace(self._folder / name, place)
        entries = "".join(f'    <DataSet timestep="{time!r}" file={quoteattr(name)}/>\n'
                          for time, name in zip(self._times, self._names))
        save_text('<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n'
                  f"  <Collection>\n{entries}  </Collection>\n</VTKFile>\n", self._path)
