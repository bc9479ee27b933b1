// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// Sources behind connections that are slow, break, or lead to no server.
#include "ClientORB.h"
#include "NetworkLine.h"
#include "ServerProcess.h"
#include "WatchingSource.h"

#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace
{
// 8 MB, in four messages or more.
constexpr int Beams = 2000000;
constexpr std::size_t ScanBytes = sizeof(float) * Beams;

void MakeLarge(const ServerProcess& server)
{
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  LMS3D::Configuration configuration = GetCoarseGrid();
  configuration.alpha = { -90.0, 90.0, 2000 };
  configuration.beta = { 0.0, 360.0, Beams / 2000 };
  configuration.makeMap = false;
  WaitFor(scanner, scanner->setConfiguration(configuration));
}

/// Accepts connections and never answers, as a system does for a program that hangs.
class Silence
{
public:
  Silence()
    : Listener(socket(AF_INET, SOCK_STREAM, 0))
  {
    listen(this->Listener, SOMAXCONN);
  }
  ~Silence() { close(this->Listener); }
  Silence(const Silence&) = delete;
  void operator=(const Silence&) = delete;

  int GetPort() const
  {
    sockaddr_in address = {};
    socklen_t size = sizeof(address);
    getsockname(this->Listener, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
  }

private:
  const int Listener;
};
} // namespace

TEST(RemoteLine, AWholeScanHasToComeWithinTheTimeout)
{
  ServerProcess server({ "--rate", "1", "--keep", "20" });
  MakeLarge(server);
  NetworkLine line(server.GetCorbaloc(), 4 * ScanBytes / 10);
  WatchingSource source(line.GetCorbaloc());
  source->SetTimeout(1.0);
  source->Update();
  EXPECT_TRUE(source.UpdateUntil([&] { return !source->GetProblem().empty(); }));
  EXPECT_NE(source->GetProblem().find("cannot be fetched within the Timeout"), std::string::npos)
    << source->GetProblem();
  EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 0);

  source->SetTimeout(60.0);
  source->Update();
  EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), Beams);
  EXPECT_EQ(source->GetProblem(), "");
}

TEST(RemoteLine, AFetchEndsWithItsSource)
{
  ServerProcess server({ "--rate", "1", "--keep", "20" });
  MakeLarge(server);
  NetworkLine line(server.GetCorbaloc(), ScanBytes / 10);
  {
    WatchingSource source(line.GetCorbaloc());
    source->SetTimeout(60.0);
    // Starts the source without waiting.
    source->SendPose();
    for (int i = 0; i < 2000 && line.GetBytes() < ScanBytes / 5; ++i)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
  EXPECT_GT(line.GetBytes(), ScanBytes / 5);
  std::size_t before = 0;
  for (std::size_t now = line.GetBytes(); now > before; now = line.GetBytes())
  {
    before = now;
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
  EXPECT_LT(before, ScanBytes / 2);
}

TEST(RemoteLine, APoseIsSentAgainWhereItMayBeLost)
{
  ServerProcess server;
  NetworkLine line(server.GetCorbaloc());
  WatchingSource source(line.GetCorbaloc());
  source->Update();
  line.BreakAt("setPose");
  source->SetPosition(0.75, 0.5, 1.5);
  source->SendPose();
  source->SetPosition(1.25, 0.5, 1.5);
  source->SendPose();
  EXPECT_TRUE(source->IsPosePending());
  EXPECT_TRUE(source.UpdateUntil([&] { return line.IsBroken(); }));
  EXPECT_TRUE(source.UpdateUntil([&] { return source.GetSensorX() != 0.3; }));
  EXPECT_EQ(source.GetSensorX(), 1.25) << "not the newest pose alone";
  EXPECT_FALSE(source->IsPosePending());
  EXPECT_TRUE(source.UpdateUntil([&] { return source->GetProblem().empty(); }));
}

TEST(RemoteLine, ANamingServiceHasTheTimeoutForItsAnswer)
{
  const Silence silence;
  WatchingSource source(
    "corbaname:iiop:1.2@127.0.0.1:" + std::to_string(silence.GetPort()) + "#LMS3D.Scanner");
  source->SetTimeout(0.5);
  source->Update();
  EXPECT_TRUE(source.UpdateUntil([&] { return !source->GetProblem().empty(); }, 4));
  EXPECT_NE(source->GetProblem().find("does not answer in time"), std::string::npos)
    << source->GetProblem();
}
