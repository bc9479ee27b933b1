// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The point array Time of vtkLMS3DScanFilter.
 */
#include "Scan/DeviceFixtures.h"
#include "Scan/TrajectoryFixtures.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{
vtkSmartPointer<vtkLMS3DScanFilter> MakeTimedScan(double first, double last, int beams, int turns)
{
  auto scan = MakeScan(MakeBall(5.0));
  scan->SetAlphaRange(first, last);
  SetGrid(scan, beams, turns);
  scan->ComputeTimeOn();
  return scan;
}
} // namespace

TEST(LMS3DScanTime, IsNotThereByDefault)
{
  auto scan = MakeScan(MakeBall(5.0));
  SetGrid(scan, 9, 8);
  scan->Update();
  EXPECT_EQ(GetArray(scan, "Time"), nullptr);
}

TEST(LMS3DScanTime, OfOneMirrorTurnLastsHalfATurn)
{
  auto scan = MakeTimedScan(-90.0, 90.0, 181, 3);
  scan->Update();
  const std::vector<double> times = GetValues(scan, "Time");
  ASSERT_EQ(times.size(), 543u);
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    EXPECT_GT(times[i], times[i - 1]);
  }
  for (int turn = 0; turn < 3; ++turn)
  {
    EXPECT_NEAR(times[181 * turn], turn / 75.0, 1e-15);
    EXPECT_NEAR(times[181 * turn + 180] - times[181 * turn], 0.5 / 75.0, 1e-15);
  }
}

TEST(LMS3DScanTime, InterlacesFinerSteps)
{
  for (int n : { 2, 4 })
  {
    const int beams = 100 * n + 1;
    auto scan = MakeTimedScan(-50.0, 50.0, beams, 2);
    scan->Update();
    const std::vector<double> times = GetValues(scan, "Time");
    ASSERT_EQ(times.size(), 2u * beams);
    for (int i = 0; i < 2 * beams; ++i)
    {
      const int beam = i % beams;
      const int fan = i / beams;
      const int wholeDegrees = beam / n;
      EXPECT_NEAR(times[i], fan * n / 75.0 + beam % n / 75.0 + wholeDegrees / 27000.0, 1e-15);
    }
  }
}

TEST(LMS3DScanTime, StartsWithThePoseOfTheTrajectory)
{
  auto poses = MakePoses(ThreePositions);
  AddArray(poses, "Time", 1, { 10, 11, 15 });
  auto scan = MakeScanAlong(poses);
  scan->ComputeTimeOn();
  scan->UpdateTimeStep(11.0);
  EXPECT_EQ(GetArray(scan, "Time")->GetTuple1(0), 11.0);
}

TEST(LMS3DScanTime, BelongsToReturnsAlone)
{
  auto scan = MakeScan(MakeFloor(1.0, -1.0));
  SetGrid(scan, 181, 12);
  scan->ComputeTimeOn();
  scan->Update();
  const std::vector<double> times = GetValues(scan, "Time");
  const std::vector<double> ids = GetValues(scan, "BeamId");
  ASSERT_EQ(times.size(), ids.size());
  ASSERT_LT(ids.size(), 181u * 12u);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const int id = static_cast<int>(ids[i]);
    const int turn = id / 181;
    EXPECT_NEAR(times[i], turn / 75.0 + id % 181 / 27000.0, 1e-15);
  }
}
