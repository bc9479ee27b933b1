// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The example clients in other languages, run as programs.
#include "Client/lms3dRemoteFusedMap.h"
#include "ClientORB.h"
#include "ClientProgram.h"
#include "DirectPipeline.h"
#include "ServerProcess.h"
#include "WaitingClients.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <vtkNew.h>
#include <vtkPolyData.h>

namespace
{
using Words = std::vector<std::string>;

const std::string Clients = LMS3D_CLIENTS_DIR;
const std::string MadeClients = LMS3D_MADE_CLIENTS_DIR;

Client GetJavaClient(const std::string& name)
{
  std::string jar = MadeClients;
  jar.append("/Java/").append(name).append("/").append(name).append(".jar");
  return { { "java", "-jar", jar }, {} };
}

Client GetGIOPClient(const Words& option)
{
  return { { LMS3D_PYTHON, Clients + "/Python/lms3d_paper_client.py" }, option, true };
}

Client GetOmniORBpyClient(const Words& command)
{
  const std::string made = MadeClients + "/Python";
  return { { "env", "PYTHONDONTWRITEBYTECODE=1", "PYTHONPATH=" + made + "/stubs",
             made + "/environment/bin/python", Clients + "/Python/lms3d_scanner_client.py" },
    command };
}

Client GetCxxClient(const Words& command)
{
  return { { LMS3D_CLIENT }, command };
}

DirectPipeline MakeDirect(const LMS3D::ScanHeader& header)
{
  return DirectPipeline(header.scene.in(), header.sensorPose, header.settings);
}

} // namespace

class PaperClient : public testing::TestWithParam<Client>
{
};

TEST_P(PaperClient, PrintsTheDirectPipelinesTriples)
{
  const TemporaryFile file("lms3d-ior");
  // A low rate leaves the cores to the client.
  ServerProcess server({ "--ior", file.Path.string(), "--rate", "0.5" });
  const std::string reference = GetParam().TakesFile ? file.Path.string() : server.GetIOR();
  const std::vector<float> triples = ReadTable(RunClient(GetParam(), reference));
  ASSERT_EQ(triples.size(), 389880u);
  EXPECT_EQ(triples, MakeDirect(WaitFor(Connect(server.GetCorbaloc()))).Triples);
}

TEST_P(PaperClient, ReportsThatThereIsNoServer)
{
  const TemporaryFile file("lms3d-ior");
  ServerProcess server;
  std::ofstream(file.Path) << server.GetIOR() << '\n';
  const std::string reference = GetParam().TakesFile ? file.Path.string() : server.GetCorbaloc();
  server.Terminate(SIGKILL);
  const Outcome outcome = RunClient(GetParam(), reference);
  EXPECT_EQ(outcome.Code, 1);
  EXPECT_NE(outcome.Text, "");
}

INSTANTIATE_TEST_SUITE_P(Java, PaperClient, testing::Values(GetJavaClient("paper-client")));
INSTANTIATE_TEST_SUITE_P(
  GIOP, PaperClient, testing::Values(GetGIOPClient({}), GetGIOPClient({ "--big-endian" })));
INSTANTIATE_TEST_SUITE_P(OmniORBpy, PaperClient, testing::Values(GetOmniORBpyClient({ "fetch" })));

/// Clients that move the sensor.
class ScannerClient : public testing::TestWithParam<Client>
{
};

TEST_P(ScannerClient, PrintsTheScanFromWhereItMovedTheSensor)
{
  ServerProcess server({ "--orientation", "10", "-20", "30" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  LMS3D::Configuration configuration = GetCoarseGrid();
  configuration.maximumRange = 3.5;
  scanner->setConfiguration(configuration);
  const std::vector<float> triples =
    ReadTable(RunClient(GetParam(), server.GetCorbaloc(), { "0.4", "-0.3", "0.9" }));
  LMS3D::Pose pose = At(0.4, -0.3, 0.9);
  pose.orientation = { 10.0, -20.0, 30.0 };
  EXPECT_EQ(triples, DirectPipeline("room.wrl", pose, configuration).Triples);
  EXPECT_NE(std::find(triples.begin(), triples.end(), 0.0f), triples.end()) << "no misses";
}

TEST_P(ScannerClient, ReportsWhyAPositionIsRefused)
{
  ServerProcess server;
  const Outcome outcome = RunClient(GetParam(), server.GetCorbaloc(), { "0", "2e6", "0" });
  EXPECT_EQ(outcome.Code, 1);
  EXPECT_NE(outcome.Text.find("InvalidArgument: a coordinate of the position is 2000000"),
    std::string::npos)
    << outcome.Text;
}

TEST_P(ScannerClient, ReportsThatItMayNotMoveTheSensor)
{
  ServerProcess server({ "--read-only" });
  const Outcome outcome = RunClient(GetParam(), server.GetCorbaloc(), { "0", "0", "1" });
  EXPECT_EQ(outcome.Code, 1);
  EXPECT_NE(outcome.Text.find("NotPermitted"), std::string::npos) << outcome.Text;
}

TEST_P(ScannerClient, PrintsNoScanFromWhereAnotherClientMovedTheSensor)
{
  // Another client sends hundreds of poses during each scan. Seldom a scan begins between the
  // client's pose and the next one of the other client.
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::Configuration configuration = GetCoarseGrid();
  scanner->setConfiguration(configuration);
  const std::vector<float> expected =
    DirectPipeline("room.wrl", At(0.4, -0.3, 0.9), configuration).Triples;
  std::atomic<bool> isOver(false);
  std::thread other(
    [&]
    {
      while (!isOver)
      {
        scanner->setPose(At(0.0, 0.0, 1.0));
      }
    });
  Outcome outcome{ 0, "" };
  for (int i = 0; i < 20 && outcome.Code == 0; ++i)
  {
    outcome = RunClient(GetParam(), server.GetCorbaloc(), { "0.4", "-0.3", "0.9" });
    if (outcome.Code == 0)
    {
      EXPECT_EQ(ReadTable(outcome), expected);
    }
  }
  isOver = true;
  other.join();
  EXPECT_EQ(outcome.Code, 1);
  EXPECT_NE(outcome.Text.find("another client has changed the settings"), std::string::npos)
    << outcome.Text.substr(0, 300);
}

TEST_P(ScannerClient, GivesUpOnAServerThatHangs)
{
  ServerProcess server;
  kill(server.GetProcess(), SIGSTOP);
  const Outcome outcome = RunClient(GetParam(), server.GetCorbaloc(), { "0", "0", "1" });
  EXPECT_EQ(outcome.Code, 1);
  EXPECT_NE(outcome.Text, "");
}

INSTANTIATE_TEST_SUITE_P(Java, ScannerClient, testing::Values(GetJavaClient("scanner-client")));
INSTANTIATE_TEST_SUITE_P(
  OmniORBpy, ScannerClient, testing::Values(GetOmniORBpyClient({ "scan", "--position" })));

/// Clients that print a line for each scan.
class WatchingClient : public testing::TestWithParam<Client>
{
};

TEST_P(WatchingClient, ContinuesIfAllPlacesForWaitingCallsAreTaken)
{
  ServerProcess server;
  const WaitingClients clients(server.GetCorbaloc());
  const Outcome outcome = RunClient(GetParam(), server.GetCorbaloc(), { "3" });
  EXPECT_EQ(outcome.Code, 0);
  EXPECT_EQ(std::count(outcome.Text.begin(), outcome.Text.end(), '\n'), 3) << outcome.Text;
}

INSTANTIATE_TEST_SUITE_P(Cxx, WatchingClient, testing::Values(GetCxxClient({ "watch" })));
INSTANTIATE_TEST_SUITE_P(
  OmniORBpy, WatchingClient, testing::Values(GetOmniORBpyClient({ "watch" })));

TEST(OmniORBpyClient, SavesTheDirectPipelinesMap)
{
  const TemporaryFile file("lms3d-map");
  ServerProcess server;
  const Outcome outcome = RunClient(
    GetOmniORBpyClient({ "scan", "--map" }), server.GetCorbaloc(), { file.Path.string() });
  ASSERT_EQ(outcome.Code, 0) << outcome.Text;
  const DirectPipeline direct = MakeDirect(WaitFor(Connect(server.GetCorbaloc())));
  const Map map = ReadMap(file.Path);
  EXPECT_EQ(map.Points, direct.MapPoints);
  EXPECT_EQ(map.Triangles, direct.MapTriangles);
}

TEST(OmniORBpyClient, SavesTheMapOfAllPosesFromItsChanges)
{
  const TemporaryFile file("lms3d-map");
  const ServerProcess server({ "--fused-map", "0.01" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  WaitFor(scanner);
  const Outcome outcome = RunClient(GetOmniORBpyClient({ "grow" }), server.GetCorbaloc(),
    { file.Path.string(), "1", "0.5", "1.2", "-1", "-0.2", "1" });
  ASSERT_EQ(outcome.Code, 0) << outcome.Text;
  EXPECT_NE(outcome.Text.find("3 scans, "), std::string::npos) << outcome.Text;
  lms3dRemoteFusedMap fused;
  fused.Update(scanner);
  vtkNew<vtkPolyData> expected;
  fused.Fill(expected);
  const Map map = ReadMap(file.Path);
  ASSERT_EQ(map.Triangles.size(), 3U * expected->GetNumberOfCells());
  ASSERT_EQ(map.Points.size(), 3U * expected->GetNumberOfPoints());
  for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(map.Points[static_cast<std::size_t>(3 * i + axis)], expected->GetPoint(i)[axis]);
    }
  }
}

TEST(OmniORBpyClient, LeavesNoHalfOfAMap)
{
  const std::filesystem::path folder(LMS3D_SERVER);
  ServerProcess server;
  const Outcome outcome = RunClient(
    GetOmniORBpyClient({ "scan", "--map" }), server.GetCorbaloc(), { folder / "map.obj" });
  EXPECT_EQ(outcome.Code, 1);
  EXPECT_EQ(
    outcome.Text, "cannot write '" + (folder / "map.obj").string() + "': Not a directory\n");
}

const char* const WaitForAMillion = R"(
import sys, lms3d_scanner_client as client
client.wait_for_scan(client.connect(sys.argv[1]), after=1000000)
)";

// A client that reconnects to a restarted server, whose numbers begin at 1 again, has such a
// number.
TEST(OmniORBpyClient, DoesNotWaitForANumberThatAServerWillNotReach)
{
  ServerProcess server;
  const std::string made = MadeClients + "/Python";
  const Client client = { { "env", "PYTHONDONTWRITEBYTECODE=1",
                            "PYTHONPATH=" + made + "/stubs:" + Clients + "/Python",
                            made + "/environment/bin/python", "-c", WaitForAMillion },
    {} };
  const Outcome outcome = RunClient(client, server.GetCorbaloc());
  EXPECT_EQ(outcome.Code, 1);
  EXPECT_NE(outcome.Text.find("ValueError: the server was restarted"), std::string::npos)
    << outcome.Text;
}

TEST(OmniORBpyClient, WatchesScanAfterScan)
{
  ServerProcess server;
  const Outcome outcome = RunClient(GetOmniORBpyClient({ "watch" }), server.GetCorbaloc(), { "3" });
  EXPECT_EQ(outcome.Code, 0);
  std::istringstream lines(outcome.Text);
  unsigned long long last = 0;
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count)
  {
    unsigned long long number = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "scan %llu,", &number), 1) << line;
    EXPECT_GT(number, last);
    last = number;
  }
  EXPECT_EQ(count, 3);
}
