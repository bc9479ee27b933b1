# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sources of fans: the live one casts the fan that is sent, the stored one plays a scan.

A source has `angles`, the platform angles of a whole scan; `variants`, what it can measure; and
- cast_turn(variant, scan, turn, means): all beams of a turn of a scan, both counted from 0;
- cast_part(variant, part, angle, time, means): the beams of one part at any platform angle, and at
  a time after the start.
Both return ranges in metres: NaN if the beam met nothing, infinity if the surface is beyond the maximum
range, minus infinity if too little light comes back. `means` is a number of scans that are averaged.
"""

import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkUnsignedCharArray

from .. import vtkLMS3DScanFilter
from ..problems import Problem
from .variants import FANS, VARIANTS

_SAME_ANGLE = 1e-6  # degrees


class LiveFans:
    """Casts fans in a scene when they are requested.

    sensor: a vtkLMS3DScanFilter with its scene, pose, ranges and platform angles. check: raises the
    errors that VTK has reported. errors: a vtkLMS3DRangeErrorFilter, or None; its noise is the noise
    of `lms3d scan`: the first scan is equal, and every scan has noise of its own. times: the times of
    the sensor's trajectory, or nothing.
    """

    variants = FANS

    def __init__(self, sensor, check, errors=None, times=()):
        self._sensor = sensor
        self._check = check
        self._errors = errors
        self._noise = errors.GetRangeNoise() if errors else 0.0
        self._times = times
        self._means = 1
        self._alphas = None
        self._buffers = {}
        self._set_alphas(0.0, 0.0, 1)
        sensor.Update()
        check()
        betas = sensor.GetOutput().GetFieldData().GetArray("BetaAngles")
        self.angles = vtk_to_numpy(betas).tolist()
        # Without statuses a fan takes less time.
        self._has_status = bool(times) or _can_hide(sensor)

    def cast_turn(self, variant, scan, turn, means):
        """A turn of a scan. Each scan has the next pose of the trajectory; the last one stays."""
        time, number = 0.0, float(scan)
        if self._times:
            time = self._times[min(scan, len(self._times) - 1)]
            number = time + max(scan - len(self._times) + 1, 0)
        self._set_alphas(variant.first_alpha, -variant.first_alpha, variant.count)
        return self._cast(self.angles[turn], time, (number, turn), means)

    def cast_part(self, variant, part, angle, time, means):
        """A part of a fan. The trajectory begins when the device starts."""
        alphas = variant.alphas[part::variant.parts]
        self._set_alphas(alphas[0], alphas[-1], len(alphas))
        pose_time = self._times[0] + time if self._times else 0.0
        return self._cast(angle, pose_time, (time, 0), means)

    def _set_alphas(self, first, last, count):
        if (first, last, count) != self._alphas:
            self._alphas = first, last, count
            self._sensor.SetAlphaRange(first, last)
            self._sensor.SetAlphaResolution(count)

    def _cast(self, angle, time, noise, means):
        """The beams at an angle. `noise`: a number for the scan, and the turn."""
        fan = self._buffer()
        status = fan.status if self._has_status else None
        # An update of the pipeline takes several times as long as the cast.
        if not self._sensor.CastFan(angle, time, fan.ranges, status):
            self._fail("cannot cast a fan")
        if self._errors:
            self._add_errors(fan.ranges, *noise, means)
        ranges = fan.range_values.copy()
        return _mark(ranges, fan.status_values) if self._has_status else ranges

    def _add_errors(self, ranges, number, turn, means):
        if means != self._means:
            # The noise of a mean of n independent errors.
            self._errors.SetRangeNoise(self._noise / math.sqrt(means))
            self._means = means
        if not self._errors.AddErrors(number, turn, ranges):
            self._fail("cannot add the errors of ranges")

    def _fail(self, what):
        self._check()
        raise Problem(what)

    def _buffer(self):
        """The arrays for the present number of beams."""
        count = self._alphas[-1]
        if count not in self._buffers:
            self._buffers[count] = _Buffer(count)
        return self._buffers[count]


class _Buffer:
    """VTK arrays for a fan, and their values as numpy arrays."""

    def __init__(self, count):
        self.ranges, self.status = vtkDoubleArray(), vtkUnsignedCharArray()
        for array in (self.ranges, self.status):
            array.SetNumberOfValues(count)
        self.range_values = np.frombuffer(self.ranges, np.float64)
        self.status_values = np.frombuffer(self.status, np.uint8)


def _can_hide(sensor):
    """Whether a surface can be too far or too dark for the sensor, at the pose that it has."""
    bounds = np.reshape(sensor.GetInputDataObject(0, 0).GetBounds(), (3, 2))
    position = np.reshape(sensor.GetPosition(), (3, 1))
    reach = np.linalg.norm(np.abs(bounds - position).max(axis=1))
    return sensor.GetRangeAtTenPercent() > 0 or not reach < sensor.GetMaximumRange()


def _mark(ranges, status):
    """Replace ranges of beams without a return by the reason."""
    if status.any():  # a beam without a return
        ranges[status == vtkLMS3DScanFilter.BEYOND_RANGE] = np.inf
        ranges[status == vtkLMS3DScanFilter.TOO_WEAK] = -np.inf
    return ranges


class StoredFans:
    """Plays the fans of a scan: the outputs of vtkLMS3DRangeErrorFilter.

    It has only the variants whose beams the scan has.
    """

    def __init__(self, scan, image, name):
        fields = scan.GetFieldData()
        self._alphas = vtk_to_numpy(fields.GetArray("AlphaAngles"))
        self._betas = vtk_to_numpy(fields.GetArray("BetaAngles"))
        self.angles = self._betas.tolist()
        self._columns = {variant: columns for variant in FANS
                         for columns in [self._find_columns(variant)] if columns is not None}
        self.variants = tuple(self._columns)
        if not set(self.variants).intersection(VARIANTS):
            raise Problem(f"cannot play '{name}': its fan has not the beams of any variant of the "
                          "device; scan with --alpha-range -90 90 --alpha-resolution 361")
        beams = image.GetPointData()
        ranges = vtk_to_numpy(beams.GetArray("Range")).copy()
        if beams.HasArray("Status"):
            _mark(ranges, vtk_to_numpy(beams.GetArray("Status")))
        self._ranges = ranges.reshape(len(self._betas), -1)

    def cast_turn(self, variant, _scan, turn, _means):
        """A turn of the scan."""
        return self._ranges[turn][self._columns[variant]]

    def cast_part(self, variant, part, angle, _time, _means):
        """A part of the turn that is nearest to an angle."""
        away = np.abs((self._betas - angle + 180.0) % 360.0 - 180.0)
        return self.cast_turn(variant, 0, int(np.argmin(away)), 1)[part::variant.parts]

    def _find_columns(self, variant):
        """The beams of a variant, or None if the scan does not have all of them."""
        alphas = np.array(variant.alphas)
        columns = np.abs(self._alphas[:, None] - alphas).argmin(axis=0)
        is_same = np.abs(self._alphas[columns] - alphas) < _SAME_ANGLE
        return columns if is_same.all() else None
