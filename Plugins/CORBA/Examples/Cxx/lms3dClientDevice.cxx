// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dClientDevice.h"

#include "Common/lms3dDeviceNames.h"
#include "lms3dClientActions.h"
#include "lms3dClientNumbers.h"

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <optional>
#include <ostream>
#include <stdexcept>

namespace
{
using LMS3D::Device;
using Words = std::vector<std::string>;

struct Property
{
  const char* Name;
  const char* Unit;
  /// The number of values.
  std::size_t Count;
  void (*Print)(std::ostream&, const Device&);
  /// The first argument is the name.
  lms3dDeviceChange (*Read)(const std::string&, const Words&);
};

template <auto Member>
void PrintMember(std::ostream& os, const Device& device)
{
  os << device.*Member;
}

template <double Device::*Member>
lms3dDeviceChange ReadNumber(const std::string& name, const Words& values)
{
  const auto number = lms3dReadClientNumber<double>(name, values[0], "a number");
  return [number](Device& device) { device.*Member = number; };
}

template <double Device::*Member>
constexpr Property MakeNumber(const char* name, const char* unit)
{
  return { name, unit, 1, PrintMember<Member>, ReadNumber<Member> };
}

lms3dDeviceChange ReadSeed(const std::string& name, const Words& values)
{
  const auto seed = lms3dReadClientNumber<CORBA::Long>(name, values[0], "a whole number");
  return [seed](Device& device) { device.noiseSeed = seed; };
}

lms3dDeviceChange ReadSamples(const std::string& name, const Words& values)
{
  const auto samples =
    lms3dReadClientNumber<CORBA::ULong>(name, values[0], "a whole number, 0 or more");
  return [samples](Device& device) { device.beamSamples = samples; };
}

lms3dDeviceChange ReadArray(const std::string&, const Words& values)
{
  return [array = values[0]](Device& device) { device.reflectanceArray = array.c_str(); };
}

void PrintMounting(std::ostream& os, const Device& device)
{
  os << lms3dGetMountingNames().at(device.mounting);
}

lms3dDeviceChange ReadMounting(const std::string& name, const Words& values)
{
  const std::optional<LMS3D::ScannerMounting> mounting = lms3dFindMounting(values[0]);
  if (!mounting)
  {
    throw std::invalid_argument(
      name + ": \"" + values[0] + "\" is none of " + lms3dJoinNames(lms3dGetMountingNames()));
  }
  return [mounting = *mounting](Device& device) { device.mounting = mounting; };
}

void PrintOffset(std::ostream& os, const Device& device)
{
  const LMS3D::Vector3& offset = device.axisOffset;
  os << offset.x << ' ' << offset.y << ' ' << offset.z;
}

lms3dDeviceChange ReadOffset(const std::string& name, const Words& values)
{
  const auto get = [&](std::size_t axis)
  { return lms3dReadClientNumber<double>(name, values[axis], "a number"); };
  const LMS3D::Vector3 offset = { get(0), get(1), get(2) };
  return [offset](Device& device) { device.axisOffset = offset; };
}

void PrintStatus(std::ostream& os, const Device& device)
{
  os << (device.computeStatus ? "on" : "off");
}

lms3dDeviceChange ReadStatus(const std::string& name, const Words& values)
{
  if (values[0] != "on" && values[0] != "off")
  {
    throw std::invalid_argument(name + ": \"" + values[0] + "\" is neither on nor off");
  }
  return [isOn = values[0] == "on"](Device& device) { device.computeStatus = isOn; };
}

// The order is that of the IDL.
constexpr Property Properties[] = {
  MakeNumber<&Device::rangeBias>("rangeBias", "m"),
  MakeNumber<&Device::rangeNoise>("rangeNoise", "m"),
  MakeNumber<&Device::rangeResolution>("rangeResolution", "m"),
  { "noiseSeed", "", 1, PrintMember<&Device::noiseSeed>, ReadSeed },
  MakeNumber<&Device::beamDiameter>("beamDiameter", "m"),
  MakeNumber<&Device::beamDivergence>("beamDivergence", "m/m"),
  { "beamSamples", "rays", 1, PrintMember<&Device::beamSamples>, ReadSamples },
  MakeNumber<&Device::pulseLength>("pulseLength", "m"),
  MakeNumber<&Device::rangeAtTenPercent>("rangeAtTenPercent", "m"),
  { "reflectanceArray", "", 1, PrintMember<&Device::reflectanceArray>, ReadArray },
  { "mounting", "", 1, PrintMounting, ReadMounting },
  { "axisOffset", "m", 3, PrintOffset, ReadOffset },
  MakeNumber<&Device::turnRate>("turnRate", "deg/s"),
  { "computeStatus", "", 1, PrintStatus, ReadStatus },
};
} // namespace

lms3dDeviceChange lms3dReadDeviceChange(const std::string& property, const Words& values)
{
  const auto found = std::find_if(std::begin(Properties), std::end(Properties),
    [&property](const Property& candidate) { return property == candidate.Name; });
  if (found == std::end(Properties))
  {
    throw std::invalid_argument('"' + property + "\" is no property; \"device\" prints all");
  }
  if (values.size() != found->Count)
  {
    throw std::invalid_argument(property + ": it takes " +
      (found->Count == 1 ? "1 value" : std::to_string(found->Count) + " values"));
  }
  return found->Read(property, values);
}

void lms3dPrintPresets(CORBA::ORB_ptr, LMS3D::LaserScanner_ptr scanner)
{
  LMS3D::PresetNames_var names = scanner->listPresets();
  for (CORBA::ULong i = 0; i < names->length(); ++i)
  {
    std::cout << names[i] << '\n';
  }
}

void lms3dPrintDevice(LMS3D::LaserScanner_ptr scanner)
{
  const LMS3D::Device_var device = scanner->getDevice();
  for (const Property& property : Properties)
  {
    std::cout << property.Name << ' ';
    property.Print(std::cout, device);
    std::cout << (*property.Unit ? " " : "") << property.Unit << '\n';
  }
}

void lms3dSelectPreset(LMS3D::LaserScanner_ptr scanner, const std::string& name)
{
  lms3dPrintFirst(scanner, scanner->selectPreset(name.c_str()));
}

void lms3dChangeDevice(LMS3D::LaserScanner_ptr scanner, const lms3dDeviceChange& change)
{
  LMS3D::Device_var device = scanner->getDevice();
  change(device.inout());
  lms3dPrintFirst(scanner, scanner->setDevice(device));
}
