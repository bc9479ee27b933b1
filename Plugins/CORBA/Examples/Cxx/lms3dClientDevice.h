// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The commands of lms3d-client about the scanner's device.
 */
#ifndef lms3dClientDevice_h
#define lms3dClientDevice_h

#include "LMS3DScanner.hh"

#include <functional>
#include <string>
#include <vector>

/// Sets one property.
using lms3dDeviceChange = std::function<void(LMS3D::Device&)>;

/// Reads a property and its values without contacting a scanner. Throws std::invalid_argument if
/// there is no such property, or if it takes other values. The server checks the limits.
lms3dDeviceChange lms3dReadDeviceChange(
  const std::string& property, const std::vector<std::string>& values);

// The following throw what the functions of lms3dClientActions.h throw.

/// Prints the names of all presets.
void lms3dPrintPresets(CORBA::ORB_ptr orb, LMS3D::LaserScanner_ptr scanner);

/// Prints a line for each property: its name, its value and its unit.
void lms3dPrintDevice(LMS3D::LaserScanner_ptr scanner);

/// Selects a preset and prints its first scan.
void lms3dSelectPreset(LMS3D::LaserScanner_ptr scanner, const std::string& name);

/// Changes the device and prints its first scan.
void lms3dChangeDevice(LMS3D::LaserScanner_ptr scanner, const lms3dDeviceChange& change);

#endif
