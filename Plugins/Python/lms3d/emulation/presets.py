# SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
# SPDX-License-Identifier: BSD-3-Clause
"""Errors of the ranges, by the name of the device: values of vtkLMS3DRangeErrorFilter in metres."""

IDEAL = "ideal"
# The data sheet of the LMS 200 (TD 34); the resolution is a digit of the unit.
DEVICES = {
    IDEAL: {},
    "lms200-mm": {"RangeNoise": 0.005, "RangeResolution": 0.001},
    "lms200-cm": {"RangeNoise": 0.005, "RangeResolution": 0.01},
}


def set_errors(errors, name, seed):
    """Give a vtkLMS3DRangeErrorFilter the errors of a device."""
    for key, value in DEVICES[name].items():
        getattr(errors, "Set" + key)(value)
    errors.SetNoiseSeed(seed)
