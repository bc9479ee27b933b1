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
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData

from .. import vtkLMS3DScanFilter
from ..problems import Problem
from .variants import FANS, VARIANTS

_SAME_ANGLE = 1e-6  # degrees
_BLOCK = 30  # turns that are added to a grid at once


class LiveFans:
    """Casts fans in a scene when they are requested.

    sensor: a vtkLMS3DScanFilter with its scene, pose, ranges and platform angles. run: updates a
    filter, for a time or for None, and raises its errors. errors: a vtkLMS3DRangeErrorFilter, or
    None; its noise is the noise of `lms3d scan`: the first scan is equal, and every scan has noise
    of its own. times: the times of the sensor's trajectory, or nothing.
    """

    variants = FANS

    def __init__(self, sensor, run, errors=None, times=()):
        self._sensor = sensor
        self._run = run
        self._errors = errors
        self._noise = errors.GetRangeNoise() if errors else 0.0
        self._times = times
        self._set_alphas(0.0, 0.0, 1)
        run(sensor, None)
        # Without statuses a fan takes less time.
        sensor.SetComputeStatus(bool(times) or _can_hide(sensor))
        betas = sensor.GetOutput().GetFieldData().GetArray("BetaAngles")
        self.angles = vtk_to_numpy(betas).tolist()
        self._betas = vtkDoubleArray()
        self._betas.SetName("BetaAngles")
        self._fan = vtkPolyData()
        self._ids = vtkIntArray()
        self._ids.SetName("BeamId")
        if errors:
            errors.SetInputDataObject(self._fan)

    def cast_turn(self, variant, scan, turn, means):
        """A turn of a scan. Each scan has the next pose of the trajectory; the last one stays."""
        time, number = None, float(scan)
        if self._times:
            time = self._times[min(scan, len(self._times) - 1)]
            number = time + max(scan - len(self._times) + 1, 0)
        self._set_alphas(variant.first_alpha, -variant.first_alpha, variant.count)
        return self._cast(self.angles[turn], time, (number, turn, True), means)

    def cast_part(self, variant, part, angle, time, means):
        """A part of a fan. The trajectory begins when the device starts."""
        alphas = variant.alphas[part::variant.parts]
        self._set_alphas(alphas[0], alphas[-1], len(alphas))
        pose_time = self._times[0] + time if self._times else None
        return self._cast(angle, pose_time, (time, 0, False), means)

    def _set_alphas(self, first, last, count):
        self._sensor.SetAlphaRange(first, last)
        self._sensor.SetAlphaResolution(count)

    def _cast(self, angle, time, noise, means):
        self._sensor.SetBetaRange(angle, angle)
        self._sensor.SetBetaResolution(1)
        self._run(self._sensor, time)
        image = self._sensor.GetRangeImage()
        ranges = self._add_errors(noise, means) if self._errors else _ranges(image).copy()
        return _mark(ranges, image)

    def _add_errors(self, noise, means):
        """The ranges with errors. Those depend on a number for the scan, and on turn and beam."""
        number, turn, is_in_scan = noise
        beams = self._sensor.GetAlphaResolution()
        first_beam = turn * beams
        fan = self._fan
        fan.ShallowCopy(self._sensor.GetOutput())
        fan.GetFieldData().RemoveArray("Status")  # of the fan's own beams
        fan.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), number)
        if is_in_scan:
            self._place_in_scan(turn, first_beam)
        # The noise of a mean of n independent errors.
        self._errors.SetRangeNoise(self._noise / math.sqrt(means))
        self._run(self._errors, None)
        return _ranges(self._errors.GetRangeImage())[first_beam:first_beam + beams].copy()

    def _place_in_scan(self, turn, first_beam):
        """Number the beams of the fan as in its whole scan."""
        beams = self._fan.GetPointData()
        self._ids.DeepCopy(beams.GetArray("BeamId"))
        if self._ids.GetNumberOfValues() > 0:
            ids = np.frombuffer(self._ids, np.int32)
            np.add(ids, first_beam, out=ids)
        beams.AddArray(self._ids)
        # The filter works on a grid of all turns. It needs this turn and the turns before it.
        count = min((turn // _BLOCK + 1) * _BLOCK, len(self.angles))
        if self._betas.GetNumberOfValues() != count:
            self._betas.SetNumberOfValues(count)
            np.frombuffer(self._betas, np.float64)[:] = self.angles[:count]
            self._betas.Modified()
        self._fan.GetFieldData().AddArray(self._betas)


def _ranges(image):
    """The ranges of an image, without a copy."""
    return np.frombuffer(image.GetPointData().GetArray("Range"), np.float64)


def _can_hide(sensor):
    """Whether a surface can be too far or too dark for the sensor, at the pose that it has."""
    bounds = np.reshape(sensor.GetInputDataObject(0, 0).GetBounds(), (3, 2))
    position = np.reshape(sensor.GetPosition(), (3, 1))
    reach = np.linalg.norm(np.abs(bounds - position).max(axis=1))
    return sensor.GetRangeAtTenPercent() > 0 or not reach < sensor.GetMaximumRange()


def _mark(ranges, image):
    """Replace ranges of beams without a return by the reason, if the image says it."""
    if image.GetPointData().HasArray("Status"):
        status = np.frombuffer(image.GetPointData().GetArray("Status"), np.uint8)
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
        ranges = _mark(_ranges(image).copy(), image)
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
