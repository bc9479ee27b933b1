// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Devices and mountings that have a name.
 */
#ifndef lms3dDeviceNames_h
#define lms3dDeviceNames_h

#include "LMS3DScanner.hh"

#include <optional>
#include <string>
#include <vector>

/// Returns the device of the preset "ideal", without any error.
LMS3D::Device lms3dGetIdealDevice();

/// Returns the names of all presets. The first is "ideal".
std::vector<std::string> lms3dGetPresetNames();

/// Returns a preset, or nothing if there is none of this name.
std::optional<LMS3D::Preset> lms3dFindPreset(const std::string& name);

/// Sets the properties that a preset describes, and keeps the others.
void lms3dSetPreset(const LMS3D::Preset& preset, LMS3D::Device& device);

/// Returns the names of all mountings, in the order of LMS3D::ScannerMounting: "yawing" and so on.
const std::vector<std::string>& lms3dGetMountingNames();

/// Returns the mounting with a name, or nothing if there is no such mounting.
std::optional<LMS3D::ScannerMounting> lms3dFindMounting(const std::string& name);

/// Returns the names with ", " between them.
std::string lms3dJoinNames(const std::vector<std::string>& names);

#endif
