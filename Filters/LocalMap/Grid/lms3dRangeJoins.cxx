// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dRangeJoins.h"

#include "LocalMap/Grid/lms3dGrazedStrips.h"
#include "LocalMap/Grid/lms3dScanNoise.h"
#include "LocalMap/Grid/lms3dSteadyFans.h"
#include "LocalMap/Grid/lms3dTurnClassifier.h"
#include "LocalMap/Grid/lms3dTurnJoins.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace
{
// The largest noise that counts, in depth steps. If all returns deviate by more than a depth step,
// all are apart.
constexpr double MaximumNoise = 0.5;

double GetNoise(const lms3dRangeGrid& grid, int interlaced, double depthStep)
{
  const double noise = lms3dEstimateScanNoise(grid, interlaced);
  return noise > depthStep ? 0.0 : std::min(noise, MaximumNoise * depthStep);
}

std::vector<lms3dUncertainJoin> Concatenate(
  const std::vector<std::vector<lms3dUncertainJoin>>& joinsOfTurns)
{
  std::vector<lms3dUncertainJoin> all;
  for (const std::vector<lms3dUncertainJoin>& ofTurn : joinsOfTurns)
  {
    all.insert(all.end(), ofTurn.begin(), ofTurn.end());
  }
  return all;
}
} // namespace

void lms3dRangeJoins::Find(
  const lms3dRangeGrid& grid, double depthStep, const lms3dMapGeometry* mapGeometry)
{
  const bool areFansSteady = !mapGeometry || !mapGeometry->GetTurnedSteps(0);
  const lms3dScanGeometry& geometry = grid.GetGeometry();
  const int interlaced = mapGeometry ? mapGeometry->GetInterlacedBeams() : 1;
  const double noise = GetNoise(grid, interlaced, depthStep);
  const lms3dDepthStep fanStep(depthStep, geometry.GetAlphaStep(), noise);
  const lms3dDepthStep turnStep(depthStep, geometry.GetBetaStep(), noise);
  lms3dTiltFinder tilts(geometry, fanStep, areFansSteady);
  const int turns = grid.GetNumberOfTurns();
  this->Flags.SetShape(turns, grid.GetNumberOfBeams());
  this->UncertainJoins.resize(turns);
  this->Creases.resize(turns);
  this->Loose.resize(turns);
  tbb::parallel_for(0, turns,
    [&](int turn)
    {
      lms3dTurnJoins found = this->GetTurnJoins(turn);
      std::fill_n(found.Flags, grid.GetNumberOfBeams(), 0);
      found.Clear();
      if (areFansSteady && grid.HasReturns(turn))
      {
        found.ClassifyFan(grid, grid.GetRanges(turn), fanStep);
      }
    });
  if (areFansSteady)
  {
    this->KeepFans(grid, fanStep);
    tilts.SetFans(this->Fans);
  }
  tbb::parallel_for(0, turns,
    [&](int turn)
    {
      lms3dTurnJoins found = this->GetTurnJoins(turn);
      if (grid.HasReturns(turn))
      {
        found.ClassifyTurn(grid, lms3dTurnClassifier(grid, turn, turnStep, tilts));
      }
    });
  if (!areFansSteady)
  {
    this->FindAlongSteadyFans(grid, fanStep, *mapGeometry);
  }
  else
  {
    this->ResolveMeans(grid, { fanStep, turnStep, tilts });
    this->JoinGrazed(grid, lms3dGrazedStrips(grid, this->Flags, depthStep, noise));
  }
  this->ResolveRest(grid, depthStep);
  if (mapGeometry && mapGeometry->GetDistanceFromAxis() > 0.0)
  {
    this->SeparateBeyondAxis(grid, *mapGeometry);
  }
  this->Flags.FillHalo(grid.IsClosed());
}

lms3dTurnJoins lms3dRangeJoins::GetTurnJoins(int turn)
{
  return { turn, this->Flags.GetRow(turn), this->UncertainJoins[turn], this->Creases[turn],
    this->Loose[turn] };
}

// To be called after all fans are joined. The fans of the halo do not go on beyond a pole.
void lms3dRangeJoins::KeepFans(const lms3dRangeGrid& grid, const lms3dDepthStep& step)
{
  const int turns = grid.GetNumberOfTurns();
  const int beams = grid.GetNumberOfBeams();
  this->Fans.SetShape(turns, beams);
  tbb::parallel_for(this->Fans.GetFirstTurn(), this->Fans.GetEndOfTurns(),
    [&](int turn)
    {
      std::uint8_t* const fan = this->Fans.GetRow(turn);
      if (turn >= 0 && turn < turns)
      {
        std::copy_n(this->Flags.GetRow(turn), beams, fan);
        return;
      }
      for (int beam = 0; beam + 1 < beams; ++beam)
      {
        fan[beam] = step.IsOneSurface(grid.GetRanges(turn) + beam) ? AlongFan : 0;
      }
    });
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
      lms3dTurnJoins found = this->GetTurnJoins(turn);
      // Where a fan cannot be interpolated, its comb remains.
      found.JoinEqualRanges(grid, ranges.data() + 2, step);
      found.ClassifyFan(grid, ranges.data() + 2, step);
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

// The flags are written after all means are classified, so that the order of the turns does not
// count.
void lms3dRangeJoins::ResolveMeans(
  const lms3dRangeGrid& grid, const lms3dJoinResolver::Classifiers& classifiers)
{
  const lms3dJoinResolver resolver(grid, this->Flags);
  std::vector<std::vector<lms3dDepthStep::Relation>> relations(this->UncertainJoins.size());
  tbb::parallel_for(std::size_t(0), relations.size(),
    [&](std::size_t turn)
    {
      for (const lms3dUncertainJoin& join : this->UncertainJoins[turn])
      {
        relations[turn].push_back(
          join.IsNoisy() ? resolver.ClassifyMean(join, classifiers) : lms3dDepthStep::Uncertain);
      }
    });
  for (std::size_t turn = 0; turn < relations.size(); ++turn)
  {
    const std::vector<lms3dUncertainJoin> uncertain = std::move(this->UncertainJoins[turn]);
    this->UncertainJoins[turn].clear();
    lms3dTurnJoins found = this->GetTurnJoins(static_cast<int>(turn));
    for (std::size_t i = 0; i < uncertain.size(); ++i)
    {
      found.Add(uncertain[i].Beam, uncertain[i].Towards, relations[turn][i]);
    }
  }
}

// The flags are written after all strips are judged, as other threads read them.
void lms3dRangeJoins::JoinGrazed(const lms3dRangeGrid& grid, const lms3dGrazedStrips& strips)
{
  std::vector<std::vector<int>> grazed(grid.GetNumberOfTurns());
  tbb::parallel_for(0, grid.GetNumberOfTurns(),
    [&](int turn)
    {
      const std::uint8_t* const flags = this->Flags.GetRow(turn);
      const double* const ranges = grid.GetRanges(turn);
      for (int beam = 0; beam + 1 < grid.GetNumberOfBeams(); ++beam)
      {
        if ((flags[beam] & AlongFan) == 0 && ranges[beam] > 0.0 && ranges[beam + 1] > 0.0 &&
          strips.AreOneSurface(turn, beam))
        {
          grazed[turn].push_back(beam);
        }
      }
    });
  for (int turn = 0; turn < grid.GetNumberOfTurns(); ++turn)
  {
    for (int beam : grazed[turn])
    {
      this->Flags.GetRow(turn)[beam] |= AlongFan;
    }
  }
}

void lms3dRangeJoins::ResolveRest(const lms3dRangeGrid& grid, double depthStep)
{
  std::vector<lms3dUncertainJoin> uncertain;
  for (const std::vector<lms3dUncertainJoin>& ofTurn : this->UncertainJoins)
  {
    std::copy_if(ofTurn.begin(), ofTurn.end(), std::back_inserter(uncertain),
      [this](const lms3dUncertainJoin& join)
      { return (this->Flags.GetRow(join.Turn)[join.Beam] & join.Towards) == 0; });
  }
  lms3dJoinResolver resolver(grid, this->Flags);
  resolver.JoinWhole(std::move(uncertain));
  resolver.SeparateBesideSteps(Concatenate(this->Creases), depthStep);
  resolver.DecideLoose(Concatenate(this->Loose));
}
