// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The map of many scans, as clients fetch it.
#include "Client/lms3dRemoteFusedMap.h"
#include "ClientProgram.h"
#include "DirectFusedMap.h"
#include "FusedServer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <thread>
#include <vector>

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

namespace
{
std::vector<FusedTriangle> GetTriangles(const lms3dRemoteFusedMap& map)
{
  vtkNew<vtkPolyData> data;
  map.Fill(data);
  return GetFusedTriangles(data);
}

std::vector<FusedTriangle> FetchWhole(LMS3D::LaserScanner_ptr scanner)
{
  lms3dRemoteFusedMap map;
  map.Update(scanner);
  EXPECT_TRUE(map.GetHeader().isWhole);
  return GetTriangles(map);
}
} // namespace

TEST(ServerFusedMap, ChangesAddUpToTheDirectPipelinesMap)
{
  const std::vector<LMS3D::Pose> poses = GetFusedPoses();
  const FusedServer server;
  const LMS3D::LaserScanner_var scanner = server.Connect();
  lms3dRemoteFusedMap map;
  EXPECT_TRUE(map.Update(scanner));
  EXPECT_TRUE(map.GetHeader().isWhole);
  const CORBA::ULongLong first = map.GetHeader().firstNumber;
  for (std::size_t i = 1; i < poses.size(); ++i)
  {
    MoveTo(scanner, poses[i]);
    EXPECT_TRUE(map.Update(scanner));
    EXPECT_FALSE(map.GetHeader().isWhole);
    EXPECT_EQ(map.GetHeader().scans, i + 1);
    EXPECT_EQ(map.GetHeader().firstNumber, first);
    EXPECT_STREQ(map.GetHeader().problem, "");
    EXPECT_EQ(GetTriangles(map), FetchWhole(scanner));
  }
  EXPECT_EQ(GetTriangles(map), MakeFusedTriangles("room.wrl", scanner->getConfiguration(), poses));
}

// Without a status of each beam, lost beams would open the map.
TEST(ServerFusedMap, LostBeamsAreKnownWhetherClientsSeeThemOrNot)
{
  const auto fuse = [](const std::vector<std::string>& more)
  {
    const FusedServer server(more);
    const LMS3D::LaserScanner_var scanner = server.Connect();
    for (const LMS3D::Pose& pose : GetFusedPoses())
    {
      MoveTo(scanner, pose);
    }
    return FetchWhole(scanner);
  };
  const std::vector<FusedTriangle> triangles = fuse({ "--range-at-ten-percent", "3" });
  EXPECT_EQ(triangles, fuse({ "--range-at-ten-percent", "3", "--status" }));
  EXPECT_NE(triangles, fuse({}));
}

TEST(ServerFusedMap, ASensorAtRestAddsNothing)
{
  const FusedServer server;
  const LMS3D::LaserScanner_var scanner = server.Connect();
  lms3dRemoteFusedMap map;
  map.Update(scanner);
  WaitFor(scanner, 0, WaitFor(scanner).number + 3);
  EXPECT_FALSE(map.Update(scanner));
  EXPECT_EQ(map.GetHeader().scans, 1U);
  EXPECT_EQ(map.GetReceivedBytes(), 0U);
  EXPECT_EQ(GetTriangles(map), FetchWhole(scanner));
}

TEST(ServerFusedMap, AClientThatWasAwayGetsAllChangesAtOnce)
{
  const std::vector<LMS3D::Pose> poses = GetFusedPoses();
  const FusedServer server;
  const LMS3D::LaserScanner_var scanner = server.Connect();
  lms3dRemoteFusedMap map;
  map.Update(scanner);
  for (const LMS3D::Pose& pose : poses)
  {
    MoveTo(scanner, pose);
  }
  map.Update(scanner);
  EXPECT_FALSE(map.GetHeader().isWhole);
  EXPECT_EQ(GetTriangles(map), FetchWhole(scanner));
}

// From the future, from an earlier server, and from a map before this one.
TEST(ServerFusedMap, AStateThatIsNotOfThisMapGivesTheWholeMap)
{
  const FusedServer server;
  const LMS3D::LaserScanner_var scanner = server.Connect();
  const LMS3D::FusedMapHeader_var newest = scanner->getFusedMapHeader(0);
  WaitFor(scanner, scanner->resetFusedMap());
  for (const CORBA::ULongLong since :
    { CORBA::ULongLong(1), CORBA::ULongLong(newest->number), ~CORBA::ULongLong(0) })
  {
    const LMS3D::FusedMap_var map = scanner->getFusedMap(since);
    EXPECT_TRUE(map->header.isWhole);
    EXPECT_EQ(map->header.since, since);
    EXPECT_EQ(map->header.triangles, map->header.allTriangles);
    EXPECT_GT(map->triangles.length(), 0U);
  }
}

TEST(ServerFusedMap, AllSettingsButThePoseBeginANewMap)
{
  const std::vector<LMS3D::Pose> poses = GetFusedPoses();
  const FusedServer server;
  const LMS3D::LaserScanner_var scanner = server.Connect();
  lms3dRemoteFusedMap map;
  map.Update(scanner);
  LMS3D::Configuration configuration = scanner->getConfiguration();
  configuration.beta.count = 180;
  const auto expectNewMap = [&](CORBA::ULongLong generation)
  {
    MoveTo(scanner, poses[1]);
    const CORBA::ULongLong before = map.GetHeader().number;
    WaitFor(scanner, generation);
    map.Update(scanner);
    EXPECT_TRUE(map.GetHeader().isWhole);
    EXPECT_GT(map.GetHeader().firstNumber, before);
    EXPECT_LE(map.GetHeader().scans, 2U);
    EXPECT_EQ(GetTriangles(map), FetchWhole(scanner));
  };
  expectNewMap(scanner->setConfiguration(configuration));
  expectNewMap(scanner->selectPreset("ideal"));
  expectNewMap(scanner->resetFusedMap());
  expectNewMap(scanner->selectScene("teapot.wrl"));
  EXPECT_STREQ(map.GetHeader().scene, "teapot.wrl");
}

// The smallest message of omniORB has 8,192 bytes, and the headers of the parts take 2,048 of them.
TEST(ServerFusedMap, LargeChangesComeInParts)
{
  const std::vector<LMS3D::Pose> poses = GetFusedPoses();
  const FusedServer server({ "-ORBgiopMaxMsgSize", "8192" });
  const LMS3D::LaserScanner_var scanner = server.Connect();
  lms3dRemoteFusedMap map;
  map.Update(scanner);
  EXPECT_GT(map.GetReceivedBytes(), 8192U);
  EXPECT_THROW(scanner->getFusedMap(0), LMS3D::LimitExceeded);
  EXPECT_EQ(GetTriangles(map),
    MakeFusedTriangles("room.wrl", scanner->getConfiguration(), { poses.front() }));
}

TEST(ServerFusedMap, LargeChangesComeInPartsToAClientWithALowerLimit)
{
  const FusedServer server;
  const LMS3D::LaserScanner_var scanner = server.Connect();
  lms3dRemoteFusedMap map;
  map.Update(scanner);
  EXPECT_GT(map.GetReceivedBytes(), 8192U);
  const TemporaryFile file("map.vtp");
  const Outcome outcome =
    RunClient({ { "env", "ORBgiopMaxMsgSize=8192", LMS3D_CLIENT }, { "fused" } }, server.GetIOR(),
      { file.Path.string() });
  ASSERT_EQ(outcome.Code, 0) << outcome.Text;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.Path.c_str());
  reader->Update();
  EXPECT_EQ(GetFusedTriangles(reader->GetOutput()), GetTriangles(map));
}

TEST(ServerFusedMap, PointsAreCountedFromTheFirstPoseThatSawSurface)
{
  const std::vector<LMS3D::Pose> poses = GetFusedPoses();
  const FusedServer server({ "--position", "900000", "700000", "0" });
  const LMS3D::LaserScanner_var scanner = server.Connect();
  lms3dRemoteFusedMap map;
  map.Update(scanner);
  EXPECT_EQ(map.GetHeader().allTriangles, 0U);
  for (const LMS3D::Pose& pose : { poses[0], poses[1] })
  {
    MoveTo(scanner, pose);
    map.Update(scanner);
    EXPECT_FALSE(map.GetHeader().isWhole);
    EXPECT_EQ(map.GetHeader().origin.x, poses[0].position.x);
    EXPECT_EQ(GetTriangles(map), FetchWhole(scanner));
  }
  EXPECT_EQ(GetTriangles(map),
    MakeFusedTriangles("room.wrl", scanner->getConfiguration(), { poses[0], poses[1] }));
}

TEST(ServerFusedMap, ManyClientsWhileTheMapGrows)
{
  const std::vector<LMS3D::Pose> poses = GetFusedPoses();
  FusedServer server({ "--rate", "0" });
  const LMS3D::LaserScanner_var scanner = server.Connect();
  LMS3D::Configuration configuration = scanner->getConfiguration();
  configuration.alpha.count = 91;
  configuration.beta.count = 90;
  WaitFor(scanner, scanner->setConfiguration(configuration));
  std::atomic<bool> isOver(false);
  std::atomic<int> updates(0);
  std::vector<lms3dRemoteFusedMap> maps(6);
  std::vector<std::thread> clients;
  clients.reserve(maps.size());
  for (lms3dRemoteFusedMap& map : maps)
  {
    clients.emplace_back(
      [&]
      {
        // Checks each answer.
        while (!isOver)
        {
          updates += map.Update(scanner) ? 1 : 0;
        }
      });
  }
  for (int i = 0; i < 20; ++i)
  {
    MoveTo(scanner, poses[static_cast<std::size_t>(i) % poses.size()]);
  }
  isOver = true;
  for (std::thread& client : clients)
  {
    client.join();
  }
  EXPECT_GT(updates, 20);
  const std::vector<FusedTriangle> whole = FetchWhole(scanner);
  for (lms3dRemoteFusedMap& map : maps)
  {
    map.Update(scanner);
    EXPECT_EQ(GetTriangles(map), whole);
  }
  EXPECT_EQ(server.Terminate(SIGTERM), 0);
}
