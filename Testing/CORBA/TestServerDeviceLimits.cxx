// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// Devices that the server refuses. They change nothing.
#include "ClientORB.h"
#include "Common/lms3dDeviceNames.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
using LMS3D::Device;

struct BadDevice
{
  void (*Change)(Device&);
  /// A part of the expected reason.
  const char* Word;
};

const BadDevice BadDevices[] = {
  { [](Device& d) { d.rangeBias = NaN; }, "rangeBias is nan" },
  { [](Device& d) { d.rangeBias = -1.1e6; }, "rangeBias" },
  { [](Device& d) { d.rangeNoise = -0.001; }, "rangeNoise is -0.001; it must be from 0 to 1e6" },
  { [](Device& d) { d.rangeNoise = Infinity; }, "rangeNoise" },
  { [](Device& d) { d.rangeResolution = NaN; }, "rangeResolution" },
  { [](Device& d) { d.rangeResolution = -1.0; }, "rangeResolution" },
  { [](Device& d) { d.beamDiameter = -1.0; }, "beamDiameter" },
  { [](Device& d) { d.beamDiameter = 1.1e6; }, "beamDiameter" },
  { [](Device& d) { d.beamDivergence = 1.01; }, "beamDivergence" },
  { [](Device& d) { d.beamDivergence = NaN; }, "beamDivergence" },
  { [](Device& d) { d.beamSamples = 0; }, "beamSamples" },
  { [](Device& d) { d.beamSamples = 1001; }, "beamSamples is 1001; it must be from 1 to 1,000" },
  { [](Device& d) { d.pulseLength = -1.0; }, "pulseLength" },
  { [](Device& d) { d.rangeAtTenPercent = Infinity; }, "rangeAtTenPercent" },
  { [](Device& d) { d.axisOffset.y = NaN; }, "axisOffset" },
  { [](Device& d) { d.axisOffset.z = 1e18; }, "axisOffset" },
  { [](Device& d) { d.turnRate = -Infinity; }, "turnRate" },
  { [](Device& d) { d.turnRate = 1e300; }, "turnRate" },
};
} // namespace

TEST(ServerDevice, RefusesWhatIsOutsideOfTheLimits)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::Status_var before = scanner->getStatus();
  for (const BadDevice& bad : BadDevices)
  {
    Device device = lms3dGetIdealDevice();
    bad.Change(device);
    try
    {
      scanner->setDevice(device);
      ADD_FAILURE() << bad.Word << " was taken";
    }
    catch (const LMS3D::InvalidArgument& problem)
    {
      EXPECT_NE(std::strstr(problem.reason, bad.Word), nullptr) << problem.reason;
    }
  }
  Device device = lms3dGetIdealDevice();
  device.reflectanceArray = std::string(129, 'x').c_str();
  EXPECT_THROW(scanner->setDevice(device), CORBA::SystemException);
  const LMS3D::Status_var after = scanner->getStatus();
  EXPECT_EQ(after->generation, before->generation);
  EXPECT_STREQ(after->problem, "");
}

TEST(ServerDevice, RefusesMoreRaysThanFit)
{
  ServerProcess server({ "--no-map" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  LMS3D::Configuration configuration = GetCoarseGrid();
  configuration.makeMap = false;
  scanner->setConfiguration(configuration);
  Device device = lms3dGetIdealDevice();
  device.beamSamples = 1000;
  const CORBA::ULongLong generation = scanner->setDevice(device);
  configuration.alpha.count = 1000;
  configuration.beta.count = 201;
  try
  {
    scanner->setConfiguration(configuration);
    ADD_FAILURE() << "taken";
  }
  catch (const LMS3D::LimitExceeded& problem)
  {
    EXPECT_EQ(problem.limit, 200000000u);
    EXPECT_NE(std::strstr(problem.reason, "is 201000000"), nullptr) << problem.reason;
  }
  device.beamSamples = 1;
  scanner->setDevice(device);
  EXPECT_EQ(scanner->setConfiguration(configuration), generation + 2);
  device.beamSamples = 996;
  EXPECT_THROW(scanner->setDevice(device), LMS3D::LimitExceeded);
  const LMS3D::Status_var status = scanner->getStatus();
  EXPECT_EQ(status->generation, generation + 2);
}
