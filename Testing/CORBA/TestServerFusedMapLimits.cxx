// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// What a server refuses about its map of many scans, and what it leaves out.
#include "FusedServer.h"
#include "Sanitizers.h"

#include <gtest/gtest.h>

#include <string>

TEST(ServerFusedMapLimits, SaysWhyScansAreNotAdded)
{
  const FusedServer server;
  const LMS3D::LaserScanner_var scanner = server.Connect();
  LMS3D::Configuration configuration = scanner->getConfiguration();
  for (const double error : { 0.0, 2.0 * FusedBound })
  {
    configuration.mapError = error;
    WaitFor(scanner, scanner->setConfiguration(configuration));
    const LMS3D::FusedMap_var map = scanner->getFusedMap(0);
    EXPECT_EQ(map->header.scans, 0U);
    EXPECT_EQ(map->header.allTriangles, 0U);
    EXPECT_NE(
      std::string(map->header.problem).find("mapError above 0 and up to 0.02"), std::string::npos);
  }
  configuration.mapError = FusedBound;
  WaitFor(scanner, scanner->setConfiguration(configuration));
  const LMS3D::FusedMap_var map = scanner->getFusedMap(0);
  EXPECT_EQ(map->header.scans, 1U);
  EXPECT_STREQ(map->header.problem, "");
}

// The scan has 0.6 MB. The cells of the room's walls, and its 1,100 triangles if each of them is a
// region, have 6 MB each.
TEST(ServerFusedMapLimits, KeepsItsMemoryLimit)
{
  const FusedServer server({ "--fused-memory", "16" });
  const LMS3D::LaserScanner_var scanner = server.Connect();
  LMS3D::FusedMapHeader_var header = scanner->getFusedMapHeader(0);
  EXPECT_STREQ(header->problem, "");
  for (const LMS3D::Pose& pose : GetFusedPoses())
  {
    MoveTo(scanner, pose);
  }
  header = scanner->getFusedMapHeader(0);
  EXPECT_EQ(header->scans, 1U);
  EXPECT_GT(header->triangles, 0U);
  EXPECT_NE(std::string(header->problem).find("--fused-memory"), std::string::npos);
  WaitFor(scanner, scanner->resetFusedMap());
  header = scanner->getFusedMapHeader(0);
  EXPECT_EQ(header->scans, 1U);
  EXPECT_STREQ(header->problem, "");
}

TEST(ServerFusedMapLimits, AMapThatIsTooLargeStaysEmpty)
{
  const FusedServer server({ "--fused-memory", "1" });
  const LMS3D::LaserScanner_var scanner = server.Connect();
  const LMS3D::FusedMapHeader_var header = scanner->getFusedMapHeader(0);
  EXPECT_EQ(header->scans, 0U);
  EXPECT_NE(std::string(header->problem).find("--fused-memory"), std::string::npos);
}

// Floats resolve a tenth of 2 cm up to 34 km away.
// Each scan takes 65 kB, also with few beams.
TEST(ServerFusedMapLimits, ManySmallScansReachTheLimit)
{
  const FusedServer server({ "--fused-memory", "20", "--rate", "0" });
  const LMS3D::LaserScanner_var scanner = server.Connect();
  LMS3D::Configuration configuration = scanner->getConfiguration();
  configuration.alpha.count = 8;
  configuration.beta.count = 8;
  WaitFor(scanner, scanner->setConfiguration(configuration));
  const long before = server.GetResidentMemory();
  LMS3D::FusedMapHeader_var header = scanner->getFusedMapHeader(0);
  EXPECT_STREQ(header->problem, "");
  for (int i = 0; i < 400; ++i)
  {
    MoveTo(scanner, GetFusedPoses().front());
  }
  header = scanner->getFusedMapHeader(0);
  EXPECT_GT(header->scans, 200U);
  EXPECT_LT(header->scans, 310U);
  EXPECT_NE(std::string(header->problem).find("--fused-memory"), std::string::npos);
  if (!IsSanitized)
  {
    EXPECT_LT(server.GetResidentMemory() - before, 40'000'000);
  }
}

// Nearly all returns are loose, and each of them takes a block of cells.
TEST(ServerFusedMapLimits, NoiseReachesTheLimit)
{
  const FusedServer server({ "--fused-memory", "100" });
  const LMS3D::LaserScanner_var scanner = server.Connect();
  LMS3D::Configuration configuration = scanner->getConfiguration();
  configuration.alpha.count = 181;
  configuration.beta.count = 180;
  configuration.mapError = 0.01;
  WaitFor(scanner, scanner->setConfiguration(configuration));
  LMS3D::Device_var device = scanner->getDevice();
  device->rangeNoise = 0.05;
  WaitFor(scanner, scanner->setDevice(device));
  for (const LMS3D::Pose& pose : GetFusedPoses())
  {
    MoveTo(scanner, pose);
  }
  const LMS3D::FusedMapHeader_var header = scanner->getFusedMapHeader(0);
  EXPECT_LT(header->scans, 2U);
  EXPECT_NE(std::string(header->problem).find("--fused-memory"), std::string::npos);
}

TEST(ServerFusedMapLimits, PosesTooFarFromTheOriginAreNotAdded)
{
  const FusedServer server;
  const LMS3D::LaserScanner_var scanner = server.Connect();
  MoveTo(scanner, At(33000.0, 0.0, 1.0));
  LMS3D::FusedMapHeader_var header = scanner->getFusedMapHeader(0);
  EXPECT_EQ(header->scans, 2U);
  EXPECT_STREQ(header->problem, "");
  MoveTo(scanner, At(35000.0, 0.0, 1.0));
  header = scanner->getFusedMapHeader(0);
  EXPECT_EQ(header->scans, 2U);
  EXPECT_NE(std::string(header->problem).find("far from the origin"), std::string::npos);
  WaitFor(scanner, scanner->resetFusedMap());
  header = scanner->getFusedMapHeader(0);
  EXPECT_EQ(header->scans, 1U);
  EXPECT_STREQ(header->problem, "");
}

TEST(ServerFusedMapLimits, WithoutTheOptionThereIsNone)
{
  const ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  WaitFor(scanner);
  EXPECT_THROW(scanner->getFusedMap(0), LMS3D::NoFusedMap);
  EXPECT_THROW(scanner->getFusedMapHeader(0), LMS3D::NoFusedMap);
  EXPECT_THROW(scanner->resetFusedMap(), LMS3D::NoFusedMap);
  EXPECT_THROW(scanner->getFusedRegions(1, 0, 0, 0), LMS3D::FusedMapGone);
}

TEST(ServerFusedMapLimits, AReadOnlyServerIsNotReset)
{
  const FusedServer server({ "--read-only" });
  const LMS3D::LaserScanner_var scanner = server.Connect();
  EXPECT_THROW(scanner->resetFusedMap(), LMS3D::NotPermitted);
  const LMS3D::FusedMapHeader_var header = scanner->getFusedMapHeader(0);
  EXPECT_GT(header->triangles, 0U);
}

TEST(ServerFusedMapLimits, PartsAreRefusedBeyondTheEnd)
{
  const FusedServer server;
  const LMS3D::LaserScanner_var scanner = server.Connect();
  const LMS3D::FusedMapHeader_var header = scanner->getFusedMapHeader(0);
  const CORBA::ULongLong number = header->number;
  const LMS3D::Offsets_var none = scanner->getFusedPoints(number, 0, header->points, 0);
  EXPECT_EQ(none->length(), 0U);
  const CORBA::ULong many = ~CORBA::ULong(0);
  for (const CORBA::ULong first : { header->points, many })
  {
    EXPECT_THROW(scanner->getFusedPoints(number, 0, first, 1), LMS3D::InvalidArgument);
  }
  EXPECT_THROW(scanner->getFusedTriangles(number, 0, 0, many), LMS3D::InvalidArgument);
  EXPECT_THROW(scanner->getFusedRegions(number, 0, 1, header->regions), LMS3D::InvalidArgument);
  EXPECT_THROW(scanner->getFusedTriangles(number, number, 0, 1), LMS3D::InvalidArgument);
  EXPECT_THROW(scanner->getFusedRegions(number + 1, 0, 0, 1), LMS3D::FusedMapGone);
  EXPECT_THROW(scanner->getFusedRegions(0, 0, 0, 1), LMS3D::FusedMapGone);
}
