// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRangeJoins.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace
{
void FindInTurn(const lms3dRangeGrid& grid, int turn, const lms3dDepthStep& fanStep,
  const lms3dDepthStep& turnStep, std::uint8_t* flags)
{
  const int beams = grid.GetNumberOfBeams();
  if (!grid.HasReturns(turn))
  {
    std::fill_n(flags, beams, 0);
    return;
  }
  const double* before = grid.GetRanges(turn - 1);
  const double* here = grid.GetRanges(turn);
  const double* next = grid.GetRanges(turn + 1);
  const double* after = grid.GetRanges(turn + 2);
  for (int i = 0; i < beams - 1; ++i)
  {
    flags[i] = fanStep.IsJoined(here[i - 1], here[i], here[i + 1], here[i + 2])
      ? lms3dRangeJoins::AlongFan
      : 0;
  }
  flags[beams - 1] = 0;
  for (int i = 0; i < beams; ++i)
  {
    flags[i] |=
      turnStep.IsJoined(before[i], here[i], next[i], after[i]) ? lms3dRangeJoins::AlongTurn : 0;
  }
  for (int pole : grid.GetPoles())
  {
    flags[pole] &= lms3dRangeJoins::AlongFan;
  }
}
} // namespace

void lms3dRangeJoins::Find(const lms3dRangeGrid& grid, double depthStep)
{
  const lms3dDepthStep fanStep(depthStep, grid.GetGeometry().GetAlphaStep());
  const lms3dDepthStep turnStep(depthStep, grid.GetGeometry().GetBetaStep());
  this->Flags.SetShape(grid.GetNumberOfTurns(), grid.GetNumberOfBeams());
  tbb::parallel_for(0, grid.GetNumberOfTurns(),
    [&](int turn) { FindInTurn(grid, turn, fanStep, turnStep, this->Flags.GetRow(turn)); });
  this->Flags.FillGhosts(grid.IsClosed());
}
