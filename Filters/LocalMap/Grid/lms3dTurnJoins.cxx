// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dTurnJoins.h"

namespace
{
// With an odd number of turns, no fan continues beyond a pole in a turn that is opposite.
bool IsBesideOddPole(const lms3dRangeGrid& grid, int beam)
{
  const lms3dScanGeometry& geometry = grid.GetGeometry();
  return grid.GetNumberOfTurns() % 2 != 0 && (geometry.IsPole(beam) || geometry.IsPole(beam + 1));
}
} // namespace

void lms3dTurnJoins::JoinEqualRanges(
  const lms3dRangeGrid& grid, const double* ranges, const lms3dDepthStep& step)
{
  for (int beam = 0; beam + 1 < grid.GetNumberOfBeams(); ++beam)
  {
    this->Flags[beam] |=
      step.AreRangesEqual(ranges[beam], ranges[beam + 1]) ? lms3dJoinedAlongFan : 0;
  }
}

void lms3dTurnJoins::ClassifyFan(
  const lms3dRangeGrid& grid, const double* ranges, const lms3dDepthStep& step)
{
  // Most neighbours are near.
  step.FlagNear(ranges, ranges + 1, grid.GetNumberOfBeams() - 1, lms3dJoinedAlongFan, this->Flags);
  for (int beam = 0; beam + 1 < grid.GetNumberOfBeams(); ++beam)
  {
    if (this->Flags[beam] & lms3dJoinedAlongFan)
    {
      continue;
    }
    const double* const at = ranges + beam;
    lms3dDepthStep::Relation relation = step.Classify(at);
    const bool isApart = relation == lms3dDepthStep::Separate || relation == lms3dDepthStep::Gentle;
    if (isApart && at[0] > 0.0 && at[1] > 0.0 && IsBesideOddPole(grid, beam))
    {
      relation = lms3dDepthStep::Uncertain;
    }
    this->Add(beam, lms3dJoinedAlongFan, relation);
  }
}

void lms3dTurnJoins::ClassifyTurn(const lms3dRangeGrid& grid, const lms3dTurnClassifier& classifier)
{
  classifier.FlagNear(grid.GetNumberOfBeams(), lms3dJoinedAlongTurn, this->Flags);
  for (int beam = 0; beam < grid.GetNumberOfBeams(); ++beam)
  {
    if (!(this->Flags[beam] & lms3dJoinedAlongTurn))
    {
      this->Add(beam, lms3dJoinedAlongTurn, classifier.Classify(beam));
    }
  }
  // A pole is certainly not joined.
  for (int pole : grid.GetPoles())
  {
    this->Flags[pole] &= lms3dJoinedAlongFan;
  }
}

void lms3dTurnJoins::Add(int beam, lms3dJoinFlag towards, lms3dDepthStep::Relation relation)
{
  const lms3dUncertainJoin join = { this->Turn, beam, towards, relation };
  if (lms3dDepthStep::IsOneSurface(relation))
  {
    this->Flags[beam] |= towards;
  }
  if (relation == lms3dDepthStep::Crease)
  {
    this->Creases.push_back(join);
  }
  else if (relation == lms3dDepthStep::Loose || relation == lms3dDepthStep::Gentle)
  {
    this->Loose.push_back(join);
  }
  else if (relation >= lms3dDepthStep::Uncertain)
  {
    this->UncertainJoins.push_back(join);
  }
}

void lms3dTurnJoins::Clear()
{
  this->UncertainJoins.clear();
  this->Creases.clear();
  this->Loose.clear();
}
