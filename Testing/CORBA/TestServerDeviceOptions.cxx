// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Common/lms3dDeviceNames.h"
#include "FolderTest.h"
#include "Options/lms3dServerOptions.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace
{
using ServerDeviceOptions = FolderTest;

// What the options change of an ideal device.
LMS3D::Device GetDevice(std::vector<std::string> arguments)
{
  arguments.insert(arguments.begin(), { "--scenes", "Data" });
  LMS3D::Device device = lms3dGetIdealDevice();
  for (const auto& change : lms3dReadServerOptions(arguments).DeviceChanges)
  {
    change(device);
  }
  return device;
}

std::string GetProblem(const std::vector<std::string>& arguments)
{
  try
  {
    GetDevice(arguments);
    return "none";
  }
  catch (const std::invalid_argument& problem)
  {
    return problem.what();
  }
}
} // namespace

TEST_F(ServerDeviceOptions, SetEachProperty)
{
  const LMS3D::Device device = GetDevice(
    { "--range-bias", "-0.01", "--range-noise", "0.005", "--range-resolution", "0.001", "--seed",
      "-7", "--beam-diameter", "0.012", "--beam-divergence", "0.0044", "--beam-samples", "19",
      "--pulse-length", "2", "--range-at-ten-percent", "10", "--reflectance", "Color", "--mounting",
      "yawing-top", "--axis-offset", "0.1", "-0.2", "0.3", "--turn-rate", "-37.5", "--status" });
  EXPECT_EQ(device.rangeBias, -0.01);
  EXPECT_EQ(device.rangeNoise, 0.005);
  EXPECT_EQ(device.rangeResolution, 0.001);
  EXPECT_EQ(device.noiseSeed, -7);
  EXPECT_EQ(device.beamDiameter, 0.012);
  EXPECT_EQ(device.beamDivergence, 0.0044);
  EXPECT_EQ(device.beamSamples, 19u);
  EXPECT_EQ(device.pulseLength, 2.0);
  EXPECT_EQ(device.rangeAtTenPercent, 10.0);
  EXPECT_STREQ(device.reflectanceArray, "Color");
  EXPECT_EQ(device.mounting, LMS3D::MOUNTING_YAWING_TOP);
  EXPECT_EQ(device.axisOffset.y, -0.2);
  EXPECT_EQ(device.turnRate, -37.5);
  EXPECT_TRUE(device.computeStatus);
}

TEST_F(ServerDeviceOptions, TheCommandLineWinsOverTheFile)
{
  const std::string file = this->Write("device.conf",
    "device = lms200-cm\nrange-noise = 0.01\nseed = 5\nmounting = rolling\nstatus\n");
  const LMS3D::Device device = GetDevice({ "--range-noise", "0.02", "--config", file });
  EXPECT_EQ(device.rangeNoise, 0.02);
  EXPECT_EQ(device.noiseSeed, 5);
  EXPECT_EQ(device.mounting, LMS3D::MOUNTING_ROLLING);
  EXPECT_TRUE(device.computeStatus);
  EXPECT_EQ(lms3dReadServerOptions({ "--scenes", "Data", "--config", file }).Device, "lms200-cm");
}

TEST_F(ServerDeviceOptions, AreRefusedOutsideOfTheirLimits)
{
  EXPECT_EQ(GetProblem({ "--device", "sick" }),
    "--device: \"sick\" is none of ideal, lms200-mm, lms200-cm, lms291");
  EXPECT_EQ(GetProblem({ "--mounting", "up" }),
    "--mounting: \"up\" is none of yawing, yawing-top, pitching, rolling");
  EXPECT_EQ(
    GetProblem({ "--range-noise", "-1" }), "--range-noise: \"-1\" is not a number from 0 to 1e+06");
  EXPECT_EQ(GetProblem({ "--beam-samples", "1001" }),
    "--beam-samples: \"1001\" is not a whole number from 1 to 1000");
  for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{
         { "--range-bias", "nan" }, { "--range-resolution", "inf" }, { "--seed", "2147483648" },
         { "--beam-diameter", "-1" }, { "--beam-divergence", "1.1" }, { "--beam-samples", "0" },
         { "--pulse-length", "x" }, { "--range-at-ten-percent", "1e7" },
         { "--reflectance", std::string(129, 'x') }, { "--axis-offset", "1", "2" },
         { "--axis-offset", "0", "0", "1e18" }, { "--turn-rate", "1e300" }, { "--status=on" } })
  {
    EXPECT_NE(GetProblem(bad), "none") << bad[0];
  }
}

TEST_F(ServerDeviceOptions, AnOptionAndAPresetHaveTheNamesOfTheTable)
{
  for (const std::string& name : lms3dGetPresetNames())
  {
    EXPECT_EQ(GetProblem({ "--device", name }), "none");
    ASSERT_TRUE(lms3dFindPreset(name));
    EXPECT_NE(lms3dGetServerHelp().find(name), std::string::npos) << name;
  }
}
