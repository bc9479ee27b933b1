// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks how the surface around decides pairs: how many open sides count, and where.
 */
#include "LocalMap/Grid/lms3dJoinResolver.h"
#include "LocalMap/Grid/lms3dRangeGrid.h"
#include "LocalMap/Grid/lms3dTurnJoins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace
{
/// Six turns of six beams. All beams returned.
class LooseJoins : public testing::Test
{
protected:
  static constexpr int Count = 6;
  static constexpr int Middle = 2;
  static constexpr int Last = Count - 1;
  inline static const std::vector<double> Angles = { -10.0, -8.0, -6.0, -4.0, -2.0, 0.0 };
  inline static const std::vector<double> FullCircle = { 0.0, 60.0, 120.0, 180.0, 240.0, 300.0 };

  /// Without poles and with a first and a last turn.
  LooseJoins()
    : LooseJoins(Angles, Angles)
  {
  }

  LooseJoins(const std::vector<double>& alphas, const std::vector<double>& betas)
    : Geometry(alphas, betas)
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

  /// Decides a pair and returns whether it is joined.
  bool Decide(const lms3dUncertainJoin& join)
  {
    lms3dJoinResolver(this->Grid, this->Joins).DecideLoose({ join });
    return (this->Joins.GetRow(join.Turn)[join.Beam] & join.Towards) != 0;
  }

  /// The same with the pair in the middle along the turn.
  bool Decide(lms3dDepthStep::Relation relation)
  {
    return this->Decide({ Middle, Middle, lms3dJoinedAlongTurn, relation });
  }

  const lms3dScanGeometry Geometry;
  lms3dRangeGrid Grid;
  lms3dPaddedGrid<std::uint8_t> Joins{ 0 };
};

/// After the last turn, the first one follows.
class LooseJoinsAtSeam : public LooseJoins
{
protected:
  LooseJoinsAtSeam()
    : LooseJoins(Angles, FullCircle)
  {
  }
};

/// The first beam is a pole.
class LooseJoinsAtPole : public LooseJoins
{
protected:
  LooseJoinsAtPole()
    : LooseJoins({ 90.0, 80.0, 70.0, 60.0, 50.0, 40.0 }, FullCircle)
  {
    for (int turn = 0; turn < Count; ++turn)
    {
      this->Open(turn, 0, lms3dJoinedAlongTurn);
    }
  }
};
} // namespace

TEST_F(LooseJoins, StayWhereAtMostTwoSidesAreOpen)
{
  this->Open(Middle, Middle - 1, lms3dJoinedAlongFan);
  this->Open(Middle, Middle, lms3dJoinedAlongFan);
  EXPECT_TRUE(this->Decide(lms3dDepthStep::Loose));
}

TEST_F(LooseJoins, ArePartedWhereThreeSidesAreOpen)
{
  this->Open(Middle, Middle - 1, lms3dJoinedAlongFan);
  this->Open(Middle, Middle, lms3dJoinedAlongFan);
  this->Open(Middle, Middle + 1, lms3dJoinedAlongTurn);
  EXPECT_FALSE(this->Decide(lms3dDepthStep::Loose));
}

TEST_F(LooseJoins, AreMadeWhereOneCellIsWhole)
{
  this->Open(Middle, Middle, lms3dJoinedAlongTurn);
  this->Open(Middle, Middle, lms3dJoinedAlongFan);
  this->Open(Middle + 1, Middle, lms3dJoinedAlongFan);
  EXPECT_TRUE(this->Decide(lms3dDepthStep::Gentle));
}

TEST_F(LooseJoins, AreNotMadeWhereBothCellsAreOpen)
{
  this->Open(Middle, Middle, lms3dJoinedAlongTurn);
  this->Open(Middle, Middle - 1, lms3dJoinedAlongTurn);
  this->Open(Middle, Middle, lms3dJoinedAlongFan);
  EXPECT_FALSE(this->Decide(lms3dDepthStep::Gentle));
}

// Other methods can join Gentle pairs.
TEST_F(LooseJoins, AreKeptIfTheyAreGentleAndJoined)
{
  this->Open(Middle, Middle - 1, lms3dJoinedAlongFan);
  this->Open(Middle, Middle, lms3dJoinedAlongFan);
  this->Open(Middle, Middle + 1, lms3dJoinedAlongTurn);
  EXPECT_TRUE(this->Decide(lms3dDepthStep::Gentle));
}

TEST_F(LooseJoins, AreNoPairsThatAreJoinedAlready)
{
  const std::vector<double> ripples = { 0.0, 0.0, 34.0, 32.0, 33.0, 33.5, 32.5, 34.0, 0.0, 0.0 };
  const lms3dDepthStep step(0.1, 2.0);
  for (bool areJoined : { false, true })
  {
    std::vector<std::uint8_t> flags(Count, 0);
    std::vector<lms3dUncertainJoin> uncertain, creases, loose;
    lms3dTurnJoins found = { 0, flags.data(), uncertain, creases, loose };
    if (areJoined)
    {
      found.JoinEqualRanges(this->Grid, ripples.data() + 2, step);
    }
    found.ClassifyFan(this->Grid, ripples.data() + 2, step);
    EXPECT_EQ(loose.empty(), areJoined);
    EXPECT_EQ(flags[Middle], lms3dJoinedAlongFan);
  }
}

// The cell beyond the edge of the scan does not count.
TEST_F(LooseJoins, StayAtTheEdgeOfTheScan)
{
  EXPECT_TRUE(this->Decide({ 0, Middle, lms3dJoinedAlongFan, lms3dDepthStep::Loose }));
  EXPECT_TRUE(this->Decide({ Last, Middle, lms3dJoinedAlongFan, lms3dDepthStep::Loose }));
  EXPECT_TRUE(this->Decide({ Middle, 0, lms3dJoinedAlongTurn, lms3dDepthStep::Loose }));
  EXPECT_TRUE(this->Decide({ Middle, Last, lms3dJoinedAlongTurn, lms3dDepthStep::Loose }));
  this->Open(Middle, 0, lms3dJoinedAlongFan);
  this->Open(Middle + 1, 0, lms3dJoinedAlongFan);
  EXPECT_TRUE(this->Decide({ Middle, 0, lms3dJoinedAlongTurn, lms3dDepthStep::Loose }));
  this->Open(Middle, 1, lms3dJoinedAlongTurn);
  EXPECT_FALSE(this->Decide({ Middle, 0, lms3dJoinedAlongTurn, lms3dDepthStep::Loose }));
}

TEST_F(LooseJoins, AreNotMadeAtTheEdgeOfTheScan)
{
  this->Open(Middle, 0, lms3dJoinedAlongTurn);
  EXPECT_FALSE(this->Decide({ Middle, 0, lms3dJoinedAlongTurn, lms3dDepthStep::Gentle }));
  this->Open(0, Middle, lms3dJoinedAlongFan);
  EXPECT_FALSE(this->Decide({ 0, Middle, lms3dJoinedAlongFan, lms3dDepthStep::Gentle }));
}

TEST_F(LooseJoinsAtSeam, CountTheSidesBeyond)
{
  const lms3dUncertainJoin first = { 0, Middle, lms3dJoinedAlongFan, lms3dDepthStep::Loose };
  this->Open(Last, Middle, lms3dJoinedAlongTurn);
  this->Open(Last, Middle + 1, lms3dJoinedAlongTurn);
  EXPECT_TRUE(this->Decide(first));
  this->Open(Last, Middle, lms3dJoinedAlongFan);
  EXPECT_FALSE(this->Decide(first));
}

TEST_F(LooseJoinsAtSeam, CountTheSidesOfTheFirstTurn)
{
  const lms3dUncertainJoin across = { Last, Middle, lms3dJoinedAlongTurn, lms3dDepthStep::Loose };
  this->Open(0, Middle - 1, lms3dJoinedAlongFan);
  this->Open(0, Middle, lms3dJoinedAlongFan);
  EXPECT_TRUE(this->Decide(across));
  this->Open(Last, Middle, lms3dJoinedAlongFan);
  EXPECT_FALSE(this->Decide(across));
}

// The entries of the pole are one vertex.
TEST_F(LooseJoinsAtPole, CountThePoleAsJoined)
{
  const lms3dUncertainJoin atPole = { Middle, 0, lms3dJoinedAlongFan, lms3dDepthStep::Loose };
  this->Open(Middle, 1, lms3dJoinedAlongTurn);
  this->Open(Middle + 1, 0, lms3dJoinedAlongFan);
  EXPECT_TRUE(this->Decide(atPole));
  this->Open(Middle - 1, 1, lms3dJoinedAlongTurn);
  EXPECT_FALSE(this->Decide(atPole));
}
