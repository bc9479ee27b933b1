// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Object/lms3dScannerServant.h"
#include "Object/lms3dSettingsCheck.h"
#include "Scanning/lms3dSettingsBoard.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <thread>
#include <vector>

namespace
{
lms3dScanSettings GetSettings()
{
  lms3dScanSettings settings;
  settings.Configuration = lms3dDefaultConfiguration();
  settings.Pose.position = { 0.0, 0.0, 0.0 };
  settings.Pose.orientation = { 0.0, 0.0, 0.0 };
  settings.Scene = std::make_shared<lms3dServedScene>();
  return settings;
}

LMS3D::Pose At(double value)
{
  LMS3D::Pose pose;
  pose.position = { value, value, value };
  pose.orientation = { value, value, value };
  return pose;
}

bool IsWhole(const LMS3D::Pose& pose)
{
  const double value = pose.position.x;
  return pose.position.y == value && pose.position.z == value && pose.orientation.x == value &&
    pose.orientation.y == value && pose.orientation.z == value;
}
} // namespace

TEST(SettingsBoard, EachChangeIsAGeneration)
{
  lms3dSettingsBoard board(GetSettings());
  EXPECT_EQ(board.Get().Generation, 1u);
  EXPECT_EQ(board.SetPose(At(3.0)), 2u);
  EXPECT_EQ(board.SetConfiguration(lms3dDefaultConfiguration()), 3u);
  EXPECT_EQ(board.SetScene(std::make_shared<lms3dServedScene>()), 4u);
  LMS3D::Device device = lms3dGetIdealDevice();
  device.rangeNoise = 0.5;
  LMS3D::Configuration configuration = lms3dDefaultConfiguration();
  configuration.maximumRange = 8.0;
  EXPECT_EQ(board.SetDevice(device, configuration), 5u);
  EXPECT_EQ(board.Get().Generation, 5u);
  EXPECT_EQ(board.Get().Pose.position.y, 3.0);
  EXPECT_EQ(board.Get().Device.rangeNoise, 0.5);
  EXPECT_EQ(board.Get().Configuration.maximumRange, 8.0);
}

TEST(SettingsBoard, ManyWritersAndAReader)
{
  lms3dSettingsBoard board(GetSettings());
  std::vector<std::vector<std::uint64_t>> generations(4);
  std::vector<std::thread> writers;
  writers.reserve(generations.size());
  for (std::vector<std::uint64_t>& own : generations)
  {
    writers.emplace_back(
      [&board, &own]
      {
        for (int i = 0; i < 500; ++i)
        {
          own.push_back(board.SetPose(At(i)));
        }
      });
  }
  int torn = 0;
  for (int i = 0; i < 2000; ++i)
  {
    torn += IsWhole(board.Get().Pose) ? 0 : 1;
  }
  std::set<std::uint64_t> all;
  for (std::size_t i = 0; i < writers.size(); ++i)
  {
    writers[i].join();
    all.insert(generations[i].begin(), generations[i].end());
  }
  EXPECT_EQ(torn, 0);
  EXPECT_EQ(all.size(), 2000u);
  EXPECT_EQ(board.Get().Generation, 2001u);
}

TEST(SettingsBoard, AChangeOrTheEndWakesTheScanner)
{
  using Clock = lms3dSettingsBoard::Clock;
  lms3dSettingsBoard board(GetSettings());
  const Clock::time_point start = Clock::now();
  const Clock::time_point never = start + std::chrono::hours(1);
  board.WaitForChange(0, never);
  board.WaitForChange(1, start + std::chrono::milliseconds(20));
  EXPECT_GE(Clock::now(), start + std::chrono::milliseconds(20));
  std::thread changer([&board] { board.SetPose(At(1.0)); });
  board.WaitForChange(1, never);
  EXPECT_EQ(board.GetGeneration(), 2u);
  changer.join();
  std::thread stopper([&board] { board.Stop(); });
  board.WaitForChange(2, never);
  stopper.join();
  EXPECT_EQ(board.GetGeneration(), 2u);
}

// The results of calls between a server's start and its first scan.
TEST(ScannerServant, BeforeTheFirstScan)
{
  const lms3dSceneCatalogue catalogue(LMS3D_DATA_DIR);
  lms3dSettingsBoard board(GetSettings());
  lms3dSnapshotStore store(4);
  const lms3dFusedMapStore fusedMap(4);
  const lms3dScanLoop loop(board, store, 10.0, 1);
  lms3dListeners listeners(store);
  const PortableServer::Servant_var<lms3dScannerServant> servant =
    new lms3dScannerServant({}, catalogue, board, store, fusedMap, loop, listeners);

  EXPECT_THROW(servant->getHeader(), LMS3D::NoScanYet);
  EXPECT_THROW(servant->getScan(), LMS3D::NoScanYet);
  EXPECT_THROW(servant->getMap(), LMS3D::NoScanYet);
  EXPECT_THROW(servant->waitForScan(0, 0, 10), LMS3D::NoScanYet);
  EXPECT_THROW(servant->getRanges(1, 0, 1), LMS3D::ScanGone);
  EXPECT_THROW(servant->getScanDevice(1), LMS3D::ScanGone);
  EXPECT_THROW(servant->getBeamStatuses(1, 0, 1), LMS3D::ScanGone);
  const LMS3D::Status_var status = servant->getStatus();
  EXPECT_EQ(status->newest, 0u);

  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(servant->fetch(), CORBA::TRANSIENT);
  EXPECT_GE(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(4900));
  store.Stop();
  EXPECT_THROW(servant->waitForScan(0, 0, 10000), CORBA::TRANSIENT);
}
