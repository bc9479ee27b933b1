// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that lms3dRangeGrid is the same for returns in any order and for any number of threads,
 * and that it finds a bad return anywhere.
 */
#include "Fixtures/VectorFixtures.h"
#include "LocalMap/RangeGridFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr int Beams = Returns::Beams;
constexpr int Turns = Returns::Turns;
constexpr int Count = Returns::Count;
constexpr int Quarter = Count / 4;
constexpr int Middle = Count / 2;

std::vector<std::size_t> GetOrder()
{
  std::vector<std::size_t> order(Count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

std::vector<std::size_t> GetRandomOrder()
{
  std::vector<std::size_t> order = GetOrder();
  Random random(4);
  for (std::size_t i = order.size(); i > 1; --i)
  {
    std::swap(order[i - 1], order[static_cast<std::size_t>(random.Get() * static_cast<double>(i))]);
  }
  return order;
}

/// Each half is sorted.
std::vector<std::size_t> GetHalvesSwapped()
{
  std::vector<std::size_t> order = GetOrder();
  std::rotate(order.begin(), order.begin() + Middle, order.end());
  return order;
}

/// All but a return and the one before are sorted.
std::vector<std::size_t> GetPairSwapped(int index)
{
  std::vector<std::size_t> order = GetOrder();
  std::swap(order[index - 1], order[index]);
  return order;
}

class RangeGrids : public testing::TestWithParam<int>
{
protected:
  RangeGridBuilder Builder{ GetParam() };
  const Returns Sorted;
};
} // namespace

TEST_P(RangeGrids, AreTheSameForReturnsInAnyOrder)
{
  const GridContent expected = RangeGridBuilder(1).Build(this->Sorted);
  ASSERT_EQ(std::count(expected.Ranges.begin(), expected.Ranges.end(), 0.0) > 0, true);
  ASSERT_EQ(expected.RangesOfPoles.size(), 2U);
  EXPECT_TRUE(this->Builder.Build(this->Sorted) == expected);
  for (const std::vector<std::size_t>& order :
    { GetRandomOrder(), GetHalvesSwapped(), GetPairSwapped(1), GetPairSwapped(Quarter),
      GetPairSwapped(Middle), GetPairSwapped(Middle + 1), GetPairSwapped(Count - 1) })
  {
    EXPECT_TRUE(this->Builder.Build(this->Sorted.Sort(order)) == expected);
    // Nothing is left of the other order.
    EXPECT_TRUE(this->Builder.Build(this->Sorted) == expected);
  }
}

// Returns in falling order take another way through the grid than sorted ones.
TEST_P(RangeGrids, KeepNothingOfTheScanBefore)
{
  for (int count : { 0, 1, Quarter, Middle, Middle + 1 })
  {
    const Returns first = this->Sorted.GetFirst(count);
    this->Builder.Build(this->Sorted);
    EXPECT_TRUE(this->Builder.Build(first) == RangeGridBuilder(1).Build(first.Reverse())) << count;
  }
  for (int part : { 0, Quarter, Middle, Middle + Quarter, Count })
  {
    for (int index = std::max(part - 2, 0); index < std::min(part + 2, Count); ++index)
    {
      const Returns others = this->Sorted.LeaveOut(index);
      this->Builder.Build(this->Sorted);
      EXPECT_TRUE(this->Builder.Build(others) == RangeGridBuilder(1).Build(others.Reverse()))
        << index;
    }
  }
}

TEST_P(RangeGrids, FindABadReturnAnywhere)
{
  for (int index : { 0, 1, Quarter - 1, Quarter, Middle - 1, Middle, Count - 1 })
  {
    const auto expectError = [&](const std::string& words, double range, int beam)
    {
      Returns returns = this->Sorted;
      returns.Ranges[index] = range;
      returns.BeamIds[index] = beam;
      const std::string error = this->Builder.GetError(returns);
      EXPECT_NE(error.find("Return " + std::to_string(index)), std::string::npos) << error;
      EXPECT_NE(error.find(words), std::string::npos) << error;
    };
    const int beam = this->Sorted.BeamIds[index];
    expectError("the Range nan", std::nan(""), beam);
    expectError("the Range 0.0", 0.0, beam);
    expectError("the Range inf", std::numeric_limits<double>::infinity(), beam);
    expectError("the BeamId -1", 1.0, -1);
    expectError("the BeamId " + std::to_string(Beams * Turns), 1.0, Beams * Turns);
    if (index > 0)
    {
      const int before = this->Sorted.BeamIds[index - 1];
      expectError("the BeamId " + std::to_string(before) + " of an earlier", 1.0, before);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, RangeGrids, testing::Values(1, 2));
