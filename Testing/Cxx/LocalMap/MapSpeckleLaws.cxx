// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapJudge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace
{
using Beam = ScanGrid::Beam;

// The returns that are certainly connected to one, at most `maximum` and one more: neighbours,
// diagonals included, whose ranges differ by at most DepthStep.
std::size_t CountConnected(const MapCase& map, vtkIdType first, std::size_t maximum)
{
  std::set<vtkIdType> found = { first };
  std::vector<vtkIdType> waiting = { first };
  while (!waiting.empty() && found.size() <= maximum)
  {
    const vtkIdType number = waiting.back();
    waiting.pop_back();
    const Beam beam = map.Grid.GetBeam(number);
    for (int i = 0; i < 9; ++i)
    {
      const Beam next = { beam.Turn + i / 3 - 1, beam.Number + i % 3 - 1 };
      const vtkIdType other =
        map.Grid.Contains(next) ? map.Grid.GetReturn(next) : ScanGrid::NoReturn;
      if (other != ScanGrid::NoReturn &&
        std::abs(map.Grid.GetRange(number) - map.Grid.GetRange(other)) <= map.Promise.DepthStep &&
        found.insert(other).second)
      {
        waiting.push_back(other);
      }
    }
  }
  return found.size();
}
} // namespace

void JudgeSpeckles(const MapCase& map, const std::vector<vtkIdType>& leftOut, MapVerdict& verdict)
{
  const std::set<int> named = GetFieldNumbers(map.Map, "SpeckleBeamIds");
  const auto maximum = static_cast<std::size_t>(map.Promise.MaximumSpeckleSize);
  for (int id : named)
  {
    const Beam beam = { id / map.Grid.GetNumberOfBeams(), id % map.Grid.GetNumberOfBeams() };
    const vtkIdType number = map.Grid.GetReturn(beam);
    if (number == ScanGrid::NoReturn || CountConnected(map, number, maximum) > maximum)
    {
      verdict.Add("speckle",
        map.Grid.Describe(beam) + " has no return, or more than " + std::to_string(maximum) +
          " returns are connected to it");
    }
  }
  const auto isNamed = [&](vtkIdType number)
  {
    const Beam beam = map.Grid.GetBeam(number);
    return named.count(beam.Turn * map.Grid.GetNumberOfBeams() + beam.Number) > 0;
  };
  const std::set<int> counted = GetFieldNumbers(map.Map, "NumberOfReturnsOnSpeckles");
  if (!std::all_of(leftOut.begin(), leftOut.end(), isNamed) ||
    (counted.empty() ? 0 : *counted.begin()) != static_cast<int>(named.size()))
  {
    verdict.Add("speckle",
      std::to_string(leftOut.size()) + " returns are left out, " + std::to_string(named.size()) +
        " are named, and another number is counted");
  }
}
