// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the laws of the local map on random scans of 20 scenes with the errors of a device: lost
 * beams, stray returns, noise and steps. The environment variable LMS3D_DAMAGED_SCANS sets the
 * number of scans, LMS3D_DAMAGED_SCAN judges only the scan of one seed.
 */
#include "LocalMap/DamagedScans.h"

#include "LocalMap/MapFixtures.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

namespace
{
#ifdef LMS3D_FEWER_BEAMS
constexpr int NumberOfScans = 20;
#else
constexpr int NumberOfScans = 200;
#endif

// Seeds beyond this number whose maps broke laws in the past.
constexpr std::array<int, 3> SeedsOfOldBreaches = { 428, 823, 932 };

void JudgeScan(int seed)
{
  const DamagedScan scan(seed);
  SCOPED_TRACE(scan.Describe());
  const MapVerdict verdict = JudgeMap(scan.Damaged, scan.MakeMap(), scan.GetPromise());
  EXPECT_TRUE(verdict.IsLawful()) << verdict;
}

int GetNumber(const char* variable, int otherwise)
{
  const char* const number = std::getenv(variable);
  return number ? std::atoi(number) : otherwise;
}

class MapLawsOfDamagedScans : public testing::TestWithParam<int>
{
};
} // namespace

// Each test has one scene, and every 20th seed.
TEST_P(MapLawsOfDamagedScans, Hold)
{
  const int number = GetNumber("LMS3D_DAMAGED_SCANS", NumberOfScans);
  const int only = GetNumber("LMS3D_DAMAGED_SCAN", -1);
  for (int seed = GetParam(); seed < (only < 0 ? number : only + 1); seed += NumberOfDamagedScenes)
  {
    if (only < 0 || seed == only)
    {
      JudgeScan(seed);
    }
  }
}

TEST(MapLawsOfDamagedScan, HoldWhereTheyWereOnceBroken)
{
  for (int seed : SeedsOfOldBreaches)
  {
    JudgeScan(seed);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, MapLawsOfDamagedScans, testing::Range(0, NumberOfDamagedScenes));
