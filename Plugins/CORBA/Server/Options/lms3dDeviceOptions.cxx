// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Options/lms3dDeviceOptions.h"

#include "Common/lms3dDeviceLimits.h"
#include "Common/lms3dDeviceNames.h"
#include "Options/lms3dServerOptions.h"

#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

namespace
{
using Words = std::vector<std::string>;

std::string ReadDevice(const std::string& text)
{
  if (!lms3dFindPreset(text))
  {
    throw std::invalid_argument(
      '"' + text + "\" is none of " + lms3dJoinNames(lms3dGetPresetNames()));
  }
  return text;
}

LMS3D::ScannerMounting ReadMounting(const std::string& text)
{
  const std::optional<LMS3D::ScannerMounting> mounting = lms3dFindMounting(text);
  return mounting ? *mounting
                  : throw std::invalid_argument(
                      '"' + text + "\" is none of " + lms3dJoinNames(lms3dGetMountingNames()));
}

std::string ReadArrayName(const std::string& text)
{
  return text.size() <= lms3dMaximumArrayName
    ? text
    : throw std::invalid_argument("the name has more than 128 letters");
}

template <double LMS3D::Device::*Property>
void SetLength(lms3dServerOptions& options, const Words& words)
{
  const double length = lms3dReadOption(words[0], 0.0, lms3dMaximumLength);
  options.DeviceChanges.emplace_back([length](LMS3D::Device& d) { d.*Property = length; });
}
} // namespace

const std::vector<lms3dOption>& lms3dGetDeviceOptions()
{
  static const std::vector<lms3dOption> options = {
    { "--device", 1, "NAME",
      "ideal (default), lms200-mm, lms200-cm or lms291: sets the maximum\n"
      "range and the following properties up to --range-at-ten-percent,\n"
      "except --seed; options of single properties replace its values",
      [](lms3dServerOptions& o, const Words& w) { o.Device = ReadDevice(w[0]); } },
    { "--range-bias", 1, "M", "systematic error of ranges, metres",
      [](lms3dServerOptions& o, const Words& w)
      {
        const double bias = lms3dReadOption(w[0], -lms3dMaximumLength, lms3dMaximumLength);
        o.DeviceChanges.emplace_back([bias](LMS3D::Device& d) { d.rangeBias = bias; });
      } },
    { "--range-noise", 1, "M", "standard deviation of the error of ranges, metres",
      SetLength<&LMS3D::Device::rangeNoise> },
    { "--range-resolution", 1, "M", "step of ranges, metres; 0: no rounding",
      SetLength<&LMS3D::Device::rangeResolution> },
    { "--seed", 1, "N", "selects the random numbers of the errors (default 0)",
      [](lms3dServerOptions& o, const Words& w)
      {
        using Limits = std::numeric_limits<CORBA::Long>;
        const CORBA::Long seed = lms3dReadOption(w[0], Limits::min(), Limits::max());
        o.DeviceChanges.emplace_back([seed](LMS3D::Device& d) { d.noiseSeed = seed; });
      } },
    { "--beam-diameter", 1, "M", "diameter of a beam where it starts, metres",
      SetLength<&LMS3D::Device::beamDiameter> },
    { "--beam-divergence", 1, "RATIO", "metres by which it grows per metre of range, 0 to 1",
      [](lms3dServerOptions& o, const Words& w)
      {
        const double ratio = lms3dReadOption(w[0], 0.0, lms3dMaximumDivergence);
        o.DeviceChanges.emplace_back([ratio](LMS3D::Device& d) { d.beamDivergence = ratio; });
      } },
    { "--beam-samples", 1, "N", "rays of a beam, 1 to 1000; a beam of 1 has no width",
      [](lms3dServerOptions& o, const Words& w)
      {
        const CORBA::ULong samples = lms3dReadOption<CORBA::ULong>(w[0], 1, lms3dMaximumSamples);
        o.DeviceChanges.emplace_back([samples](LMS3D::Device& d) { d.beamSamples = samples; });
      } },
    { "--pulse-length", 1, "M", "difference of ranges that still mix, metres (default 1)",
      SetLength<&LMS3D::Device::pulseLength> },
    { "--range-at-ten-percent", 1, "M",
      "range at which a surface that reflects 10 % is seen, metres;\n0: every surface is seen",
      SetLength<&LMS3D::Device::rangeAtTenPercent> },
    { "--reflectance", 1, "NAME", "the scene's array with the reflectance of each cell",
      [](lms3dServerOptions& o, const Words& w)
      {
        const std::string name = ReadArrayName(w[0]);
        o.DeviceChanges.emplace_back(
          [name](LMS3D::Device& d) { d.reflectanceArray = name.c_str(); });
      } },
    { "--mounting", 1, "NAME", "yawing (default), yawing-top, pitching or rolling",
      [](lms3dServerOptions& o, const Words& w)
      {
        const LMS3D::ScannerMounting mounting = ReadMounting(w[0]);
        o.DeviceChanges.emplace_back([mounting](LMS3D::Device& d) { d.mounting = mounting; });
      } },
    { "--axis-offset", 3, "X Y Z", "centre of the mirror from the sensor's position, metres",
      [](lms3dServerOptions& o, const Words& w)
      {
        const std::array<double, 3> v = lms3dReadVector(w);
        o.DeviceChanges.emplace_back(
          [v](LMS3D::Device& d) {
            d.axisOffset = { v[0], v[1], v[2] };
          });
      } },
    { "--turn-rate", 1, "DEG/S", "turn of the platform during a fan (default 0: stepped)",
      [](lms3dServerOptions& o, const Words& w)
      {
        const double rate = lms3dReadOption(w[0], -lms3dMaximumTurnRate, lms3dMaximumTurnRate);
        o.DeviceChanges.emplace_back([rate](LMS3D::Device& d) { d.turnRate = rate; });
      } },
    { "--status", 0, "", "keep the status of each beam: why it gave a return, or none",
      [](lms3dServerOptions& o, const Words&)
      { o.DeviceChanges.emplace_back([](LMS3D::Device& d) { d.computeStatus = true; }); } },
  };
  return options;
}
