// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The local map in one message.
#include "ClientORB.h"
#include "DirectPipeline.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

TEST(ServerMap, OneCallReturnsTheDirectPipelinesMap)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::ScanHeader moved = WaitFor(scanner, scanner->setPose(At(0.5, 0.1, 1.1)));
  const LMS3D::LocalMap_var map = scanner->getMap();
  EXPECT_GE(map->header.number, moved.number);
  EXPECT_EQ(map->header.mapPoints, map->points.length() / 3);
  const DirectPipeline direct("room.wrl", moved.sensorPose, moved.settings);
  const double* const points = map->points.get_buffer();
  const CORBA::ULong* const triangles = map->triangles.get_buffer();
  EXPECT_EQ(std::vector<double>(points, points + map->points.length()), direct.MapPoints);
  EXPECT_EQ(std::vector<std::uint32_t>(triangles, triangles + map->triangles.length()),
    direct.MapTriangles);
}

TEST(ServerMap, AServerWithoutMapsReturnsAnEmptyOne)
{
  ServerProcess server({ "--no-map" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  WaitFor(scanner);
  const LMS3D::LocalMap_var map = scanner->getMap();
  EXPECT_EQ(map->header.beams, 129960u);
  EXPECT_EQ(map->points.length(), 0u);
  EXPECT_EQ(map->triangles.length(), 0u);
}

TEST(ServerMap, AMapOverTheMessageLimitIsRefused)
{
  ServerProcess server({ "--map-error", "0" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::ScanHeader header = WaitFor(scanner);
  try
  {
    scanner->getMap();
    ADD_FAILURE() << "more than a message was sent";
  }
  catch (const LMS3D::LimitExceeded& problem)
  {
    EXPECT_LT(problem.limit, 2097152u);
    EXPECT_GT(problem.limit, 2000000u);
    EXPECT_GT(header.mapPoints * 24u + header.mapTriangles * 12u, problem.limit);
  }
}
