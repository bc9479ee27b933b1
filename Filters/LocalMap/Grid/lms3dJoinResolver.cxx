// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dJoinResolver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace
{
// The number of open sides around a pair on one surface.
constexpr int MaximumOpenSides = 2;
} // namespace

// Joins all uncertain neighbours first, then separates those beside a gap, one after the other. Any
// order gives the same result; alternating directions are fast for long rows.
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

// A step goes on beside a pair that it separates. The pairs are judged before any is separated, so
// their order does not count.
void lms3dJoinResolver::SeparateBesideSteps(
  const std::vector<lms3dUncertainJoin>& joins, double depthStep)
{
  std::vector<lms3dUncertainJoin> besideSteps;
  std::copy_if(joins.begin(), joins.end(), std::back_inserter(besideSteps),
    [&](const lms3dUncertainJoin& join) { return this->IsBesideStep(join, 2.0 * depthStep); });
  for (const lms3dUncertainJoin& join : besideSteps)
  {
    this->Separate(join);
  }
}

// All pairs are judged before any changes, so their order does not count.
void lms3dJoinResolver::DecideLoose(const std::vector<lms3dUncertainJoin>& joins)
{
  std::vector<lms3dUncertainJoin> changes;
  std::copy_if(joins.begin(), joins.end(), std::back_inserter(changes),
    [this](const lms3dUncertainJoin& join)
    { return this->IsSurfaceAround(join) == (join.Relation == lms3dDepthStep::Gentle); });
  for (const lms3dUncertainJoin& join : changes)
  {
    this->Separate(join);
    this->Joins.GetRow(join.Turn)[join.Beam] |=
      join.Relation == lms3dDepthStep::Gentle ? join.Towards : 0;
  }
}

bool lms3dJoinResolver::IsSurfaceAround(const lms3dUncertainJoin& join) const
{
  const auto [before, behind] = this->CountOpenSides(join);
  if (join.Relation == lms3dDepthStep::Gentle)
  {
    return before + behind <= MaximumOpenSides && std::min(before, behind) == 0;
  }
  const int turns = join.Towards == lms3dJoinedAlongFan ? 1 : 0;
  const int beams = 1 - turns;
  return (this->IsInside(join.Turn - turns, join.Beam - beams) ? before : 0) +
    (this->IsInside(join.Turn + turns, join.Beam + beams) ? behind : 0) <=
    MaximumOpenSides;
}

bool lms3dJoinResolver::IsBesideStep(const lms3dUncertainJoin& join, double minimum) const
{
  const double difference = this->GetDifference(join);
  const bool isFan = join.Towards == lms3dJoinedAlongFan;
  const auto isStep = [&](int direction)
  {
    const lms3dUncertainJoin beside = { join.Turn + (isFan ? direction : 0),
      join.Beam + (isFan ? 0 : direction), join.Towards, join.Relation };
    if (!this->IsInside(beside.Turn, beside.Beam))
    {
      return false;
    }
    const double step = this->GetDifference(beside);
    return std::abs(step) > minimum && step * difference > 0.0 &&
      !this->IsJoined(beside.Turn, beside.Beam, beside.Towards);
  };
  return isStep(-1) || isStep(1);
}

// From the range of the beam to that of its neighbour; 0 if one has not returned.
double lms3dJoinResolver::GetDifference(const lms3dUncertainJoin& join) const
{
  const int turns = this->Grid.GetNumberOfTurns();
  const int turn = (join.Turn + turns) % turns;
  const bool isFan = join.Towards == lms3dJoinedAlongFan;
  const double range = this->Grid.GetRanges(turn)[join.Beam];
  const double next =
    isFan ? this->Grid.GetRanges(turn)[join.Beam + 1] : this->Grid.GetRanges(turn + 1)[join.Beam];
  return range > 0.0 && next > 0.0 ? next - range : 0.0;
}

void lms3dJoinResolver::Separate(const lms3dUncertainJoin& join)
{
  this->Joins.GetRow(join.Turn)[join.Beam] &= static_cast<std::uint8_t>(~join.Towards);
}

bool lms3dJoinResolver::DropBesideGap(const lms3dUncertainJoin& join)
{
  const bool isWhole = this->CountOpenSides(join) == std::array<int, 2>{ 0, 0 };
  if (!isWhole)
  {
    this->Separate(join);
  }
  return !isWhole;
}

// The sides of each adjacent cell, except the pair itself, that are not joined.
std::array<int, 2> lms3dJoinResolver::CountOpenSides(const lms3dUncertainJoin& join) const
{
  const int turn = join.Turn;
  const int beam = join.Beam;
  const auto count = [](bool first, bool second, bool third)
  { return (first ? 0 : 1) + (second ? 0 : 1) + (third ? 0 : 1); };
  if (join.Towards == lms3dJoinedAlongFan)
  {
    const auto countIn = [&](int cell, int beyond)
    {
      return count(this->IsJoined(cell, beam, lms3dJoinedAlongTurn),
        this->IsJoined(cell, beam + 1, lms3dJoinedAlongTurn),
        this->IsJoined(beyond, beam, lms3dJoinedAlongFan));
    };
    return { countIn(turn - 1, turn - 1), countIn(turn, turn + 1) };
  }
  const auto countIn = [&](int cell, int beyond)
  {
    return count(this->IsJoined(turn, cell, lms3dJoinedAlongFan),
      this->IsJoined(turn + 1, cell, lms3dJoinedAlongFan),
      this->IsJoined(turn, beyond, lms3dJoinedAlongTurn));
  };
  return { countIn(beam - 1, beam - 1), countIn(beam, beam + 1) };
}

bool lms3dJoinResolver::IsInside(int turn, int beam) const
{
  return (this->Grid.IsClosed() || (turn >= 0 && turn < this->Grid.GetNumberOfTurns())) &&
    beam >= 0 && beam < this->Grid.GetNumberOfBeams();
}

// The entries of a pole count as joined.
bool lms3dJoinResolver::IsJoined(int turn, int beam, lms3dJoinFlag towards) const
{
  const int turns = this->Grid.GetNumberOfTurns();
  return this->IsInside(turn, beam) &&
    ((towards == lms3dJoinedAlongTurn && this->Grid.GetGeometry().IsPole(beam)) ||
      (this->Joins.GetRow((turn + turns) % turns)[beam] & towards) != 0);
}
