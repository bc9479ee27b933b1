// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// What a script, which draws no window, does to follow a server.
#include "ServerProcess.h"
#include "WatchingSource.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>

TEST(RemoteRefresh, EachUpdateHasANewScan)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  source->SetTimeout(20.0);
  EXPECT_TRUE(source->Refresh()) << "the first update waits itself";
  source->Update();
  for (int i = 0; i < 5; ++i)
  {
    const std::uint64_t before = source.GetNumber("ScanNumber");
    EXPECT_TRUE(source->Refresh());
    source->Update();
    EXPECT_GT(source.GetNumber("ScanNumber"), before);
  }
}

TEST(RemoteRefresh, WaitsForTheScanFromTheLastPose)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  source->SetTimeout(20.0);
  source->Update();
  for (const double x : { 1.25, 0.5, -0.25 })
  {
    source->SetPosition(x, 0.5, 1.5);
    source->SendPose();
    EXPECT_TRUE(source->Refresh());
    source->Update();
    EXPECT_EQ(source.GetSensorX(), x);
    EXPECT_FALSE(source->IsPosePending());
  }
}

TEST(RemoteRefresh, DoesNotWaitForAPoseThatIsRefused)
{
  ServerProcess server({ "--read-only" });
  WatchingSource source(server.GetCorbaloc());
  source->SetTimeout(20.0);
  source->Update();
  source->SendPose();
  EXPECT_TRUE(source->Refresh());
  source->Update();
  EXPECT_NE(source.TakeWarnings().find("not permit"), std::string::npos);
}

TEST(RemoteRefresh, WaitsForTheTimeoutAndKeepsTheLastScan)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  source->SetTimeout(3.0);
  source->Update();
  EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 129960);
  server.Terminate(SIGKILL);
  // The last scan may have arrived after the update.
  source->Refresh();
  source->Update();
  const auto start = std::chrono::steady_clock::now();
  EXPECT_FALSE(source->Refresh());
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(2900));
  source->Update();
  EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 129960);
}
