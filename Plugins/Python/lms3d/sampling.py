# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the errors that coarse scans and coarse maps of a scene cause."""

from dataclasses import dataclass
from typing import Optional

from .comparison import Comparison, compare
from .execution import update

_LABEL = "measuring"

# The approximate progress of a measurement after the scan and after the map.
_SCANNED, _MAPPED = 0.1, 0.3


@dataclass(frozen=True)
class Sample:
    """A scan with equal steps, its local map within a bound, and the map's errors.

    `step` is in degrees; the steps of both angles are the nearest ones that divide their ranges.
    `maximum_error` is the map's bound, metres. `comparison` is None if there are too few returns
    for a map.
    """

    step: float
    alpha_resolution: int
    beta_resolution: int
    maximum_error: float
    returns: int
    comparison: Optional[Comparison]

    def meets(self, share):
        """Whether a share of the map, and of the visible scene, is within the tolerance."""
        return self._quality() >= share

    def is_better_than(self, other):
        """Whether a larger share is within the tolerance than in another sample."""
        return self._quality() > other._quality()

    def _quality(self):
        if self.comparison is None:
            return 0.0
        return min(self.comparison.correctness, self.comparison.completeness)


def set_steps(sensor, step):
    """Set both resolutions of the sensor for a step in degrees, rounded to divide the ranges."""
    low, high = sensor.GetAlphaRange()
    sensor.SetAlphaResolution(_count((high - low) / step) + 1)
    low, high = sensor.GetBetaRange()
    # A full circle excludes its end, which equals its start.
    sensor.SetBetaResolution(_count((high - low) / step) + (high - low < 360))


def _count(steps):
    return max(1, round(steps))


def measure(simulation, step, maximum_error, tolerance, samples=None, share=(0.0, 1.0)):
    """Scan from the sensor's pose, map, and compare; returns a Sample or raises Problem.

    The simulation keeps the properties that this sets. `tolerance` is in metres, `samples` the
    number of points on each surface, `share` the start and end of the progress bar's part.
    """
    sensor, reconstruction = simulation.sensor, simulation.reconstruction
    set_steps(sensor, step)
    reconstruction.SetMaximumError(maximum_error)
    start, end = share
    scanned, mapped = (start + part * (end - start) for part in (_SCANNED, _MAPPED))
    update(sensor, _LABEL, "cannot scan", share=(start, scanned))
    update(reconstruction, _LABEL, "cannot build the local map", share=(scanned, mapped))
    comparison = None
    if simulation.map.GetNumberOfPolys() > 0:
        comparison = compare(simulation.map, simulation.scene.data, None, tolerance, samples,
                             (sensor.GetMinimumRange(), sensor.GetMaximumRange()),
                             sensor.GetNumberOfThreads(), _LABEL, (mapped, end))
    return Sample(step, sensor.GetAlphaResolution(), sensor.GetBetaResolution(), maximum_error,
                  simulation.returns, comparison)


def steps_down_to(finest, coarsest=8.0):
    """Steps from the coarsest to the finest, degrees, each about 3/4 of the previous one."""
    steps = []
    half = coarsest
    while half > finest * (1 + 1e-9):
        steps += [x for x in (half, 0.75 * half) if x > finest * (1 + 1e-9)]
        half /= 2
    return steps + [finest]


def advise(simulation, tolerance, share, finest, samples=None):
    """Find the first Sample that meets a tolerance: the coarsest step, with its largest bound.

    Tries steps from coarse to fine, and for each step bounds from 8 times the tolerance down to 1/8
    of it. Returns that Sample or None, and the best Sample that misses the tolerance or None if no
    scan gave a map.
    """
    bounds = [tolerance * factor for factor in (8, 4, 2, 1, 0.5, 0.25, 0.125)]
    trials = [(step, bound) for step in steps_down_to(finest) for bound in bounds]
    best = None
    # All trials take about the same time, because the comparison takes most of it.
    for number, (step, bound) in enumerate(trials):
        part = (number / len(trials), (number + 1) / len(trials))
        sample = measure(simulation, step, bound, tolerance, samples, part)
        if sample.meets(share):
            return sample, best
        if sample.comparison and (best is None or sample.is_better_than(best)):
            best = sample
    return None, best
