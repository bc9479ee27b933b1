# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""What coarse scans and coarse maps of a scene cost in error, by measuring."""

from dataclasses import dataclass
from typing import Optional

from .comparison import Comparison, compare
from .execution import update

_LABEL = "measuring"

# How much of a measurement's time its parts take, about.
_SCANNED, _MAPPED = 0.1, 0.3


@dataclass(frozen=True)
class Sample:
    """A scan with equal steps, its local map within a bound, and the map's errors.

    `step` is in degrees; the steps of both angles are the nearest to it that divide their ranges.
    `maximum_error` is the map's bound, metres. `comparison` is None where the returns were too few
    for a map.
    """

    step: float
    alpha_resolution: int
    beta_resolution: int
    maximum_error: float
    returns: int
    comparison: Optional[Comparison]

    def meets(self, share):
        """Whether such a share both of the map and of the visible scene is within the tolerance."""
        return self._quality() >= share

    def is_better_than(self, other):
        """Whether it comes nearer to meeting a tolerance than another."""
        return self._quality() > other._quality()

    def _quality(self):
        if self.comparison is None:
            return 0.0
        return min(self.comparison.correctness, self.comparison.completeness)


def set_steps(sensor, step):
    """Give both angles of the sensor steps of nearly so many degrees, within their ranges."""
    low, high = sensor.GetAlphaRange()
    sensor.SetAlphaResolution(_count((high - low) / step) + 1)
    low, high = sensor.GetBetaRange()
    # The end of a full circle is its start again, and left out.
    sensor.SetBetaResolution(_count((high - low) / step) + (high - low < 360))


def _count(steps):
    return max(1, round(steps))


def measure(simulation, step, maximum_error, tolerance, samples=None, share=(0.0, 1.0)):
    """Scan with the sensor where it stands, map, and compare; returns a Sample or raises Problem.

    Leaves the simulation with these properties. `tolerance` is in metres, `samples` the number of
    points on either surface, `share` what this takes of the progress of a longer work.
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
    """Steps from the coarsest to the finest, degrees, each about 3/4 of the one before."""
    steps = []
    half = coarsest
    while half > finest * (1 + 1e-9):
        steps += [x for x in (half, 0.75 * half) if x > finest * (1 + 1e-9)]
        half /= 2
    return steps + [finest]


def advise(simulation, tolerance, share, finest, samples=None):
    """The first Sample that meets a tolerance: the coarsest step, and for it the largest bound.

    Tries steps from coarse to fine and for each of them bounds from eight times the tolerance down
    to an eighth of it. Returns that Sample, or None, and the best of those that did not meet it, or
    None where none had a map.
    """
    bounds = [tolerance * factor for factor in (8, 4, 2, 1, 0.5, 0.25, 0.125)]
    trials = [(step, bound) for step in steps_down_to(finest) for bound in bounds]
    best = None
    # Each takes about as long, since most of that is the comparison.
    for number, (step, bound) in enumerate(trials):
        part = (number / len(trials), (number + 1) / len(trials))
        sample = measure(simulation, step, bound, tolerance, samples, part)
        if sample.meets(share):
            return sample, best
        if sample.comparison and (best is None or sample.is_better_than(best)):
            best = sample
    return None, best
