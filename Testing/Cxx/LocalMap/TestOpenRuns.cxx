// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the runs of entries at which a flood goes on, against a search entry by entry.
 */
#include "LocalMap/Patches/lms3dOpenRuns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace
{
using Runs = std::vector<std::pair<int, int>>;

Runs FindOneByOne(const std::vector<std::int32_t>& isOpen, const std::vector<std::uint8_t>& joins)
{
  Runs runs;
  for (int i = 0; i < static_cast<int>(isOpen.size()); ++i)
  {
    const bool goesOn =
      i > 0 && isOpen[i - 1] != 0 && (joins[i - 1] & lms3dBeamSphere::JoinedUp) != 0;
    if (isOpen[i] != 0 && goesOn)
    {
      runs.back().second = i;
    }
    else if (isOpen[i] != 0)
    {
      runs.emplace_back(i, i);
    }
  }
  return runs;
}

Runs Find(const std::vector<std::int32_t>& isOpen, const std::vector<std::uint8_t>& joins,
  lms3dOpenRuns& openRuns)
{
  std::copy(isOpen.begin(), isOpen.end(), openRuns.GetOpen());
  Runs runs;
  openRuns.ForEach(joins.data(), static_cast<int>(isOpen.size()),
    [&](int first, int last) { runs.emplace_back(first, last); });
  return runs;
}
} // namespace

TEST(OpenRuns, AreThoseOfASearchOneByOne)
{
  constexpr int Rows = 361;
  std::mt19937 random(5);
  // Reused, so that entries of longer columns remain.
  lms3dOpenRuns openRuns(Rows);
  for (const int count : { Rows, 200, 65, 64, 17, 8, 7, 2, 1 })
  {
    for (const double share : { 0.0, 0.05, 0.5, 0.95, 1.0 })
    {
      std::bernoulli_distribution isSet(share);
      std::vector<std::int32_t> isOpen(count);
      std::vector<std::uint8_t> joins(count);
      for (int i = 0; i < count; ++i)
      {
        isOpen[i] = isSet(random) ? 1 : 0;
        joins[i] = static_cast<std::uint8_t>((isSet(random) ? lms3dBeamSphere::JoinedUp : 0) |
          (isSet(random) ? lms3dBeamSphere::JoinedRight : 0));
      }
      EXPECT_EQ(Find(isOpen, joins, openRuns), FindOneByOne(isOpen, joins))
        << count << ' ' << share;
    }
  }
}

TEST(OpenRuns, PartWhereEntriesAreNotJoined)
{
  lms3dOpenRuns openRuns(6);
  const std::vector<std::uint8_t> joins = { 1, 2, 3, 0, 1, 1 };
  EXPECT_EQ(Find({ 1, 1, 1, 1, 1, 1 }, joins, openRuns), Runs({ { 0, 1 }, { 2, 3 }, { 4, 5 } }));
}
