// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClientORB.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <cstring>

TEST(ServerSettings, GenerationMarksTheFirstScanFromAPose)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  CORBA::ULongLong before = WaitFor(scanner).generation;
  for (const double x : { 0.5, -0.5, 0.25 })
  {
    const CORBA::ULongLong generation = scanner->setPose(At(x, 0.0, 1.0));
    EXPECT_GT(generation, before);
    before = generation;
    const LMS3D::ScanHeader header = WaitFor(scanner, generation);
    EXPECT_EQ(header.generation, generation);
    EXPECT_EQ(header.sensorPose.position.x, x);
    const LMS3D::Pose pose = scanner->getPose();
    EXPECT_EQ(pose.position.x, x);
  }
}

TEST(ServerSettings, ConfigurationIsUsedAndReturned)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  LMS3D::Configuration configuration = GetCoarseGrid();
  configuration.makeMap = false;
  configuration.method = LMS3D::METHOD_FAST;
  const LMS3D::ScanHeader header = WaitFor(scanner, scanner->setConfiguration(configuration));
  EXPECT_EQ(header.beams, 13u * 36u);
  EXPECT_EQ(header.mapPoints, 0u);
  EXPECT_EQ(header.mapTriangles, 0u);
  const LMS3D::Configuration now = scanner->getConfiguration();
  EXPECT_EQ(now.alpha.count, 13u);
  EXPECT_EQ(now.method, LMS3D::METHOD_FAST);
  EXPECT_FALSE(now.makeMap);
}

TEST(ServerSettings, TakesAFullCircleThatRoundingMakesLonger)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  LMS3D::Configuration configuration = GetCoarseGrid();
  configuration.beta = { 213.7, 573.7, 36 };
  ASSERT_GT(configuration.beta.stop - configuration.beta.start, 360.0);
  const LMS3D::ScanHeader header = WaitFor(scanner, scanner->setConfiguration(configuration));
  EXPECT_EQ(header.beams, 13u * 36u);
  configuration.beta.stop += 1e-5;
  try
  {
    scanner->setConfiguration(configuration);
    ADD_FAILURE() << "taken";
  }
  catch (const LMS3D::InvalidArgument& problem)
  {
    EXPECT_NE(std::strstr(problem.reason, "is 360.0000100"), nullptr) << problem.reason;
  }
}
