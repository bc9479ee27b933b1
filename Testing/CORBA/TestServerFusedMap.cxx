// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The map of many scans, as clients fetch it.
#include "Client/lms3dRemoteFusedMap.h"
#include "ClientORB.h"
#include "DirectFusedMap.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <thread>
#include <vector>

#include <vtkNew.h>
#include <vtkPolyData.h>

namespace
{
constexpr double Bound = 0.02;

const std::vector<LMS3D::Pose> Poses = { At(0.3, -0.2, 1.0), At(-1.0, -0.2, 1.0), At(0.5, 0.4, 1.2),
  At(1.0, 0.5, 1.0) };

/// A server that has not scanned from any pose but the first.
class FusedServer : public ServerProcess
{
public:
  explicit FusedServer(const std::vector<std::string>& more = {})
    : ServerProcess(GetArguments(more))
  {
  }

  LMS3D::LaserScanner_var Connect() const
  {
    const LMS3D::LaserScanner_var scanner = ::Connect(this->GetCorbaloc());
    WaitFor(scanner);
    return scanner;
  }

private:
  static std::vector<std::string> GetArguments(const std::vector<std::string>& more)
  {
    std::vector<std::string> arguments = { "--fused-map", "0.02", "--map-error", "0.02",
      "--position", "0.3", "-0.2", "1" };
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
};

void MoveTo(LMS3D::LaserScanner_ptr scanner, const LMS3D::Pose& pose)
{
  WaitFor(scanner, scanner->setPose(pose));
}

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
  const FusedServer server;
  const LMS3D::LaserScanner_var scanner = server.Connect();
  lms3dRemoteFusedMap map;
  EXPECT_TRUE(map.Update(scanner));
  EXPECT_TRUE(map.GetHeader().isWhole);
  const CORBA::ULongLong first = map.GetHeader().firstNumber;
  for (std::size_t i = 1; i < Poses.size(); ++i)
  {
    MoveTo(scanner, Poses[i]);
    EXPECT_TRUE(map.Update(scanner));
    EXPECT_FALSE(map.GetHeader().isWhole);
    EXPECT_EQ(map.GetHeader().scans, i + 1);
    EXPECT_EQ(map.GetHeader().firstNumber, first);
    EXPECT_STREQ(map.GetHeader().problem, "");
    EXPECT_EQ(GetTriangles(map), FetchWhole(scanner));
  }
  EXPECT_EQ(GetTriangles(map), MakeFusedTriangles("room.wrl", scanner->getConfiguration(), Poses));
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
  const FusedServer server;
  const LMS3D::LaserScanner_var scanner = server.Connect();
  lms3dRemoteFusedMap map;
  map.Update(scanner);
  for (const LMS3D::Pose& pose : Poses)
  {
    MoveTo(scanner, pose);
  }
  map.Update(scanner);
  EXPECT_FALSE(map.GetHeader().isWhole);
  EXPECT_EQ(GetTriangles(map), FetchWhole(scanner));
}

// Of the future, of an earlier server, and of a map before this one.
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
  const FusedServer server;
  const LMS3D::LaserScanner_var scanner = server.Connect();
  lms3dRemoteFusedMap map;
  map.Update(scanner);
  LMS3D::Configuration configuration = scanner->getConfiguration();
  configuration.beta.count = 180;
  const auto expectNewMap = [&](CORBA::ULongLong generation)
  {
    MoveTo(scanner, Poses[1]);
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

TEST(ServerFusedMap, SaysWhyScansAreNotAdded)
{
  const FusedServer server;
  const LMS3D::LaserScanner_var scanner = server.Connect();
  LMS3D::Configuration configuration = scanner->getConfiguration();
  for (const double error : { 0.0, 2.0 * Bound })
  {
    configuration.mapError = error;
    WaitFor(scanner, scanner->setConfiguration(configuration));
    const LMS3D::FusedMap_var map = scanner->getFusedMap(0);
    EXPECT_EQ(map->header.scans, 0U);
    EXPECT_EQ(map->header.allTriangles, 0U);
    EXPECT_NE(
      std::string(map->header.problem).find("mapError above 0 and up to 0.02"), std::string::npos);
  }
  configuration.mapError = Bound;
  WaitFor(scanner, scanner->setConfiguration(configuration));
  const LMS3D::FusedMap_var map = scanner->getFusedMap(0);
  EXPECT_EQ(map->header.scans, 1U);
  EXPECT_STREQ(map->header.problem, "");
}

// 129,960 beams of four bytes: one scan fits into a megabyte, three do not.
TEST(ServerFusedMap, KeepsItsMemoryLimit)
{
  const FusedServer server({ "--fused-memory", "1" });
  const LMS3D::LaserScanner_var scanner = server.Connect();
  for (const LMS3D::Pose& pose : Poses)
  {
    MoveTo(scanner, pose);
  }
  LMS3D::FusedMapHeader_var header = scanner->getFusedMapHeader(0);
  EXPECT_EQ(header->scans, 1U);
  EXPECT_NE(std::string(header->problem).find("--fused-memory"), std::string::npos);
  WaitFor(scanner, scanner->resetFusedMap());
  header = scanner->getFusedMapHeader(0);
  EXPECT_STREQ(header->problem, "");
}

TEST(ServerFusedMap, WithoutTheOptionThereIsNone)
{
  const ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  WaitFor(scanner);
  EXPECT_THROW(scanner->getFusedMap(0), LMS3D::NoFusedMap);
  EXPECT_THROW(scanner->getFusedMapHeader(0), LMS3D::NoFusedMap);
  EXPECT_THROW(scanner->resetFusedMap(), LMS3D::NoFusedMap);
  EXPECT_THROW(scanner->getFusedRegions(1, 0, 0, 0), LMS3D::FusedMapGone);
}

TEST(ServerFusedMap, AReadOnlyServerIsNotReset)
{
  const FusedServer server({ "--read-only" });
  const LMS3D::LaserScanner_var scanner = server.Connect();
  EXPECT_THROW(scanner->resetFusedMap(), LMS3D::NotPermitted);
  EXPECT_FALSE(FetchWhole(scanner).empty());
}

TEST(ServerFusedMap, PartsAreRefusedBeyondTheEnd)
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

// The smallest message of omniORB has 8,192 bytes, and the headers of the parts take 2,048 of them.
TEST(ServerFusedMap, LargeChangesComeInParts)
{
  const FusedServer server({ "-ORBgiopMaxMsgSize", "8192" });
  const LMS3D::LaserScanner_var scanner = server.Connect();
  lms3dRemoteFusedMap map;
  map.Update(scanner);
  EXPECT_GT(map.GetReceivedBytes(), 8192U);
  EXPECT_THROW(scanner->getFusedMap(0), LMS3D::LimitExceeded);
  EXPECT_EQ(GetTriangles(map),
    MakeFusedTriangles("room.wrl", scanner->getConfiguration(), { Poses.front() }));
}

TEST(ServerFusedMap, ManyClientsWhileTheMapGrows)
{
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
    MoveTo(scanner, Poses[static_cast<std::size_t>(i) % Poses.size()]);
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
