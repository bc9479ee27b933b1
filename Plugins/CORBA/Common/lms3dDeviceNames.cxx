// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dDeviceNames.h"

#include <algorithm>
#include <iterator>

namespace
{
/// Lengths are metres.
struct Preset
{
  const char* Name;
  double RangeNoise;
  double RangeResolution;
  double BeamDiameter;
  double BeamDivergence;
  unsigned int BeamSamples;
  double RangeAtTenPercent;
};

// SICK's technical description of the LMS 200, 8008970/06-2003, pages 7, 33 and 114.
constexpr Preset Presets[] = {
  { "ideal", 0.0, 0.0, 0.0, 0.0, 1, 0.0 },
  { "lms200-mm", 0.005, 0.001, 0.012, 0.0044, 7, 10.0 },
};

LMS3D::Device MakeDevice(const Preset& preset)
{
  LMS3D::Device device{};
  device.rangeNoise = preset.RangeNoise;
  device.rangeResolution = preset.RangeResolution;
  device.beamDiameter = preset.BeamDiameter;
  device.beamDivergence = preset.BeamDivergence;
  device.beamSamples = preset.BeamSamples;
  device.pulseLength = 1.0;
  device.rangeAtTenPercent = preset.RangeAtTenPercent;
  device.mounting = LMS3D::MOUNTING_YAWING;
  return device;
}
} // namespace

LMS3D::Device lms3dGetIdealDevice()
{
  return MakeDevice(Presets[0]);
}

std::vector<std::string> lms3dGetPresetNames()
{
  std::vector<std::string> names;
  for (const Preset& preset : Presets)
  {
    names.emplace_back(preset.Name);
  }
  return names;
}

std::optional<LMS3D::Device> lms3dFindPreset(const std::string& name)
{
  const auto preset = std::find_if(std::begin(Presets), std::end(Presets),
    [&name](const Preset& candidate) { return name == candidate.Name; });
  return preset == std::end(Presets) ? std::nullopt : std::make_optional(MakeDevice(*preset));
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
