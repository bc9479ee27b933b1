# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Values of devices, for tests of Python and the command line."""

import lms3d

GRID = {"alpha_range": (-60, 60), "alpha_resolution": 31, "beta_resolution": 24}
SENSOR = ("MaximumRange", "BeamDiameter", "BeamDivergence", "BeamSamples", "PulseLength",
          "RangeAtTenPercent")
ERRORS = ("RangeBias", "RangeNoise", "RangeResolution")

# A value of each argument that no device has.
OTHERS = {"maximum_range": 7.0, "beam_diameter": 0.1, "beam_divergence": 0.2, "beam_samples": 13,
          "pulse_length": 0.5, "range_at_ten_percent": 5.0, "range_bias": 0.1, "range_noise": 0.2,
          "range_resolution": 0.3}
RIG = {"mounting": "pitching", "axis_offset": (0.1, 0.2, 0.3), "turn_rate": 37.5,
       "reflectance": "Color"}
ARRAYS = ("incidence", "intensity", "time", "status", "poses")


def in_vtk(name):
    """The property of an argument."""
    return {"reflectance": "ReflectanceArray", "seed": "NoiseSeed"}.get(
        name, f"Compute{name.title()}" if name in ARRAYS else name.title().replace("_", ""))


def values_of(device, names):
    """The values that a device gives to properties."""
    number = lms3d.DEVICES[device]
    return {name: lms3d.vtkLMS3DScanFilter.GetDeviceValue(number, name) for name in names}


def values_in(target, names):
    """The values of properties of a filter."""
    return {name: getattr(target, f"Get{name}")() for name in names}
