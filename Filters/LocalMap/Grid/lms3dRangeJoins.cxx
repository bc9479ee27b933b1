// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dRangeJoins.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <vector>

namespace
{
/// Finds how planes lean, for lms3dDepthStep.
class TiltFinder
{
public:
  TiltFinder(const lms3dScanGeometry& geometry, const lms3dDepthStep& fanStep)
    : FanStep(fanStep)
  {
    double sine, cosine;
    lms3dSinCosDegrees(geometry.GetBetaStep(), sine, cosine);
    for (int beam = 0; beam < geometry.GetNumberOfBeams(); ++beam)
    {
      this->Factors.push_back(GetFactors(geometry, beam, 2.0 * (1.0 - cosine)));
    }
  }

  /// Of the plane through a return of a turn, that beside it, and that of the turn before or after.
  /// 0, as for an upright plane, where there is none beside it on its surface.
  double Find(const double* ranges, int beam) const
  {
    const auto& [neighbor, ofRange, ofNeighbor] = this->Factors[beam];
    const double* first = ranges + std::min(beam, neighbor);
    return neighbor != NoNeighbor && this->FanStep.Classify(first) == lms3dDepthStep::Joined
      ? ofRange / ranges[beam] + ofNeighbor / ranges[neighbor]
      : 0.0;
  }

private:
  static constexpr int NoNeighbor = -1;

  struct Weights
  {
    int Neighbor;
    double OfRange;
    double OfNeighbor;
  };

  // The neighbour towards the horizon: where that is on another wall of a convex room, the plane
  // through it goes on behind the true one, so the room stays closed. With the angle s to it,
  // h = sin(e) w + cos(e) (w' - cos(s) w) / sin(s).
  static Weights GetFactors(const lms3dScanGeometry& geometry, int beam, double scale)
  {
    const double sine = geometry.GetAlphaSine(beam);
    const double cosine = geometry.GetAlphaCosine(beam);
    const int neighbor = beam + (sine * geometry.GetAlphaStep() > 0.0 ? -1 : 1);
    if (neighbor < 0 || neighbor >= geometry.GetNumberOfBeams())
    {
      return { NoNeighbor, 0.0, 0.0 };
    }
    const double otherSine = geometry.GetAlphaSine(neighbor);
    const double otherCosine = geometry.GetAlphaCosine(neighbor);
    const double sineOfStep = otherSine * cosine - otherCosine * sine;
    const double cosineOfStep = otherCosine * cosine + otherSine * sine;
    return { neighbor, scale * sine * (sine - cosine * cosineOfStep / sineOfStep),
      scale * sine * cosine / sineOfStep };
  }

  const lms3dDepthStep& FanStep;
  std::vector<Weights> Factors;
};

// Judges the neighbours along turns.
class TurnClassifier
{
public:
  TurnClassifier(
    const lms3dRangeGrid& grid, int turn, const lms3dDepthStep& step, const TiltFinder& tilts)
    : Step(step)
    , Tilts(tilts)
  {
    for (int i = 0; i < NumberOfRows; ++i)
    {
      this->Rows[i] = grid.GetRanges(turn - 2 + i);
    }
  }

  lms3dDepthStep::Relation Classify(int beam) const
  {
    // Most neighbours are equal.
    if (this->Step.AreRangesEqual(this->Rows[2][beam], this->Rows[3][beam]))
    {
      return lms3dDepthStep::Joined;
    }
    const auto [earlier, before, a, b, after, later] = this->GetRanges(beam);
    if (!(a > 0.0 && b > 0.0))
    {
      return lms3dDepthStep::Separate;
    }
    const double tiltOfA = this->Tilts.Find(this->Rows[2], beam);
    const double tiltOfB = this->Tilts.Find(this->Rows[3], beam);
    if (this->Step.AreCoplanar(before, a, b, after, tiltOfA, tiltOfB))
    {
      return lms3dDepthStep::Joined;
    }
    if (!this->Step.DoPlanesIntersect(before, a, b, after, tiltOfA, tiltOfB))
    {
      return lms3dDepthStep::Separate;
    }
    const bool isStraight = a < b
      ? this->Step.IsStraight(earlier, before, a, this->FindTilt(1, beam))
      : this->Step.IsStraight(later, after, b, this->FindTilt(4, beam));
    return isStraight ? lms3dDepthStep::Joined : lms3dDepthStep::Uncertain;
  }

private:
  // From two turns before the first of the neighbours to two after the second.
  static constexpr int NumberOfRows = 6;

  std::array<double, NumberOfRows> GetRanges(int beam) const
  {
    return { this->Rows[0][beam], this->Rows[1][beam], this->Rows[2][beam], this->Rows[3][beam],
      this->Rows[4][beam], this->Rows[5][beam] };
  }

  double FindTilt(int row, int beam) const
  {
    return this->Rows[row][beam] > 0.0 ? this->Tilts.Find(this->Rows[row], beam) : 0.0;
  }

  const lms3dDepthStep& Step;
  const TiltFinder& Tilts;
  std::array<const double*, NumberOfRows> Rows;
};

// What is found of one turn.
struct TurnFinds
{
  int Turn;
  std::uint8_t* Flags;
  std::vector<lms3dRangeJoins::UncertainJoin>& UncertainJoins;

  void Add(int beam, lms3dRangeJoins::Flag towards, lms3dDepthStep::Relation relation)
  {
    if (relation == lms3dDepthStep::Joined)
    {
      this->Flags[beam] |= towards;
    }
    else if (relation == lms3dDepthStep::Uncertain)
    {
      this->UncertainJoins.push_back({ this->Turn, beam, towards });
    }
  }
};

void ClassifyFan(const lms3dRangeGrid& grid, const lms3dDepthStep& step, TurnFinds& finds)
{
  const double* ranges = grid.GetRanges(finds.Turn);
  for (int beam = 0; beam + 1 < grid.GetNumberOfBeams(); ++beam)
  {
    finds.Add(beam, lms3dRangeJoins::AlongFan, step.Classify(ranges + beam));
  }
}

void ClassifyTurn(const lms3dRangeGrid& grid, const TurnClassifier& classifier, TurnFinds& finds)
{
  for (int beam = 0; beam < grid.GetNumberOfBeams(); ++beam)
  {
    finds.Add(beam, lms3dRangeJoins::AlongTurn, classifier.Classify(beam));
  }
  // Of which there is no doubt.
  for (int pole : grid.GetPoles())
  {
    finds.Flags[pole] &= lms3dRangeJoins::AlongFan;
  }
}
} // namespace

void lms3dRangeJoins::Find(const lms3dRangeGrid& grid, double depthStep)
{
  const lms3dScanGeometry& geometry = grid.GetGeometry();
  const lms3dDepthStep fanStep(depthStep, geometry.GetAlphaStep());
  const lms3dDepthStep turnStep(depthStep, geometry.GetBetaStep());
  const TiltFinder tilts(geometry, fanStep);
  const int turns = grid.GetNumberOfTurns();
  this->Flags.SetShape(turns, grid.GetNumberOfBeams());
  this->UncertainJoins.resize(turns);
  tbb::parallel_for(0, turns,
    [&](int turn)
    {
      TurnFinds finds = { turn, this->Flags.GetRow(turn), this->UncertainJoins[turn] };
      std::fill_n(finds.Flags, grid.GetNumberOfBeams(), 0);
      finds.UncertainJoins.clear();
      if (grid.HasReturns(turn))
      {
        ClassifyFan(grid, fanStep, finds);
        ClassifyTurn(grid, TurnClassifier(grid, turn, turnStep, tilts), finds);
      }
    });
  this->ResolveUncertainJoins(grid);
  this->Flags.FillHalo(grid.IsClosed());
}

// All doubts are joined at first. Those beside a gap fall, one after the other, and the same ones stay
// in whatever order; to and fro, long rows of them fall quickly.
void lms3dRangeJoins::ResolveUncertainJoins(const lms3dRangeGrid& grid)
{
  std::vector<UncertainJoin> uncertain;
  for (const std::vector<UncertainJoin>& ofTurn : this->UncertainJoins)
  {
    uncertain.insert(uncertain.end(), ofTurn.begin(), ofTurn.end());
  }
  for (const UncertainJoin& join : uncertain)
  {
    this->Flags.GetRow(join.Turn)[join.Beam] |= join.Towards;
  }
  std::size_t count;
  do
  {
    count = uncertain.size();
    uncertain.erase(std::remove_if(uncertain.begin(), uncertain.end(),
                      [&](const UncertainJoin& join) { return this->DropBesideGap(grid, join); }),
      uncertain.end());
    std::reverse(uncertain.begin(), uncertain.end());
  } while (uncertain.size() < count);
}

bool lms3dRangeJoins::DropBesideGap(const lms3dRangeGrid& grid, const UncertainJoin& join)
{
  const bool isWhole = this->IsWholeAround(grid, join);
  if (!isWhole)
  {
    this->Flags.GetRow(join.Turn)[join.Beam] &= static_cast<std::uint8_t>(~join.Towards);
  }
  return !isWhole;
}

bool lms3dRangeJoins::IsWholeAround(const lms3dRangeGrid& grid, const UncertainJoin& join) const
{
  const int turn = join.Turn;
  const int beam = join.Beam;
  if (join.Towards == AlongFan)
  {
    const auto isWhole = [&](int cell, int beyond)
    {
      return this->IsJoined(grid, cell, beam, AlongTurn) &&
        this->IsJoined(grid, cell, beam + 1, AlongTurn) &&
        this->IsJoined(grid, beyond, beam, AlongFan);
    };
    return isWhole(turn - 1, turn - 1) && isWhole(turn, turn + 1);
  }
  const auto isWhole = [&](int cell, int beyond)
  {
    return this->IsJoined(grid, turn, cell, AlongFan) &&
      this->IsJoined(grid, turn + 1, cell, AlongFan) &&
      this->IsJoined(grid, turn, beyond, AlongTurn);
  };
  return isWhole(beam - 1, beam - 1) && isWhole(beam, beam + 1);
}

// Pole and pole are one.
bool lms3dRangeJoins::IsJoined(const lms3dRangeGrid& grid, int turn, int beam, Flag towards) const
{
  const int turns = grid.GetNumberOfTurns();
  const bool isInside =
    (grid.IsClosed() || (turn >= 0 && turn < turns)) && beam >= 0 && beam < grid.GetNumberOfBeams();
  return isInside &&
    ((towards == AlongTurn && grid.GetGeometry().IsPole(beam)) ||
      (this->GetRow((turn + turns) % turns)[beam] & towards) != 0);
}
