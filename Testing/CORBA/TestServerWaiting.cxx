// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClientORB.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

namespace
{
using Clock = std::chrono::steady_clock;

constexpr CORBA::ULongLong Never = ~CORBA::ULongLong(0);

using Words = std::vector<std::string>;

double SecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}
} // namespace

TEST(ServerWaiting, GivesOneScanAfterTheOther)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  LMS3D::ScanHeader before = WaitFor(scanner);
  for (int i = 0; i < 5; ++i)
  {
    const LMS3D::ScanHeader header = WaitFor(scanner, 0, before.number);
    EXPECT_GT(header.number, before.number);
    EXPECT_EQ(header.incarnation, before.incarnation);
    EXPECT_GE(header.startTime, before.endTime);
    EXPECT_GT(header.endTime, header.startTime);
    before = header;
  }
}

TEST(ServerWaiting, EndsAfterTheTimeThatIsAskedFor)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  WaitFor(scanner);
  const Clock::time_point start = Clock::now();
  EXPECT_THROW(scanner->waitForScan(Never - 1, 0, 300), LMS3D::NoScanYet);
  EXPECT_GE(SecondsSince(start), 0.29);
  EXPECT_THROW(scanner->waitForScan(0, Never, 0), LMS3D::NoScanYet);
}

// The timeout is 49 days.
TEST(ServerWaiting, NoCallWaitsLongerThanTenSeconds)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const Clock::time_point start = Clock::now();
  EXPECT_THROW(scanner->waitForScan(Never, 0, 4294967295u), LMS3D::NoScanYet);
  EXPECT_GE(SecondsSince(start), 9.9);
  EXPECT_LT(SecondsSince(start), 15.0);
}

TEST(ServerWaiting, NoMoreThanThirtyTwoWait)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  std::atomic<int> refused(0);
  std::atomic<int> timedOut(0);
  std::vector<std::thread> clients;
  clients.reserve(40);
  for (int i = 0; i < 40; ++i)
  {
    clients.emplace_back(
      [&]
      {
        try
        {
          scanner->waitForScan(Never, 0, 3000);
        }
        catch (const LMS3D::LimitExceeded& problem)
        {
          refused += problem.limit == 32 ? 1 : 1000;
        }
        catch (const LMS3D::NoScanYet&)
        {
          ++timedOut;
        }
      });
  }
  // Refused calls do not occupy a place either.
  for (int i = 0; i < 200; ++i)
  {
    const LMS3D::Status_var status = scanner->getStatus();
    EXPECT_LE(status->waiting, 32u);
  }
  for (std::thread& client : clients)
  {
    client.join();
  }
  EXPECT_EQ(timedOut, 32);
  EXPECT_EQ(refused, 8);
  const LMS3D::Status_var status = scanner->getStatus();
  EXPECT_EQ(status->waiting, 0u);
}

TEST(ServerWaiting, ScansThatWereDroppedAreGone)
{
  ServerProcess server({ "--rate", "50" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::ScanHeader first = WaitFor(scanner, scanner->setConfiguration(GetCoarseGrid()));
  const LMS3D::ScanHeader later = WaitFor(scanner, 0, first.number + 10);
  try
  {
    scanner->getRanges(first.number, 0, 1);
    ADD_FAILURE() << "the scan is still there";
  }
  catch (const LMS3D::ScanGone& problem)
  {
    EXPECT_GT(problem.oldest, first.number);
    EXPECT_GE(problem.newest, later.number);
    // More if a scan was made between the two calls.
    EXPECT_GE(problem.newest, problem.oldest + 3);
  }
  EXPECT_THROW(scanner->getMapPoints(later.number + 1000000, 0, 1), LMS3D::ScanGone);
  EXPECT_THROW(scanner->getMapTriangles(0, 0, 1), LMS3D::ScanGone);
}

TEST(ServerWaiting, AClientFollowsAServerThatRestarts)
{
  const std::string endpoint = "giop:tcp:127.0.0.1:" + std::to_string(FindFreePort());
  auto server = std::make_unique<ServerProcess>(Words{ "--endpoint", endpoint });
  const std::string corbaloc = server->GetCorbaloc();
  const LMS3D::LaserScanner_var scanner = Connect(corbaloc);
  const LMS3D::ScanHeader before = WaitFor(scanner);

  std::atomic<bool> isCut(false);
  std::thread waiting(
    [&]
    {
      try
      {
        scanner->waitForScan(Never, 0, 10000);
      }
      catch (const CORBA::SystemException&)
      {
        isCut = true;
      }
    });
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  server->Terminate(SIGKILL);
  waiting.join();
  EXPECT_TRUE(isCut);

  server.reset();
  const ServerProcess next({ "--endpoint", endpoint });
  ASSERT_EQ(next.GetCorbaloc(), corbaloc);
  const LMS3D::ScanHeader after = WaitFor(scanner);
  EXPECT_GT(after.incarnation, before.incarnation);
}
