// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dSteadyFans.h"

#include "LocalMap/Grid/lms3dRangeJoins.h"

#include <algorithm>
#include <cmath>

void lms3dSteadyFans::Fill(int turn, double* ranges) const
{
  const int beams = this->Grid.GetNumberOfBeams();
  const double* measured = this->Grid.GetRanges(turn);
  std::copy(measured - 2, measured + beams + 2, ranges - 2);
  const double* turnedSteps = this->Geometry.GetTurnedSteps(turn);
  for (int beam = 0; beam < beams; ++beam)
  {
    if (measured[beam] > 0.0)
    {
      ranges[beam] = this->GetRange(turn, beam, turnedSteps[beam]);
    }
  }
}

double lms3dSteadyFans::GetRange(int turn, int beam, double turnedSteps) const
{
  const double measured = this->Grid.GetRange(turn, beam);
  const int turns = this->Grid.GetNumberOfTurns();
  const double before = std::floor(-turnedSteps);
  if (!(std::abs(before) < turns))
  {
    return measured;
  }
  const double share = -turnedSteps - before;
  const int first = turn + static_cast<int>(before);
  if (!this->Grid.IsClosed() && (first < 0 || first + 1 >= turns))
  {
    return measured;
  }
  const int from = (first + turns) % turns;
  const int to = (from + 1) % turns;
  return (this->Joins.GetRow(from)[beam] & lms3dRangeJoins::AlongTurn) ? 1.0 /
      ((1.0 - share) / this->Grid.GetRange(from, beam) + share / this->Grid.GetRange(to, beam))
                                                                       : measured;
}
