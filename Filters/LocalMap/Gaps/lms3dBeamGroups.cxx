// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Gaps/lms3dBeamGroups.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace
{
// The positions of the previous turn and of the previous beam among the neighbours.
constexpr std::array<int, 4> Previous = { 0, 2, 4, 5 };
} // namespace

// `forEachNeighbor(place, visit)` calls visit(neighbour) for the neighbours in the same group.
template <typename Visitor>
lms3dBeamGroups::Groups lms3dBeamGroups::FindFrom(
  const std::vector<int>& seeds, int maximumSize, const Visitor& forEachNeighbor)
{
  Groups groups;
  std::vector<int> group;
  this->Marks.assign(this->States.GetSize(), New);
  for (int beam = 0; beam < this->States.GetNumberOfBeams(); ++beam)
  {
    if (this->States.IsPole(beam))
    {
      this->Marks[beam] = InLargeGroup;
    }
  }
  for (int seed : seeds)
  {
    if (this->Marks[seed] == New && this->Flood(seed, maximumSize, forEachNeighbor, group))
    {
      groups.push_back(group);
    }
  }
  return groups;
}

// Returns false if the group is too large. Then its beams are marked, which stops later floods.
template <typename Visitor>
bool lms3dBeamGroups::Flood(
  int seed, int maximumSize, const Visitor& forEachNeighbor, std::vector<int>& group)
{
  bool isLarge = false;
  group.assign(1, seed);
  this->Marks[seed] = InSmallGroup;
  for (std::size_t i = 0; i < group.size() && !isLarge; ++i)
  {
    forEachNeighbor(group[i],
      [&](int neighbor)
      {
        isLarge = isLarge || this->Marks[neighbor] == InLargeGroup;
        if (this->Marks[neighbor] == New)
        {
          this->Marks[neighbor] = InSmallGroup;
          group.push_back(neighbor);
        }
      });
    isLarge = isLarge || static_cast<int>(group.size()) > maximumSize;
  }
  for (std::size_t i = 0; isLarge && i < group.size(); ++i)
  {
    this->Marks[group[i]] = InLargeGroup;
  }
  return !isLarge;
}

lms3dBeamGroups::Groups lms3dBeamGroups::FindMissing(int maximumSize)
{
  std::vector<int> seeds;
  for (int place = 0; place < this->States.GetSize(); ++place)
  {
    if (this->States.GetState(place) == lms3dBeamStates::Missing)
    {
      seeds.push_back(place);
    }
  }
  return this->FindFrom(seeds, maximumSize,
    [this](int place, const auto& visit)
    {
      const std::array<int, 8> neighbors = this->States.GetNeighbors(place);
      for (int i = 0; i < StraightNeighbors; ++i)
      {
        if (this->States.GetState(neighbors[i]) == lms3dBeamStates::Missing)
        {
          visit(neighbors[i]);
        }
      }
    });
}

lms3dBeamGroups::Groups lms3dBeamGroups::FindAtOneDepth(int maximumSize, const lms3dDepthStep& step)
{
  const std::vector<int> seeds =
    this->FindInTurns([&](int turn) { return this->FindFirstOfTurn(turn, step); });
  return this->FindFrom(seeds, maximumSize,
    [&](int place, const auto& visit) { this->ForEachAtOneDepth(place, step, visit); });
}

lms3dBeamGroups::Groups lms3dBeamGroups::FindStandingOut(
  int maximumSize, Side side, double height, const lms3dDepthStep& step)
{
  const std::vector<int> seeds = this->FindInTurns(
    [&](int turn) { return this->FindStandingOutOfTurn(turn, side, height, step); });
  return this->FindFrom(seeds, maximumSize,
    [&](int place, const auto& visit)
    {
      this->ForEachNear(place,
        [&](int near)
        {
          if (std::binary_search(seeds.begin(), seeds.end(), near))
          {
            visit(near);
          }
        });
    });
}

// All places that `findInTurn(turn)` returns, turn by turn.
template <typename Finder>
std::vector<int> lms3dBeamGroups::FindInTurns(const Finder& findInTurn) const
{
  std::vector<std::vector<int>> ofTurns(this->States.GetNumberOfTurns());
  tbb::parallel_for(
    0, this->States.GetNumberOfTurns(), [&](int turn) { ofTurns[turn] = findInTurn(turn); });
  std::vector<int> all;
  for (const std::vector<int>& ofTurn : ofTurns)
  {
    all.insert(all.end(), ofTurn.begin(), ofTurn.end());
  }
  return all;
}

// Each group that does not reach around the whole circle has a return with no other before it.
std::vector<int> lms3dBeamGroups::FindFirstOfTurn(int turn, const lms3dDepthStep& step) const
{
  std::vector<int> first;
  const double* const ranges = this->States.GetRanges(turn);
  const int start = turn * this->States.GetNumberOfBeams();
  for (int beam = 0; beam < this->States.GetNumberOfBeams(); ++beam)
  {
    // Decides for most beams, and is quick.
    const bool isAfter = beam > 0 && step.AreRangesEqual(ranges[beam], ranges[beam - 1]);
    const int place = start + beam;
    if (!isAfter && this->States.GetState(place) == lms3dBeamStates::Returned &&
      !this->States.IsPole(place) && this->MayBeFirst(place, step))
    {
      first.push_back(place);
    }
  }
  return first;
}

bool lms3dBeamGroups::MayBeFirst(int place, const lms3dDepthStep& step) const
{
  const double range = this->States.GetRange(place);
  const std::array<int, 8> neighbors = this->States.GetNeighbors(place);
  return std::none_of(Previous.begin(), Previous.end(),
    [&](int i)
    {
      return neighbors[i] != lms3dBeamStates::NoPlace &&
        step.AreRangesEqual(range, this->States.GetRange(neighbors[i]));
    });
}

template <typename Visitor>
void lms3dBeamGroups::ForEachAtOneDepth(
  int place, const lms3dDepthStep& step, const Visitor& visit) const
{
  const double range = this->States.GetRange(place);
  this->ForEachNear(place,
    [&](int near)
    {
      if (step.AreRangesEqual(range, this->States.GetRange(near)))
      {
        visit(near);
      }
    });
}

// Calls visit(near) for each return beside a place or on the other side of a missing beam.
template <typename Visitor>
void lms3dBeamGroups::ForEachNear(int place, const Visitor& visit) const
{
  const auto look = [&](int near)
  {
    if (this->States.GetState(near) == lms3dBeamStates::Returned && near != place)
    {
      visit(near);
    }
  };
  for (int neighbor : this->States.GetNeighbors(place))
  {
    look(neighbor);
    if (this->States.GetState(neighbor) == lms3dBeamStates::Missing)
    {
      for (int beyond : this->States.GetNeighbors(neighbor))
      {
        look(beyond);
      }
    }
  }
}
