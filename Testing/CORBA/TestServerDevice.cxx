// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Client/lms3dRemoteScan.h"
#include "ClientORB.h"
#include "DirectPipeline.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace
{
// Enough scans that none is dropped during a test, even on a busy machine.
const std::vector<std::string> Patience = { "--keep", "500" };

// Every property has a value of its own.
LMS3D::Device GetUnusualDevice()
{
  LMS3D::Device device;
  device.rangeBias = -0.25;
  device.rangeNoise = 0.125;
  device.rangeResolution = 0.5;
  device.noiseSeed = -7;
  device.beamDiameter = 0.0625;
  device.beamDivergence = 0.03125;
  device.beamSamples = 19;
  device.pulseLength = 2.0;
  device.rangeAtTenPercent = 16.0;
  device.reflectanceArray = "";
  device.mounting = LMS3D::MOUNTING_ROLLING;
  device.axisOffset = { 0.1, -0.2, 0.3 };
  device.turnRate = 37.5;
  device.computeStatus = true;
  return device;
}

void ExpectEqual(const LMS3D::Device& a, const LMS3D::Device& b)
{
  EXPECT_EQ(a.rangeBias, b.rangeBias);
  EXPECT_EQ(a.rangeNoise, b.rangeNoise);
  EXPECT_EQ(a.rangeResolution, b.rangeResolution);
  EXPECT_EQ(a.noiseSeed, b.noiseSeed);
  EXPECT_EQ(a.beamDiameter, b.beamDiameter);
  EXPECT_EQ(a.beamDivergence, b.beamDivergence);
  EXPECT_EQ(a.beamSamples, b.beamSamples);
  EXPECT_EQ(a.pulseLength, b.pulseLength);
  EXPECT_EQ(a.rangeAtTenPercent, b.rangeAtTenPercent);
  EXPECT_STREQ(a.reflectanceArray, b.reflectanceArray);
  EXPECT_EQ(a.mounting, b.mounting);
  EXPECT_EQ(a.axisOffset.x, b.axisOffset.x);
  EXPECT_EQ(a.axisOffset.y, b.axisOffset.y);
  EXPECT_EQ(a.axisOffset.z, b.axisOffset.z);
  EXPECT_EQ(a.turnRate, b.turnRate);
  EXPECT_EQ(a.computeStatus, b.computeStatus);
}

// The errors of an LMS 200.
LMS3D::Device GetNoisyDevice(CORBA::Long seed)
{
  LMS3D::Device device = lms3dGetIdealDevice();
  device.rangeBias = 0.01;
  device.rangeNoise = 0.005;
  device.rangeResolution = 0.001;
  device.noiseSeed = seed;
  return device;
}

struct Served
{
  std::vector<float> First;
  std::vector<float> Second;
};

// The first two scans of a noisy device, and their numbers.
Served ScanTwice(LMS3D::LaserScanner_ptr scanner, std::vector<CORBA::ULongLong>* numbers = nullptr)
{
  const LMS3D::ScanHeader first = WaitFor(scanner);
  const LMS3D::ScanHeader second = WaitFor(scanner, 0, first.number);
  if (numbers)
  {
    *numbers = { first.number, second.number };
  }
  return { lms3dFetchScan(scanner, first).Ranges, lms3dFetchScan(scanner, second).Ranges };
}

// Scan `number` of a server whose configuration stays as it is.
std::vector<float> FetchRanges(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong number)
{
  const LMS3D::ScanHeader header = WaitFor(scanner, 0, number - 1);
  const LMS3D::Ranges_var ranges = scanner->getRanges(number, 0, header.beams);
  return { ranges->get_buffer(), ranges->get_buffer() + ranges->length() };
}
} // namespace

TEST(ServerDevice, IsIdealByDefault)
{
  ServerProcess server(Patience);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::Device_var device = scanner->getDevice();
  ExpectEqual(device, lms3dGetIdealDevice());
  EXPECT_EQ(device->rangeNoise, 0.0);
  EXPECT_EQ(device->beamSamples, 1u);
  EXPECT_EQ(device->mounting, LMS3D::MOUNTING_YAWING);
  const LMS3D::Device_var ofScan = scanner->getScanDevice(WaitFor(scanner).number);
  ExpectEqual(ofScan, device);
}

TEST(ServerDevice, IsUsedAndReturned)
{
  ServerProcess server(Patience);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  LMS3D::Configuration configuration = GetCoarseGrid();
  configuration.makeMap = false;
  const LMS3D::ScanHeader before = WaitFor(scanner, scanner->setConfiguration(configuration));
  EXPECT_GT(scanner->setDevice(GetUnusualDevice()), before.generation);
  const LMS3D::Device_var now = scanner->getDevice();
  ExpectEqual(now, GetUnusualDevice());
  LMS3D::Device rig = GetUnusualDevice();
  rig.rangeBias = rig.rangeNoise = rig.rangeResolution = 0.0;
  for (const LMS3D::Device& device : { rig, GetNoisyDevice(5) })
  {
    const LMS3D::ScanHeader header = WaitFor(scanner, scanner->setDevice(device));
    const LMS3D::Device_var used = scanner->getScanDevice(header.number);
    ExpectEqual(used, device);
  }
  // A scan is immutable, with its device.
  const LMS3D::Device_var older = scanner->getScanDevice(before.number);
  ExpectEqual(older, lms3dGetIdealDevice());
  EXPECT_THROW(scanner->getScanDevice(1000000), LMS3D::ScanGone);
}

TEST(ServerDevice, ReadOnlyLetsClientsLookOnly)
{
  ServerProcess server({ "--read-only" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  EXPECT_THROW(scanner->setDevice(lms3dGetIdealDevice()), LMS3D::NotPermitted);
  EXPECT_THROW(scanner->selectPreset("lms200-mm"), LMS3D::NotPermitted);
  const LMS3D::Device_var device = scanner->getDevice();
  ExpectEqual(device, lms3dGetIdealDevice());
  const LMS3D::Preset_var preset = scanner->getPreset("lms200-mm");
  EXPECT_EQ(preset->properties.rangeNoise, 0.005);
}

TEST(ServerDevice, HasPresets)
{
  ServerProcess server(Patience);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  LMS3D::PresetNames_var names = scanner->listPresets();
  ASSERT_EQ(names->length(), 4u);
  EXPECT_STREQ(names[0u], "ideal");
  EXPECT_STREQ(names[1u], "lms200-mm");
  scanner->setDevice(GetUnusualDevice());
  for (CORBA::ULong i = 0; i < names->length(); ++i)
  {
    const LMS3D::Preset_var preset = scanner->getPreset(names[i]);
    scanner->selectPreset(names[i]);
    const LMS3D::Device_var device = scanner->getDevice();
    // What describes the device is the preset's, and what describes the rig stays.
    LMS3D::Device expected = preset->properties;
    expected.noiseSeed = -7;
    expected.mounting = LMS3D::MOUNTING_ROLLING;
    expected.axisOffset = { 0.1, -0.2, 0.3 };
    expected.turnRate = 37.5;
    expected.computeStatus = true;
    ExpectEqual(device, expected);
    const LMS3D::Configuration configuration = scanner->getConfiguration();
    EXPECT_EQ(configuration.maximumRange, preset->maximumRange);
  }
}

TEST(ServerDevice, APresetOfAnotherNameIsRefused)
{
  ServerProcess server(Patience);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  LMS3D::Configuration configuration = GetCoarseGrid();
  configuration.minimumRange = 9.0;
  const CORBA::ULongLong generation = scanner->setConfiguration(configuration);
  for (const char* name : { "", "Ideal", "lms200" })
  {
    EXPECT_THROW(scanner->getPreset(name), LMS3D::NoSuchPreset) << name;
    EXPECT_THROW(scanner->selectPreset(name), LMS3D::NoSuchPreset) << name;
  }
  // Its ranges end at 8 m.
  EXPECT_THROW(scanner->selectPreset("lms200-mm"), LMS3D::InvalidArgument);
  const LMS3D::Status_var status = scanner->getStatus();
  EXPECT_EQ(status->generation, generation);
}

TEST(ServerDevice, ErrorsAreTheDirectPipelines)
{
  ServerProcess server(Patience);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  scanner->setConfiguration(GetCoarseGrid());
  LMS3D::Device device = GetNoisyDevice(3);
  for (const LMS3D::ScannerMounting mounting : { LMS3D::MOUNTING_YAWING, LMS3D::MOUNTING_YAWING_TOP,
         LMS3D::MOUNTING_PITCHING, LMS3D::MOUNTING_ROLLING })
  {
    device.mounting = mounting;
    const LMS3D::ScanHeader header = WaitFor(scanner, scanner->setDevice(device));
    const lms3dRemoteScan remote = lms3dFetchScan(scanner, header);
    const DirectPipeline direct(
      "room.wrl", header.sensorPose, header.settings, device, header.number);
    EXPECT_EQ(remote.Ranges, direct.Ranges);
    EXPECT_GT(remote.MapTriangles.size(), 100u);
    EXPECT_EQ(remote.MapPoints, direct.MapPoints);
    EXPECT_EQ(remote.MapTriangles, direct.MapTriangles);
    EXPECT_NE(remote.Ranges, DirectPipeline("room.wrl", header.sensorPose, header.settings).Ranges);
    device.axisOffset = { 0.1, -0.05, 0.2 };
    device.turnRate = 20.0;
  }
}

TEST(ServerDevice, ErrorsDifferFromScanToScanAndAreThoseOfTheSeed)
{
  const std::vector<std::string> options = { "--keep", "500", "--device", "lms200-mm",
    "--beam-samples", "1", "--range-at-ten-percent", "0", "--no-map", "--seed" };
  std::vector<std::string> seven = options;
  seven.emplace_back("7");
  std::vector<std::string> eight = options;
  eight.emplace_back("8");
  ServerProcess server(seven);
  ServerProcess same(seven);
  ServerProcess other(eight);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  std::vector<CORBA::ULongLong> numbers;
  const Served scans = ScanTwice(scanner, &numbers);
  EXPECT_NE(scans.First, scans.Second);
  const LMS3D::LaserScanner_var sameScanner = Connect(same.GetCorbaloc());
  EXPECT_EQ(FetchRanges(sameScanner, numbers[0]), scans.First);
  EXPECT_EQ(FetchRanges(sameScanner, numbers[1]), scans.Second);
  const LMS3D::LaserScanner_var otherScanner = Connect(other.GetCorbaloc());
  EXPECT_NE(FetchRanges(otherScanner, numbers[0]), scans.First);
}

TEST(ServerDevice, WithoutErrorsTheRangesAreIdealAgain)
{
  ServerProcess server(Patience);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  scanner->setConfiguration(GetCoarseGrid());
  WaitFor(scanner, scanner->setDevice(GetNoisyDevice(1)));
  const LMS3D::ScanHeader header = WaitFor(scanner, scanner->selectPreset("ideal"));
  const lms3dRemoteScan remote = lms3dFetchScan(scanner, header);
  const DirectPipeline direct("room.wrl", header.sensorPose, header.settings);
  EXPECT_EQ(remote.Ranges, direct.Ranges);
  EXPECT_EQ(remote.MapPoints, direct.MapPoints);
}

TEST(ServerDevice, StatusesComeInParts)
{
  ServerProcess server(Patience);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::ScanHeader without = WaitFor(scanner, scanner->setConfiguration(GetCoarseGrid()));
  EXPECT_THROW(scanner->getBeamStatuses(without.number, 0, 1), LMS3D::InvalidArgument);
  const LMS3D::BeamStatuses_var none = scanner->getBeamStatuses(without.number, 0, 0);
  EXPECT_EQ(none->length(), 0u);

  // Nearer surfaces are moved behind the sensor.
  LMS3D::Device device = lms3dGetIdealDevice();
  device.rangeBias = -1.5;
  device.computeStatus = true;
  const LMS3D::ScanHeader header = WaitFor(scanner, scanner->setDevice(device));
  const lms3dRemoteScan remote = lms3dFetchScan(scanner, header);
  ASSERT_EQ(remote.Statuses.size(), header.beams);
  for (std::size_t i = 0; i < remote.Statuses.size(); ++i)
  {
    const bool isReturn = remote.Statuses[i] == LMS3D::BEAM_RETURN;
    ASSERT_EQ(isReturn, remote.Ranges[i] > 0.0f) << i;
  }
  EXPECT_LT(header.returns, header.beams);
  EXPECT_GT(header.returns, 0u);
  const LMS3D::BeamStatuses_var part = scanner->getBeamStatuses(header.number, 100, 30);
  ASSERT_EQ(part->length(), 30u);
  EXPECT_TRUE(
    std::equal(part->get_buffer(), part->get_buffer() + 30, remote.Statuses.begin() + 100));
  EXPECT_THROW(scanner->getBeamStatuses(header.number, header.beams, 1), LMS3D::InvalidArgument);
  EXPECT_THROW(scanner->getBeamStatuses(1000000, 0, 1), LMS3D::ScanGone);
}
