// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that lms3dRangeGrid is the same for returns in any order and for any number of threads,
 * and that it finds a bad return anywhere.
 */
#include "Fixtures/VectorFixtures.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"

#include <tbb/task_arena.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr int Beams = 129;
constexpr int Turns = 256;
/// As many as two tasks of a thread take, so that the second one begins in the middle.
constexpr int Count = 32768;
constexpr int Middle = Count / 2;

constexpr double Alpha[2] = { -90.0, 90.0 };
constexpr double Beta[2] = { 0.0, 360.0 };

/// Both ends of each fan are poles. All ranges differ.
struct Returns
{
  /// One beam in 131 has no return, in each turn another one.
  Returns()
  {
    for (int id = 0; static_cast<int>(this->BeamIds.size()) < Count; ++id)
    {
      if (id % (Beams + 2) != 17)
      {
        this->BeamIds.push_back(id);
        this->Ranges.push_back(2.0 + std::sin(id) + 1e-5 * id);
      }
    }
  }

  /// The same returns in another order.
  Returns Sort(const std::vector<std::size_t>& order) const
  {
    Returns sorted = *this;
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      sorted.Ranges[i] = this->Ranges[order[i]];
      sorted.BeamIds[i] = this->BeamIds[order[i]];
    }
    return sorted;
  }

  std::vector<double> Ranges;
  std::vector<int> BeamIds;
};

/// All that a grid holds, with returns by their beams.
struct Content
{
  std::vector<double> Ranges;
  std::vector<std::int32_t> Vertices;
  std::vector<std::int32_t> FirstVertices;
  std::vector<int> BeamsOfVertices;
  std::vector<std::vector<double>> RangesOfPoles;

  bool operator==(const Content& other) const
  {
    return this->Ranges == other.Ranges && this->Vertices == other.Vertices &&
      this->FirstVertices == other.FirstVertices &&
      this->BeamsOfVertices == other.BeamsOfVertices && this->RangesOfPoles == other.RangesOfPoles;
  }
};

/// The grid with its halo.
Content GetContent(const lms3dRangeGrid& grid, const Returns& returns)
{
  Content content;
  for (int turn = -2; turn < Turns + 3; ++turn)
  {
    content.Ranges.insert(
      content.Ranges.end(), grid.GetRanges(turn) - 2, grid.GetRanges(turn) + Beams + 2);
    content.Vertices.insert(
      content.Vertices.end(), grid.GetVertices(turn) - 2, grid.GetVertices(turn) + Beams + 2);
  }
  for (int turn = 0; turn <= Turns; ++turn)
  {
    content.FirstVertices.push_back(grid.GetFirstVertex(turn));
  }
  for (std::int32_t found : grid.GetReturns())
  {
    content.BeamsOfVertices.push_back(returns.BeamIds[found]);
  }
  content.RangesOfPoles = grid.GetRangesOfPoles();
  for (std::vector<double>& ofPole : content.RangesOfPoles)
  {
    std::sort(ofPole.begin(), ofPole.end());
  }
  return content;
}

/// Builds a grid on a number of threads.
class RangeGridBuilder
{
public:
  explicit RangeGridBuilder(int threads)
    : Threads(threads)
  {
  }

  Content Build(const Returns& returns)
  {
    tbb::task_arena(this->Threads)
      .execute(
        [&] {
          this->Grid.Build(this->Geometry, returns.Ranges.data(), returns.BeamIds.data(), Count);
        });
    return GetContent(this->Grid, returns);
  }

  /// The message of the error, or an empty one.
  std::string GetError(const Returns& returns)
  {
    try
    {
      this->Build(returns);
    }
    catch (const std::runtime_error& error)
    {
      return error.what();
    }
    return {};
  }

private:
  const int Threads;
  const lms3dScanGeometry Geometry{ Alpha, Beams, Beta, Turns };
  lms3dRangeGrid Grid;
};

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

/// All but the two returns in the middle are sorted.
std::vector<std::size_t> GetMiddleSwapped()
{
  std::vector<std::size_t> order = GetOrder();
  std::swap(order[Middle - 1], order[Middle]);
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
  const Content expected = RangeGridBuilder(1).Build(this->Sorted);
  ASSERT_EQ(std::count(expected.Ranges.begin(), expected.Ranges.end(), 0.0) > 0, true);
  ASSERT_EQ(expected.RangesOfPoles.size(), 2U);
  EXPECT_TRUE(this->Builder.Build(this->Sorted) == expected);
  for (const std::vector<std::size_t>& order :
    { GetRandomOrder(), GetHalvesSwapped(), GetMiddleSwapped() })
  {
    EXPECT_TRUE(this->Builder.Build(this->Sorted.Sort(order)) == expected);
    // Nothing is left of the other order.
    EXPECT_TRUE(this->Builder.Build(this->Sorted) == expected);
  }
}

TEST_P(RangeGrids, FindABadReturnAnywhere)
{
  for (int index : { 0, Middle - 1, Middle, Count - 1 })
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
