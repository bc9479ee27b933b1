// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The properties that make a scan that of a real device, as vtkLMS3DScanFilter documents
 * them.
 */
#ifndef lms3dDeviceSettings_h
#define lms3dDeviceSettings_h

#include "Device/lms3dPlatform.h"

#include <string>

/// The width of a beam.
struct lms3dFootprint
{
  /// Metres, where the beam leaves the sensor.
  double Diameter = 0.0;

  /// By how many metres the diameter grows with each metre.
  double Divergence = 0.0;

  /// The number of rays that stand for a beam.
  int Samples = 1;

  /// Metres.
  double PulseLength = 1.0;

  /// Returns whether a beam is more than one ray.
  bool HasWidth() const
  {
    return this->Samples > 1 && (this->Diameter > 0.0 || this->Divergence > 0.0);
  }
};

/// The surface reflects, and the device needs light.
struct lms3dReflectance
{
  /// Metres; 0 stands for a device that sees every surface.
  double RangeAtTenPercent = 0.0;

  /// The cell array of the scene; empty if all surfaces reflect all light.
  std::string Array;
};

/// Which arrays the scan has in addition.
struct lms3dExtraArrays
{
  bool Incidence = false;
  bool Intensity = false;
  bool Time = false;
  bool Status = false;
  bool Poses = false;
};

/// Any values; lms3dFindDeviceError checks them.
struct lms3dDeviceSettings
{
  lms3dPlatform Platform;
  bool MotionDuringScan = false;
  lms3dFootprint Footprint;
  lms3dReflectance Reflectance;
  lms3dExtraArrays Arrays;
};

/// Returns a text for the user about the first bad property, empty if all are good.
std::string lms3dFindDeviceError(const lms3dDeviceSettings& settings);

#endif
