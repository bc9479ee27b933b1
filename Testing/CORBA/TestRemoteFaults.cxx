// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClientORB.h"
#include "ServerProcess.h"
#include "WaitingClients.h"
#include "WatchingSource.h"

#include <vtkErrorCode.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

namespace
{
std::vector<std::string> ListenAt(int port)
{
  return { "--endpoint", "giop:tcp:127.0.0.1:" + std::to_string(port) };
}

std::string GetCorbaloc(int port, const std::string& key = "LMS3D")
{
  return "corbaloc:iiop:1.2@127.0.0.1:" + std::to_string(port) + "/" + key;
}

std::string GetTemporaryFile()
{
  return (
    std::filesystem::path(testing::TempDir()) / ("lms3d-" + std::to_string(getpid()) + ".ior"))
    .string();
}
} // namespace

TEST(RemoteFaults, ServerIsStartedAnewAtTheSamePlace)
{
  const int port = FindFreePort();
  WatchingSource source(GetCorbaloc(port));
  std::uint64_t incarnation = 0;
  std::uint64_t seen = 0;
  {
    ServerProcess server(ListenAt(port));
    source->Update();
    incarnation = source.GetNumber("Incarnation");
    ASSERT_TRUE(source.UpdateUntil([&] { return source.GetNumber("ScanNumber") > 5; }));
    server.Terminate(SIGKILL);
    std::string warnings;
    EXPECT_TRUE(source.UpdateUntil([&] { return !(warnings += source.TakeWarnings()).empty(); }));
    EXPECT_NE(warnings.find("no server answers"), std::string::npos) << warnings;
    EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 129960) << "the last scan does not stay";
    seen = source.GetNumber("ScanNumber");
  }
  ServerProcess server(ListenAt(port));
  EXPECT_TRUE(source.UpdateUntil([&] { return source.GetNumber("Incarnation") > incarnation; }));
  EXPECT_LE(source.GetNumber("ScanNumber"), seen + 5) << "the numbers begin again";
  EXPECT_EQ(source->GetProblem(), "");
}

TEST(RemoteFaults, ServerIsStartedAnewElsewhere)
{
  const std::string file = GetTemporaryFile();
  WatchingSource source("file:" + file);
  source.ExpectNothing();
  EXPECT_NE(source.TakeWarnings().find(file), std::string::npos);
  std::uint64_t incarnation = 0;
  {
    ServerProcess server({ "--ior", file });
    EXPECT_TRUE(source.UpdateUntil([&] { return source.GetNumber("Incarnation") > 0; }));
    incarnation = source.GetNumber("Incarnation");
    EXPECT_EQ(server.Terminate(SIGTERM), 0);
  }
  ServerProcess server({ "--ior", file });
  EXPECT_TRUE(source.UpdateUntil([&] { return source.GetNumber("Incarnation") > incarnation; }));
}

TEST(RemoteFaults, NoServerAnswers)
{
  const int port = FindFreePort();
  WatchingSource source(GetCorbaloc(port));
  source.ExpectNothing();
  EXPECT_NE(source.TakeWarnings().find("no server answers"), std::string::npos);
  EXPECT_EQ(source->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_FALSE(source.UpdateUntil([] { return false; }, 2)) << "some retries later";
  EXPECT_EQ(source.TakeWarnings(), "") << "warns more than once";

  ServerProcess server(ListenAt(port));
  EXPECT_TRUE(source.UpdateUntil([&] { return source.GetScan()->GetNumberOfPoints() > 0; }));
}

TEST(RemoteFaults, URLsThatLeadNowhere)
{
  ServerProcess server;
  const std::string& corbaloc = server.GetCorbaloc();
  const std::string file = GetTemporaryFile();
  std::ofstream(file) << "no reference\n";
  const std::vector<std::string> urls = { "garbage", " ", "corbaloc:", "corbaloc:iiop:1.2@:/",
    "corbaloc:iiop:1.2@127.0.0.1:99999/LMS3D", "IOR:", "IOR:zz", "IOR:0100", "corbaname:nowhere",
    "http://127.0.0.1/", "file:", "file:/no/such/file", "file:///", "file:" + file, LMS3D_SERVER,
    corbaloc + "x", std::string(100000, 'x'), "IOR:" + std::string(100000, '0') };
  for (const std::string& url : urls)
  {
    SCOPED_TRACE(url.substr(0, 50));
    WatchingSource source(url);
    source.ExpectNothing();
    EXPECT_FALSE(source->GetProblem().empty());
    EXPECT_LT(source->GetProblem().size(), 1000u);
    EXPECT_FALSE(source.TakeWarnings().empty());
  }
  std::filesystem::remove(file);
}

TEST(RemoteFaults, WithoutAURL)
{
  WatchingSource source("");
  source->Update();
  EXPECT_EQ(source->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 0);
  EXPECT_FALSE(source->GetNeedsUpdate());
  EXPECT_EQ(source->GetProblem(), "");
}

TEST(RemoteFaults, WithoutAURLAnyMore)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  source->Update();
  source->SetPosition(0.3, -0.2, 1.0);
  source->SendPose();
  source->SetURL("");
  source->Update();
  EXPECT_EQ(source->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 0);
  // Some scans later.
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  EXPECT_FALSE(source->GetNeedsUpdate()) << "errors without end";
  EXPECT_FALSE(source->IsPosePending());

  source->SetURL(server.GetCorbaloc().c_str());
  source->Update();
  EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 129960);
}

TEST(RemoteFaults, AnotherURLIsWarnedOfAgain)
{
  WatchingSource source(GetCorbaloc(FindFreePort()));
  for (int i = 0; i < 2; ++i)
  {
    source.ExpectNothing();
    EXPECT_NE(source.TakeWarnings().find("no server answers"), std::string::npos);
    source->SetURL(GetCorbaloc(FindFreePort()).c_str());
  }
}

TEST(RemoteFaults, AllPlacesForWaitingCallsAreTaken)
{
  ServerProcess server;
  const WaitingClients clients(server.GetCorbaloc());
  WatchingSource source(server.GetCorbaloc());
  source->Update();
  const std::uint64_t first = source.GetNumber("ScanNumber");
  EXPECT_GT(first, 0u);
  EXPECT_TRUE(source.UpdateUntil([&] { return source.GetNumber("ScanNumber") >= first + 3; }));
  EXPECT_EQ(source.TakeWarnings(), "");
  EXPECT_EQ(source->GetProblem(), "");
}
