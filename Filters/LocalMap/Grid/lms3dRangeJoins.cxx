// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dRangeJoins.h"

#include "LocalMap/Grid/lms3dSteadyFans.h"
#include "LocalMap/Grid/lms3dTurnClassifier.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

namespace
{
/// Collects the joins of one turn.
struct TurnJoins
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

void ClassifyFan(
  const lms3dRangeGrid& grid, const double* ranges, const lms3dDepthStep& step, TurnJoins& found)
{
  for (int beam = 0; beam + 1 < grid.GetNumberOfBeams(); ++beam)
  {
    found.Add(beam, lms3dRangeJoins::AlongFan, step.Classify(ranges + beam));
  }
}

void ClassifyTurn(
  const lms3dRangeGrid& grid, const lms3dTurnClassifier& classifier, TurnJoins& found)
{
  for (int beam = 0; beam < grid.GetNumberOfBeams(); ++beam)
  {
    found.Add(beam, lms3dRangeJoins::AlongTurn, classifier.Classify(beam));
  }
  // A pole is certainly not joined.
  for (int pole : grid.GetPoles())
  {
    found.Flags[pole] &= lms3dRangeJoins::AlongFan;
  }
}
} // namespace

void lms3dRangeJoins::Find(
  const lms3dRangeGrid& grid, double depthStep, const lms3dMapGeometry* mapGeometry)
{
  const bool areFansSteady = !mapGeometry || !mapGeometry->GetTurnedSteps(0);
  const lms3dScanGeometry& geometry = grid.GetGeometry();
  const lms3dDepthStep fanStep(depthStep, geometry.GetAlphaStep());
  const lms3dDepthStep turnStep(depthStep, geometry.GetBetaStep());
  const lms3dTiltFinder tilts(geometry, fanStep);
  const int turns = grid.GetNumberOfTurns();
  this->Flags.SetShape(turns, grid.GetNumberOfBeams());
  this->UncertainJoins.resize(turns);
  tbb::parallel_for(0, turns,
    [&](int turn)
    {
      TurnJoins found = { turn, this->Flags.GetRow(turn), this->UncertainJoins[turn] };
      std::fill_n(found.Flags, grid.GetNumberOfBeams(), 0);
      found.UncertainJoins.clear();
      if (grid.HasReturns(turn))
      {
        if (areFansSteady)
        {
          ClassifyFan(grid, grid.GetRanges(turn), fanStep, found);
        }
        ClassifyTurn(grid, lms3dTurnClassifier(grid, turn, turnStep, tilts), found);
      }
    });
  if (!areFansSteady)
  {
    this->FindAlongSteadyFans(grid, fanStep, *mapGeometry);
  }
  this->ResolveUncertainJoins(grid);
  if (mapGeometry && mapGeometry->GetDistanceFromAxis() > 0.0)
  {
    this->SeparateBeyondAxis(grid, *mapGeometry);
  }
  this->Flags.FillHalo(grid.IsClosed());
}

// To be called after all turns are joined: reads the joins along them.
void lms3dRangeJoins::FindAlongSteadyFans(
  const lms3dRangeGrid& grid, const lms3dDepthStep& step, const lms3dMapGeometry& geometry)
{
  // Halos of two beams on either side.
  std::vector<double> ranges(static_cast<std::size_t>(grid.GetNumberOfBeams()) + 4);
  const lms3dSteadyFans fans(grid, geometry, this->Flags);
  for (int turn = 0; turn < grid.GetNumberOfTurns(); ++turn)
  {
    if (grid.HasReturns(turn))
    {
      fans.Fill(turn, ranges.data() + 2);
      TurnJoins found = { turn, this->Flags.GetRow(turn), this->UncertainJoins[turn] };
      ClassifyFan(grid, ranges.data() + 2, step, found);
    }
  }
}

void lms3dRangeJoins::SeparateBeyondAxis(
  const lms3dRangeGrid& grid, const lms3dMapGeometry& geometry)
{
  for (int turn = 0; turn < grid.GetNumberOfTurns(); ++turn)
  {
    for (int beam = 0; beam < grid.GetNumberOfBeams(); ++beam)
    {
      if (grid.HasReturn(turn, beam) &&
        geometry.IsBeyondAxis(turn, beam, grid.GetRange(turn, beam)))
      {
        this->Separate(grid, turn, beam);
      }
    }
  }
}

void lms3dRangeJoins::Separate(const lms3dRangeGrid& grid, int turn, int beam)
{
  const auto clear = [this](int row, int column, Flag flag)
  { this->Flags.GetRow(row)[column] &= static_cast<std::uint8_t>(~flag); };
  const int turns = grid.GetNumberOfTurns();
  clear(turn, beam, AlongFan);
  clear(turn, beam, AlongTurn);
  clear((turn + turns - 1) % turns, beam, AlongTurn);
  if (beam > 0)
  {
    clear(turn, beam - 1, AlongFan);
  }
}

// Joins all uncertain neighbours first, then separates those beside a gap, one after the other. Any order
// gives the same result; alternating directions are fast for long rows.
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

// The entries of a pole count as joined.
bool lms3dRangeJoins::IsJoined(const lms3dRangeGrid& grid, int turn, int beam, Flag towards) const
{
  const int turns = grid.GetNumberOfTurns();
  const bool isInside =
    (grid.IsClosed() || (turn >= 0 && turn < turns)) && beam >= 0 && beam < grid.GetNumberOfBeams();
  return isInside &&
    ((towards == AlongTurn && grid.GetGeometry().IsPole(beam)) ||
      (this->GetRow((turn + turns) % turns)[beam] & towards) != 0);
}
