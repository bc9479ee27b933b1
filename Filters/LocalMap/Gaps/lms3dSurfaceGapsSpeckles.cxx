// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Gaps/lms3dSurfaceGaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace
{
// Returns stand out of a surface if they are off it by more than this many times the distance at
// which a plane explains returns.
constexpr double HeightShare = 2.0;

using Groups = lms3dBeamGroups::Groups;

void SetStates(const Groups& groups, lms3dBeamStates::State state, lms3dBeamStates& states)
{
  for (const std::vector<int>& group : groups)
  {
    for (int place : group)
    {
      states.SetState(place, state);
    }
  }
}

// Whether the surface goes on from a place to its neighbour, one of the first four of
// GetNeighbors().
bool IsJoined(
  const lms3dBeamStates& states, const lms3dRangeJoins& joins, int place, std::size_t neighbor)
{
  const int turn = states.GetTurn(place);
  const int beam = states.GetBeam(place);
  switch (neighbor)
  {
    case 0:
      return joins.GetRow(turn)[beam - 1] & lms3dRangeJoins::AlongFan;
    case 1:
      return joins.GetRow(turn)[beam] & lms3dRangeJoins::AlongFan;
    case 2:
      return joins.GetRow(turn - 1)[beam] & lms3dRangeJoins::AlongTurn;
    default:
      return joins.GetRow(turn)[beam] & lms3dRangeJoins::AlongTurn;
  }
}

// Whether a group lies on one surface with a return beside it.
bool IsJoined(
  const lms3dBeamStates& states, const lms3dRangeJoins& joins, const std::vector<int>& group)
{
  std::vector<int> sorted = group;
  std::sort(sorted.begin(), sorted.end());
  return std::any_of(group.begin(), group.end(),
    [&](int place)
    {
      const std::array<int, 8> neighbors = states.GetNeighbors(place);
      for (std::size_t i = 0; i < 4; ++i)
      {
        if (neighbors[i] != lms3dBeamStates::NoPlace && IsJoined(states, joins, place, i) &&
          !std::binary_search(sorted.begin(), sorted.end(), neighbors[i]))
        {
          return true;
        }
      }
      return false;
    });
}

// Whether the returns of a group lie off the plane, which meets their beams at `onPlane`, metres. A
// return behind the plane shows that its beam has met no surface there. Only the returns beside it
// show that it is wrong.
bool IsOff(const lms3dBeamStates& states, const lms3dSurroundings& surroundings,
  const std::vector<int>& group, const std::vector<double>& onPlane)
{
  bool isBehind = false;
  for (std::size_t i = 0; i < onPlane.size(); ++i)
  {
    const double range = states.GetRange(group[i]);
    if (std::abs(range - onPlane[i]) <= surroundings.GetToleranceAt(std::min(range, onPlane[i])))
    {
      return false;
    }
    isBehind = isBehind || range > onPlane[i];
  }
  return !isBehind || surroundings.HasEnoughReturns(group);
}
} // namespace

// While speckles are searched, none of them counts as a part of the surroundings of others.
void lms3dSurfaceGaps::FindSpeckles(
  const lms3dRangeJoins& joins, lms3dBeamStates& states, const lms3dSurroundings& surroundings)
{
  const lms3dDepthStep step(this->Settings.DepthStep, this->LargerStep);
  const int maximum = this->Settings.MaximumSpeckleSize;
  Groups groups = lms3dBeamGroups(states).FindAtOneDepth(maximum, step);
  groups.erase(std::remove_if(groups.begin(), groups.end(),
                 [&](const std::vector<int>& group) { return IsJoined(states, joins, group); }),
    groups.end());
  SetStates(groups, lms3dBeamStates::Speckle, states);
  for (const lms3dBeamGroups::Side side : { lms3dBeamGroups::Nearer, lms3dBeamGroups::Farther })
  {
    const Groups standingOut = lms3dBeamGroups(states).FindStandingOut(
      maximum, side, HeightShare * surroundings.GetTolerance(), step);
    SetStates(standingOut, lms3dBeamStates::Speckle, states);
    groups.insert(groups.end(), standingOut.begin(), standingOut.end());
  }
  std::vector<Filling> fillings = this->Fill(states, surroundings, groups);
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    if (!IsOff(states, surroundings, groups[i], fillings[i].Ranges))
    {
      fillings[i] = {};
    }
  }
  int number = 0;
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    if (!fillings[i].Ranges.empty())
    {
      this->Append(states, groups[i], fillings[i], number++, this->SpeckleBeams);
    }
    else
    {
      SetStates({ groups[i] }, lms3dBeamStates::Returned, states);
    }
  }
}
