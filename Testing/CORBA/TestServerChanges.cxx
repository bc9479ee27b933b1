// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// When a server scans with new settings, and what remains of the old ones.
#include "ClientORB.h"
#include "Sanitizers.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace
{
// At this rate no scan is due during a test.
const std::vector<std::string> NoMoreScans = { "--rate", "0.01" };

LMS3D::Configuration GetLargeGrid(CORBA::ULong count)
{
  LMS3D::Configuration configuration = GetCoarseGrid();
  configuration.alpha = { -90.0, 90.0, count };
  configuration.beta = { 0.0, 360.0, count };
  configuration.mapError = 0.0;
  return configuration;
}

/// Sets a pose every few milliseconds until this object is destroyed.
class PoseChanger
{
public:
  explicit PoseChanger(LMS3D::LaserScanner_ptr scanner)
    : Thread([this, scanner] { this->Run(scanner); })
  {
  }
  ~PoseChanger()
  {
    this->IsOver = true;
    this->Thread.join();
  }
  PoseChanger(const PoseChanger&) = delete;
  void operator=(const PoseChanger&) = delete;

private:
  void Run(LMS3D::LaserScanner_ptr scanner)
  {
    try
    {
      while (!this->IsOver)
      {
        scanner->setPose(At(0.3, -0.2, 1.0));
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      }
    }
    catch (const CORBA::Exception& problem)
    {
      ADD_FAILURE() << problem._name();
    }
  }

  std::atomic<bool> IsOver{ false };
  std::thread Thread;
};

/// Each of the scans has its own time limit.
void WaitForSixMore(LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong number)
{
  const CORBA::ULongLong last = number + 6;
  while (number < last && !testing::Test::HasFailure())
  {
    number = WaitFor(scanner, 0, number).number;
  }
}
} // namespace

TEST(ServerChanges, ANewPoseIsScannedAtOnce)
{
  ServerProcess server(NoMoreScans);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  ASSERT_EQ(WaitFor(scanner).number, 1u);
  for (CORBA::ULongLong number = 2; number < 5; ++number)
  {
    const double x = 0.1 * static_cast<double>(number);
    const LMS3D::ScanHeader header = WaitFor(scanner, scanner->setPose(At(x, 0.0, 1.0)));
    EXPECT_EQ(header.sensorPose.position.x, x);
    EXPECT_EQ(header.number, number);
  }
  const LMS3D::Status_var status = scanner->getStatus();
  EXPECT_EQ(status->lateScans, 0u);
}

TEST(ServerChanges, TheNextScanIsDueOnePeriodAfterANewPose)
{
  ServerProcess server({ "--rate", "0.5" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  WaitFor(scanner);
  const LMS3D::ScanHeader moved = WaitFor(scanner, scanner->setPose(At(0.5, 0.0, 1.0)));
  const LMS3D::ScanHeader next = WaitFor(scanner, 0, moved.number);
  constexpr double Period = 2.0;
  EXPECT_NEAR(static_cast<double>(next.startTime - moved.startTime) * 1e-9, Period, 0.5);
}

// The scan of the large grid would have the number 2. It takes several times as long as the pause.
TEST(ServerChanges, NewSettingsAbortALongScan)
{
  ServerProcess server(NoMoreScans);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  ASSERT_EQ(WaitFor(scanner).number, 1u);
  for (CORBA::ULongLong number = 2; number < 4; ++number)
  {
    scanner->setConfiguration(GetLargeGrid(2000));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const LMS3D::ScanHeader header = WaitFor(scanner, scanner->setConfiguration(GetCoarseGrid()));
    EXPECT_EQ(header.number, number);
    EXPECT_EQ(header.beams, 13u * 36u);
    EXPECT_EQ(header.returns, 13u * 36u);
    EXPECT_GT(header.mapTriangles, 0u);
  }
  const LMS3D::Status_var status = scanner->getStatus();
  EXPECT_STREQ(status->problem, "");
}

// Each scan takes longer than the time after which it may be aborted.
TEST(ServerChanges, SettingsThatChangeAllTheTimeStillGiveScans)
{
  ServerProcess server(NoMoreScans);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const CORBA::ULong count = IsSanitized ? 600 : 1200;
  const CORBA::ULongLong generation = scanner->setConfiguration(GetLargeGrid(count));
  const PoseChanger other(scanner);
  LMS3D::ScanHeader header = WaitFor(scanner, generation);
  for (int i = 0; i < 2; ++i)
  {
    header = WaitFor(scanner, header.generation + 1);
  }
  EXPECT_EQ(header.beams, count * count);
}

TEST(ServerChanges, TheMemoryOfLargeScansIsReturned)
{
  if (IsSanitized)
  {
    GTEST_SKIP() << "sanitizers keep freed memory";
  }
  constexpr long Megabyte = 1 << 20;
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  WaitFor(scanner);
  const long before = server.GetResidentMemory();
  for (const bool makeMap : { true, false, true })
  {
    const LMS3D::ScanHeader large = WaitFor(scanner, scanner->setConfiguration(GetLargeGrid(1200)));
    // The server keeps four scans.
    WaitForSixMore(scanner, large.number);
    ASSERT_GT(server.GetResidentMemory(), before + 200 * Megabyte);
    LMS3D::Configuration configuration = GetCoarseGrid();
    configuration.makeMap = makeMap;
    const LMS3D::ScanHeader small = WaitFor(scanner, scanner->setConfiguration(configuration));
    WaitForSixMore(scanner, small.number);
    EXPECT_LT(server.GetResidentMemory(), before + 50 * Megabyte) << makeMap;
  }
}
