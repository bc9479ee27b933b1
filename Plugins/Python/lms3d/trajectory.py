# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""A moving sensor: one scan for each pose of a trajectory, written as ParaView's .pvd series."""

import os
import shutil
from pathlib import Path
from xml.sax.saxutils import quoteattr

from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

from .execution import update
from .interruption import interruptible
from .problems import UsageProblem
from .results import check_writable, save, writing


class TrajectoryScan:
    """Scans a simulation from each pose of a trajectory. `times` are the times of the poses."""

    def __init__(self, simulation, trajectory):
        self._simulation = simulation
        simulation.sensor.SetTrajectoryData(trajectory)
        simulation.sensor.UpdateInformation()
        information = simulation.sensor.GetOutputInformation(0)
        self.times = information.Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()) or ()
        if not self.times:
            simulation.run()  # raises Problem, with the error in the trajectory
        self.returns = []

    def run(self, with_map=False):
        """Scan from each pose; yields its time when the simulation has its scan and map.

        A simulation with a fusion joins the maps on the way.
        """
        works = self._simulation.steps
        fusion = self._simulation.fusion
        if with_map or fusion:
            works.append(
                (self._simulation.reconstruction, "mapping", "cannot build the local map"))
        if fusion:
            works.append((fusion, "joining", "cannot join the map of this pose to the others"))
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
    """Raise UsageProblem if the files of two series would have the same names."""
    known = {}
    for path in paths:
        other = known.setdefault(Path(path).resolve().with_suffix(""), path)
        if other != path:
            raise UsageProblem(f"the steps of '{other}' and of '{path}' would have the same names: "
                               "choose names that differ before the ending")


class Series:
    """Files of one result: NAME_0000.vtp and so on beside NAME.pvd, which lists them.

    A context manager, which deletes the files that have not got their names. The constructor raises
    Problem if a file cannot be written.
    """

    def __init__(self, path, steps, inputs):
        self._path = Path(path).resolve()
        self._names = [f"{self._path.stem}_{i:0{max(4, len(str(steps - 1)))}}.vtp"
                       for i in range(steps)]
        self._folder = self._path.with_name(f".{self._path.stem}.{os.getpid()}")
        self._times = []
        self._check_files(inputs)

    def _check_files(self, inputs):
        taken = {Path(given).resolve(): given for given in inputs}
        for path in map(self._path.with_name, self._names):
            if path in taken:
                raise UsageProblem(f"'{taken[path]}' would be replaced by a step of "
                                   f"'{self._path}': choose another name")
            check_writable(f"step of '{self._path.name}'", path)

    def __enter__(self):
        with writing(self._path):
            self._folder.mkdir()
        return self

    def add(self, data, time):
        """Write the result of the next step."""
        name = self._names[len(self._times)]
        save(data, self._folder / name, shown=self._path.with_name(name))
        self._times.append(time)

    def finish(self, files):
        """Give all files to ResultFiles, the list last."""
        self._write_list()
        for name in (*self._names, self._path.name):
            files.add(self._folder / name, self._path.with_name(name))

    def __exit__(self, *_):
        with interruptible(lambda: None):
            shutil.rmtree(self._folder, ignore_errors=True)

    def _write_list(self):
        entries = "".join(f'    <DataSet timestep="{time!r}" file={quoteattr(name)}/>\n'
                          for time, name in zip(self._times, self._names))
        with writing(self._path):
            (self._folder / self._path.name).write_text(
                '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n'
                f"  <Collection>\n{entries}  </Collection>\n</VTKFile>\n", encoding="utf-8")
