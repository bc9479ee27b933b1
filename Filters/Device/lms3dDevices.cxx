// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/lms3dDevices.h"

#include <limits>
#include <utility>

namespace
{
constexpr lms3dDevice Devices[] = {
  // name, range, diameter, divergence, samples, pulse, at 10 %, bias, noise, resolution
  { "Ideal", 80.0, 0.0, 0.0, 1, 1.0, 0.0, 0.0, 0.0, 0.0 },
  { "LMS200-mm", 8.0, 0.012, 0.0044, 7, 1.0, 10.0, 0.0, 0.005, 0.001 },
  { "LMS200-cm", 80.0, 0.012, 0.0044, 7, 1.0, 10.0, 0.0, 0.005, 0.01 },
  { "LMS291", 80.0, 0.016, 0.0119, 7, 1.0, 30.0, 0.0, 0.01, 0.01 },
};
} // namespace

int lms3dGetNumberOfDevices()
{
  return static_cast<int>(sizeof(Devices) / sizeof(Devices[0]));
}

const lms3dDevice* lms3dGetDevice(int number)
{
  return number >= 0 && number < lms3dGetNumberOfDevices() ? &Devices[number] : nullptr;
}

const char* lms3dGetDeviceName(int number)
{
  const lms3dDevice* device = lms3dGetDevice(number);
  return device ? device->Name : nullptr;
}

double lms3dGetDeviceValue(int number, const std::string& property)
{
  if (const lms3dDevice* device = lms3dGetDevice(number))
  {
    const std::pair<const char*, double> values[] = {
      { "MaximumRange", device->MaximumRange },
      { "BeamDiameter", device->BeamDiameter },
      { "BeamDivergence", device->BeamDivergence },
      { "BeamSamples", device->BeamSamples },
      { "PulseLength", device->PulseLength },
      { "RangeAtTenPercent", device->RangeAtTenPercent },
      { "RangeBias", device->RangeBias },
      { "RangeNoise", device->RangeNoise },
      { "RangeResolution", device->RangeResolution },
    };
    for (const auto& [name, value] : values)
    {
      if (property == name)
      {
        return value;
      }
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}
