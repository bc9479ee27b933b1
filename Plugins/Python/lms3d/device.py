# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Which device a sensor is, and the properties that make a scan that of this device."""

import math

from .arguments import to_bound, to_choice, to_count, to_finite, to_number, to_numbers
from .properties import DEVICES, MAXIMUM_BEAM_SAMPLES, MOUNTINGS
from .vtkLMS3DFilters import vtkLMS3DScanFilter

# The properties that a device sets, as arguments of lms3d.scan, with what checks them.
_SENSOR = {
    "maximum_range": to_number,
    "beam_diameter": to_bound,
    "beam_divergence": to_bound,
    "beam_samples": lambda name, value: to_count(name, value, 1, MAXIMUM_BEAM_SAMPLES),
    "pulse_length": to_bound,
    "range_at_ten_percent": to_bound,
}
_ERRORS = {"range_bias": to_finite, "range_noise": to_bound, "range_resolution": to_bound}


def name_in_vtk(name):
    """The property of a VTK class: BeamDiameter for beam_diameter."""
    return name.title().replace("_", "")


def set_device(target, device):
    """Set all properties that describe a device, and leave all others.

    target: vtkLMS3DScanFilter, vtkLMS3DRangeErrorFilter, or the proxy of one in ParaView: the
        LMS3DScan or LMS3DRangeError of a script.
    device: ideal, lms200-mm, lms200-cm or lms291; `lms3d.DEVICES` has all names.

    Raises ValueError if there is no such device.
    """
    number = to_choice("device", device, DEVICES)
    if hasattr(target, "SetDevice"):
        target.SetDevice(number)
        return
    for name in target.ListProperties():
        value = vtkLMS3DScanFilter.GetDeviceValue(number, name)
        if not math.isnan(value):
            # ParaView's whole numbers do not accept 7.0.
            setattr(target, name, int(value) if value.is_integer() else value)


def set_sensor(sensor, device, given):
    """Set the scan filter's properties of a device, then those that are `given` and not None."""
    set_device(sensor, device)
    _set(sensor, _SENSOR, given)


def set_errors(errors, device, given):
    """Do the same for the filter of range errors; returns whether there are errors."""
    set_device(errors, device)
    _set(errors, _ERRORS, given)
    return bool(errors.GetRangeBias() or errors.GetRangeNoise() or errors.GetRangeResolution())


def set_platform(sensor, mounting, axis_offset, turn_rate):
    """Set how the platform carries and turns the fan."""
    sensor.SetMounting(to_choice("mounting", mounting, MOUNTINGS))
    sensor.SetAxisOffset(to_numbers("axis_offset", axis_offset, 3))
    sensor.SetTurnRate(to_finite("turn_rate", turn_rate))


def set_arrays(sensor, incidence, intensity, time, status, poses):
    """Choose the arrays that the scan has in addition."""
    sensor.SetComputeIncidence(bool(incidence))
    sensor.SetComputeIntensity(bool(intensity))
    sensor.SetComputeTime(bool(time))
    sensor.SetComputeStatus(bool(status))
    sensor.SetComputePoses(bool(poses))


def _set(target, checks, given):
    for name, check in checks.items():
        if given[name] is not None:
            getattr(target, f"Set{name_in_vtk(name)}")(check(name, given[name]))
