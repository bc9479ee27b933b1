// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks pairs that the surface around decides: which these are, and how many open sides count.
 */
#include "LocalMap/Grid/lms3dJoinResolver.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"

#include <vtkMath.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace
{
constexpr double DepthStep = 0.1;

/// The relation of the two middle ones of six ranges along a turn at elevation 0, metres.
lms3dDepthStep::Relation Classify(
  const std::vector<double>& six, double step, double depthStep = DepthStep)
{
  const double* const at = six.data() + 2;
  return lms3dDepthStep(depthStep, step)
    .Classify(lms3dDepthStep::GetSideBefore(at), lms3dDepthStep::GetSideBehind(at));
}

/// Six turns of six beams, without poles. All beams returned.
class LooseJoins : public testing::Test
{
protected:
  static constexpr int Count = 6;
  static constexpr int Middle = 2;

  LooseJoins()
    : Geometry(Angles, Angles)
  {
    const std::vector<double> ranges(Count * Count, 1.0);
    std::vector<int> beams(ranges.size());
    std::iota(beams.begin(), beams.end(), 0);
    this->Grid.Build(this->Geometry, ranges.data(), beams.data(), Count * Count);
    this->Joins.SetShape(Count, Count);
    for (int turn = 0; turn < Count; ++turn)
    {
      std::fill_n(this->Joins.GetRow(turn), Count, lms3dJoinedAlongFan | lms3dJoinedAlongTurn);
    }
  }

  void Open(int turn, int beam, lms3dJoinFlag side)
  {
    this->Joins.GetRow(turn)[beam] &= static_cast<std::uint8_t>(~side);
  }

  /// Decides the pair in the middle along the turn and returns whether it is joined.
  bool Decide()
  {
    lms3dJoinResolver(this->Grid, this->Joins)
      .DecideLoose({ { Middle, Middle, lms3dJoinedAlongTurn, false } });
    return (this->Joins.GetRow(Middle)[Middle] & lms3dJoinedAlongTurn) != 0;
  }

  const std::vector<double> Angles = { -10.0, -8.0, -6.0, -4.0, -2.0, 0.0 };
  const lms3dScanGeometry Geometry;
  lms3dRangeGrid Grid;
  lms3dPaddedGrid<std::uint8_t> Joins{ 0 };
};
} // namespace

// Ripples at 33 m, where neighbours are 1.15 m apart. Half a metre can be a slope or a step.
TEST_F(LooseJoins, AreFarFromBothPlanes)
{
  const std::vector<double> ripples = { 34.0, 32.0, 33.0, 33.5, 32.5, 34.0 };
  EXPECT_EQ(Classify(ripples, 2.0), lms3dDepthStep::Loose);
  // Each plane meets the other return.
  EXPECT_EQ(Classify({ 32.0, 32.5, 33.0, 33.5, 34.0, 34.5 }, 2.0), lms3dDepthStep::Joined);
  // No larger than two depth steps.
  EXPECT_EQ(Classify({ 34.0, 32.0, 33.0, 33.19, 32.0, 34.0 }, 2.0), lms3dDepthStep::Joined);
  // Nearer, the tolerance is small.
  std::vector<double> near = ripples;
  std::transform(near.begin(), near.end(), near.begin(), [](double range) { return 0.4 * range; });
  EXPECT_EQ(Classify(near, 2.0), lms3dDepthStep::Joined);
}

// One plane ends in front of the other, at a slope that hills have.
TEST_F(LooseJoins, AreGentleBetweenPlanesThatDoNotIntersect)
{
  EXPECT_EQ(Classify({ 30.0, 30.0, 30.0, 31.0, 31.0, 31.0 }, 2.0), lms3dDepthStep::Gentle);
  EXPECT_EQ(Classify({ 30.0, 30.0, 30.0, 32.0, 32.0, 32.0 }, 2.0), lms3dDepthStep::Separate);
  // Coarse scans show less.
  EXPECT_EQ(Classify({ 30.0, 30.0, 30.0, 32.0, 32.0, 32.0 }, 4.0), lms3dDepthStep::Separate);
  // The user wants to see far smaller steps.
  EXPECT_EQ(Classify({ 30.0, 30.0, 30.0, 31.0, 31.0, 31.0 }, 2.0, 0.02), lms3dDepthStep::Separate);
}

// Up to a tolerance of six depth steps: in a room, the front of a shelf ends before the wall.
TEST_F(LooseJoins, AreNotGentleWhereBeamsAreNear)
{
  EXPECT_EQ(Classify({ 14.0, 14.0, 14.0, 14.45, 14.45, 14.45 }, 2.0), lms3dDepthStep::Separate);
  EXPECT_EQ(Classify({ 14.5, 14.5, 14.5, 14.95, 14.95, 14.95 }, 2.0), lms3dDepthStep::Gentle);
}

// A wall that begins to bend: with a depth step of 0, gaps below a millimetre do not count.
TEST_F(LooseJoins, AreNotMadeByRounding)
{
  const auto classify = [](double bend)
  {
    std::vector<double> wall;
    for (int i = 0; i < Count; ++i)
    {
      const double past = std::max(0, i - Middle);
      wall.push_back(3.0 / std::cos(vtkMath::RadiansFromDegrees(2.0 * i)) + bend * past * past);
    }
    return Classify(wall, 2.0, 0.0);
  };
  EXPECT_EQ(classify(0.0), lms3dDepthStep::Joined);
  EXPECT_EQ(classify(0.0002), lms3dDepthStep::Joined);
  EXPECT_EQ(classify(0.004), lms3dDepthStep::Loose);
}

TEST_F(LooseJoins, StayWhereAtMostTwoSidesAreOpen)
{
  this->Open(Middle, Middle - 1, lms3dJoinedAlongFan);
  this->Open(Middle, Middle, lms3dJoinedAlongFan);
  EXPECT_TRUE(this->Decide());
}

TEST_F(LooseJoins, ArePartedWhereThreeSidesAreOpen)
{
  this->Open(Middle, Middle - 1, lms3dJoinedAlongFan);
  this->Open(Middle, Middle, lms3dJoinedAlongFan);
  this->Open(Middle, Middle + 1, lms3dJoinedAlongTurn);
  EXPECT_FALSE(this->Decide());
}

TEST_F(LooseJoins, AreMadeWhereOneCellIsWhole)
{
  this->Open(Middle, Middle, lms3dJoinedAlongTurn);
  this->Open(Middle, Middle, lms3dJoinedAlongFan);
  this->Open(Middle + 1, Middle, lms3dJoinedAlongFan);
  EXPECT_TRUE(this->Decide());
}

TEST_F(LooseJoins, AreNotMadeWhereBothCellsAreOpen)
{
  this->Open(Middle, Middle, lms3dJoinedAlongTurn);
  this->Open(Middle, Middle - 1, lms3dJoinedAlongTurn);
  this->Open(Middle, Middle, lms3dJoinedAlongFan);
  EXPECT_FALSE(this->Decide());
}
