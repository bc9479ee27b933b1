// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The pairs beside an uncertain pair of lms3dJoinResolver, and the relation of their mean.
#include "LocalMap/Grid/lms3dJoinResolver.h"

namespace
{
// The number of pairs on each side of an uncertain pair that count.
constexpr int MaximumPairs = 2;
} // namespace

// Calls visit(turn, beam) for the pair and for the pairs beside it, except at poles.
template <typename Visitor>
void lms3dJoinResolver::ForEachParallel(const lms3dUncertainJoin& join, const Visitor& visit) const
{
  const lms3dScanGeometry& geometry = this->Grid.GetGeometry();
  const bool isFan = join.Towards == lms3dJoinedAlongFan;
  visit(join.Turn, join.Beam);
  for (int direction : { -1, 1 })
  {
    int turn = join.Turn;
    int beam = join.Beam;
    for (int i = 0; i < MaximumPairs && this->IsJoinedAcross(turn, beam, isFan, direction); ++i)
    {
      turn += isFan ? direction : 0;
      beam += isFan ? 0 : direction;
      if (geometry.IsPole(beam) || (isFan && geometry.IsPole(beam + 1)))
      {
        break;
      }
      visit(turn, beam);
    }
  }
}

// Whether both returns of a pair are joined with the returns of the pair beside it.
bool lms3dJoinResolver::IsJoinedAcross(int turn, int beam, bool isFan, int direction) const
{
  const int previous = direction < 0 ? -1 : 0;
  return isFan ? this->IsJoined(turn + previous, beam, lms3dJoinedAlongTurn) &&
      this->IsJoined(turn + previous, beam + 1, lms3dJoinedAlongTurn)
               : this->IsJoined(turn, beam + previous, lms3dJoinedAlongFan) &&
      this->IsJoined(turn + 1, beam + previous, lms3dJoinedAlongFan);
}

// Pairs without a return before or behind have no plane and do not count.
lms3dDepthStep::Relation lms3dJoinResolver::ClassifyMean(
  const lms3dUncertainJoin& join, const Classifiers& classifiers) const
{
  const bool isFan = join.Towards == lms3dJoinedAlongFan;
  const lms3dDepthStep& step = isFan ? classifiers.FanStep : classifiers.TurnStep;
  lms3dDepthStep::Plane before;
  lms3dDepthStep::Plane behind;
  int pairs = 0;
  int planes = 0;
  bool hasPlanes = false;
  // The mean of curved sides can look straight.
  const auto getPlane = [&step](const lms3dDepthStep::Side& side)
  {
    lms3dDepthStep::Plane plane = step.GetPlane(side);
    plane.HasBend = plane.HasBend && !step.IsCurved(plane);
    return plane;
  };
  this->ForEachParallel(join,
    [&](int turn, int beam)
    {
      const auto [first, second] =
        this->GetSides({ turn, beam, join.Towards, join.Relation }, classifiers);
      const bool arePlanes = first.Ranges[1] > 0.0 && second.Ranges[1] > 0.0;
      hasPlanes = pairs++ == 0 ? arePlanes : hasPlanes;
      if (arePlanes)
      {
        before.Add(getPlane(first), 1.0);
        behind.Add(getPlane(second), 1.0);
        ++planes;
      }
    });
  if (!hasPlanes)
  {
    return lms3dDepthStep::Uncertain;
  }
  lms3dDepthStep::Plane meanBefore;
  lms3dDepthStep::Plane meanBehind;
  meanBefore.Add(before, 1.0 / planes);
  meanBehind.Add(behind, 1.0 / planes);
  return step.ClassifyMeans(meanBefore, meanBehind);
}

std::array<lms3dDepthStep::Side, 2> lms3dJoinResolver::GetSides(
  const lms3dUncertainJoin& join, const Classifiers& classifiers) const
{
  const int turns = this->Grid.GetNumberOfTurns();
  const int turn = (join.Turn + turns) % turns;
  if (join.Towards == lms3dJoinedAlongFan)
  {
    const double* const at = this->Grid.GetRanges(turn) + join.Beam;
    return { lms3dDepthStep::GetSideBefore(at), lms3dDepthStep::GetSideBehind(at) };
  }
  const lms3dTurnClassifier classifier(this->Grid, turn, classifiers.TurnStep, classifiers.Tilts);
  return { classifier.GetSideBefore(join.Beam), classifier.GetSideBehind(join.Beam) };
}
