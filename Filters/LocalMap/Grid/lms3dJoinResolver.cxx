// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dJoinResolver.h"

#include <algorithm>
#include <cstddef>

namespace
{
// The number of pairs on each side of an uncertain pair that count.
constexpr int MaximumPairs = 2;
} // namespace

// Calls visit(turn, beam) for the pair and for those beside it.
template <typename Visitor>
void lms3dJoinResolver::ForEachParallel(const lms3dUncertainJoin& join, const Visitor& visit) const
{
  visit(join.Turn, join.Beam);
  const bool isFan = join.Towards == lms3dJoinedAlongFan;
  const lms3dJoinFlag across = isFan ? lms3dJoinedAlongTurn : lms3dJoinedAlongFan;
  for (int direction : { -1, 1 })
  {
    int turn = join.Turn;
    int beam = join.Beam;
    for (int i = 0; i < MaximumPairs; ++i)
    {
      const int previous = direction < 0 ? -1 : 0;
      const int flagTurn = isFan ? turn + previous : turn;
      const int flagBeam = isFan ? beam : beam + previous;
      if (!this->IsJoined(flagTurn, flagBeam, across) ||
        !this->IsJoined(flagTurn + (isFan ? 0 : 1), flagBeam + (isFan ? 1 : 0), across))
      {
        break;
      }
      turn += isFan ? direction : 0;
      beam += isFan ? 0 : direction;
      if (this->Grid.GetGeometry().IsPole(beam) ||
        (isFan && this->Grid.GetGeometry().IsPole(beam + 1)))
      {
        break;
      }
      visit(turn, beam);
    }
  }
}

lms3dDepthStep::Relation lms3dJoinResolver::ClassifyMean(
  const lms3dUncertainJoin& join, const Classifiers& classifiers) const
{
  const bool isFan = join.Towards == lms3dJoinedAlongFan;
  const lms3dDepthStep& step = isFan ? classifiers.FanStep : classifiers.TurnStep;
  lms3dDepthStep::Plane before;
  lms3dDepthStep::Plane behind;
  int count = 0;
  this->ForEachParallel(join,
    [&](int turn, int beam)
    {
      const int turns = this->Grid.GetNumberOfTurns();
      const int row = (turn + turns) % turns;
      ++count;
      if (isFan)
      {
        const double* at = this->Grid.GetRanges(row) + beam;
        before.Add(step.GetPlane(lms3dDepthStep::GetSideBefore(at)), 1.0);
        behind.Add(step.GetPlane(lms3dDepthStep::GetSideBehind(at)), 1.0);
        return;
      }
      const lms3dTurnClassifier classifier(this->Grid, row, step, classifiers.Tilts);
      before.Add(step.GetPlane(classifier.GetSideBefore(beam)), 1.0);
      behind.Add(step.GetPlane(classifier.GetSideBehind(beam)), 1.0);
    });
  lms3dDepthStep::Plane meanBefore;
  lms3dDepthStep::Plane meanBehind;
  meanBefore.Add(before, 1.0 / count);
  meanBehind.Add(behind, 1.0 / count);
  return step.ClassifyMeans(meanBefore, meanBehind);
}

// Joins all uncertain neighbours first, then separates those beside a gap, one after the other. Any order
// gives the same result; alternating directions are fast for long rows.
void lms3dJoinResolver::JoinWhole(std::vector<lms3dUncertainJoin> uncertain)
{
  for (const lms3dUncertainJoin& join : uncertain)
  {
    this->Joins.GetRow(join.Turn)[join.Beam] |= join.Towards;
  }
  std::size_t count;
  do
  {
    count = uncertain.size();
    uncertain.erase(std::remove_if(uncertain.begin(), uncertain.end(),
                      [&](const lms3dUncertainJoin& join) { return this->DropBesideGap(join); }),
      uncertain.end());
    std::reverse(uncertain.begin(), uncertain.end());
  } while (uncertain.size() < count);
}

bool lms3dJoinResolver::DropBesideGap(const lms3dUncertainJoin& join)
{
  const bool isWhole = this->IsWholeAround(join);
  if (!isWhole)
  {
    this->Joins.GetRow(join.Turn)[join.Beam] &= static_cast<std::uint8_t>(~join.Towards);
  }
  return !isWhole;
}

bool lms3dJoinResolver::IsWholeAround(const lms3dUncertainJoin& join) const
{
  const int turn = join.Turn;
  const int beam = join.Beam;
  if (join.Towards == lms3dJoinedAlongFan)
  {
    const auto isWhole = [&](int cell, int beyond)
    {
      return this->IsJoined(cell, beam, lms3dJoinedAlongTurn) &&
        this->IsJoined(cell, beam + 1, lms3dJoinedAlongTurn) &&
        this->IsJoined(beyond, beam, lms3dJoinedAlongFan);
    };
    return isWhole(turn - 1, turn - 1) && isWhole(turn, turn + 1);
  }
  const auto isWhole = [&](int cell, int beyond)
  {
    return this->IsJoined(turn, cell, lms3dJoinedAlongFan) &&
      this->IsJoined(turn + 1, cell, lms3dJoinedAlongFan) &&
      this->IsJoined(turn, beyond, lms3dJoinedAlongTurn);
  };
  return isWhole(beam - 1, beam - 1) && isWhole(beam, beam + 1);
}

// The entries of a pole count as joined.
bool lms3dJoinResolver::IsJoined(int turn, int beam, lms3dJoinFlag towards) const
{
  const int turns = this->Grid.GetNumberOfTurns();
  const bool isInside = (this->Grid.IsClosed() || (turn >= 0 && turn < turns)) && beam >= 0 &&
    beam < this->Grid.GetNumberOfBeams();
  return isInside &&
    ((towards == lms3dJoinedAlongTurn && this->Grid.GetGeometry().IsPole(beam)) ||
      (this->Joins.GetRow((turn + turns) % turns)[beam] & towards) != 0);
}
