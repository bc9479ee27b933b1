// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dDeviceNames.h"

#include "Device/lms3dDevices.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace
{
std::string GetPresetName(const lms3dDevice& device)
{
  std::string name = device.Name;
  std::transform(name.begin(), name.end(), name.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return name;
}

LMS3D::Preset MakePreset(const lms3dDevice& device)
{
  LMS3D::Preset preset{};
  LMS3D::Device& properties = preset.properties;
  properties.rangeBias = device.RangeBias;
  properties.rangeNoise = device.RangeNoise;
  properties.rangeResolution = device.RangeResolution;
  properties.beamDiameter = device.BeamDiameter;
  properties.beamDivergence = device.BeamDivergence;
  properties.beamSamples = static_cast<CORBA::ULong>(device.BeamSamples);
  properties.pulseLength = device.PulseLength;
  properties.rangeAtTenPercent = device.RangeAtTenPercent;
  properties.mounting = LMS3D::MOUNTING_YAWING;
  preset.maximumRange = device.MaximumRange;
  return preset;
}
} // namespace

LMS3D::Device lms3dGetIdealDevice()
{
  return MakePreset(*lms3dGetDevice(0)).properties;
}

std::vector<std::string> lms3dGetPresetNames()
{
  std::vector<std::string> names;
  names.reserve(lms3dGetNumberOfDevices());
  for (int i = 0; i < lms3dGetNumberOfDevices(); ++i)
  {
    names.push_back(GetPresetName(*lms3dGetDevice(i)));
  }
  return names;
}

std::optional<LMS3D::Preset> lms3dFindPreset(const std::string& name)
{
  const int number =
    lms3dFindDevice([&name](const lms3dDevice& device) { return GetPresetName(device) == name; });
  return number < 0 ? std::nullopt : std::make_optional(MakePreset(*lms3dGetDevice(number)));
}

void lms3dSetPreset(const LMS3D::Preset& preset, LMS3D::Device& device)
{
  LMS3D::Device properties = preset.properties;
  properties.noiseSeed = device.noiseSeed;
  properties.reflectanceArray = device.reflectanceArray;
  properties.mounting = device.mounting;
  properties.axisOffset = device.axisOffset;
  properties.turnRate = device.turnRate;
  properties.computeStatus = device.computeStatus;
  device = std::move(properties);
}

const std::vector<std::string>& lms3dGetMountingNames()
{
  static const std::vector<std::string> names = { "yawing", "yawing-top", "pitching", "rolling" };
  return names;
}

std::optional<LMS3D::ScannerMounting> lms3dFindMounting(const std::string& name)
{
  const std::vector<std::string>& names = lms3dGetMountingNames();
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end()
    ? std::nullopt
    : std::make_optional(static_cast<LMS3D::ScannerMounting>(found - names.begin()));
}

std::string lms3dJoinNames(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text.append(text.empty() ? "" : ", ").append(name);
  }
  return text;
}
