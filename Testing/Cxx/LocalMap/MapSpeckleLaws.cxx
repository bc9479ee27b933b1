// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapJudge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace
{
using Beam = ScanGrid::Beam;

// The return of a beam; none if the beam is not in the grid.
vtkIdType GetReturn(const MapCase& map, const Beam& beam)
{
  return map.Grid.Contains(beam) ? map.Grid.GetReturn(beam) : ScanGrid::NoReturn;
}

// Calls visit(beam, return) for a beam and its neighbours, diagonals included, if they returned.
template <typename Visitor>
void ForEachReturnNear(const MapCase& map, const Beam& beam, const Visitor& visit)
{
  for (int i = 0; i < 9; ++i)
  {
    const Beam next = { beam.Turn + i / 3 - 1, beam.Number + i % 3 - 1 };
    const vtkIdType number = GetReturn(map, next);
    if (number != ScanGrid::NoReturn)
    {
      visit(next, number);
    }
  }
}

// The returns that are certainly connected to one, at most `maximum` and one more: neighbours,
// diagonals included, whose ranges differ by at most DepthStep, and for which `counts` is true.
template <typename Filter>
std::size_t CountConnected(
  const MapCase& map, vtkIdType first, std::size_t maximum, const Filter& counts)
{
  std::set<vtkIdType> found = { first };
  std::vector<vtkIdType> waiting = { first };
  while (!waiting.empty() && found.size() <= maximum)
  {
    const vtkIdType number = waiting.back();
    waiting.pop_back();
    const double range = map.Grid.GetRange(number);
    ForEachReturnNear(map, map.Grid.GetBeam(number),
      [&](const Beam& next, vtkIdType other)
      {
        if (counts(next) && std::abs(range - map.Grid.GetRange(other)) <= map.Promise.DepthStep &&
          found.insert(other).second)
        {
          waiting.push_back(other);
        }
      });
  }
  return found.size();
}

/// A return, and the number of beams to it; a range of 0 if there is none.
struct ReturnBeside
{
  double Range = 0.0;
  double Beams = 0.0;
};

// The first return in a direction that no speckle has.
ReturnBeside FindBeside(const MapCase& map, const Beam& beam, const Beam& direction)
{
  Beam next = beam;
  for (int i = 1; i <= map.Promise.MaximumSpeckleSize + 1; ++i)
  {
    next = { next.Turn + direction.Turn, next.Number + direction.Number };
    const vtkIdType number = GetReturn(map, next);
    if (number != ScanGrid::NoReturn && !map.IsSpeckle(next))
    {
      return { map.Grid.GetRange(number), static_cast<double>(i) };
    }
  }
  return {};
}

// How far a return is nearer than the line between the returns beside its speckle, metres; 0 if
// there are none. Inverse ranges are linear along a line, nearly.
double GetHeight(const MapCase& map, const Beam& beam, const Beam& direction)
{
  const ReturnBeside after = FindBeside(map, beam, direction);
  const ReturnBeside before = FindBeside(map, beam, { -direction.Turn, -direction.Number });
  const double onLine =
    (before.Beams + after.Beams) / (before.Beams / after.Range + after.Beams / before.Range);
  return before.Range > 0.0 && after.Range > 0.0
    ? onLine - map.Grid.GetRange(map.Grid.GetReturn(beam))
    : 0.0;
}

// Whether a return lies off these lines in its fan and in its turn, on one side.
bool StandsOut(const MapCase& map, const Beam& beam)
{
  const double inFan = GetHeight(map, beam, { 0, 1 });
  const double inTurn = GetHeight(map, beam, { 1, 0 });
  const double bound = map.Promise.MaximumError;
  return std::min(inFan, inTurn) > bound || std::max(inFan, inTurn) < -bound;
}

// The returns around a speckle that has a return.
std::set<vtkIdType> FindSurroundings(const MapCase& map, const Beam& first)
{
  std::set<vtkIdType> members = { map.Grid.GetReturn(first) };
  std::vector<Beam> waiting = { first };
  std::set<vtkIdType> around;
  while (!waiting.empty())
  {
    const Beam beam = waiting.back();
    waiting.pop_back();
    ForEachReturnNear(map, beam,
      [&](const Beam& next, vtkIdType number)
      {
        if (!map.IsSpeckle(next))
        {
          around.insert(number);
        }
        else if (members.insert(number).second)
        {
          waiting.push_back(next);
        }
      });
  }
  return around;
}

// Whether returns lie on one plane within twice the bound or six standard deviations of the noise.
// On a plane, the inverse range is linear in the direction: the normal equations give the plane.
bool AreOnOnePlane(const MapCase& map, const std::set<vtkIdType>& returns)
{
  std::array<Vector, 3> matrix = {};
  Vector right = {};
  for (vtkIdType number : returns)
  {
    const Vector direction = Normalize(map.Grid.GetPoints()[number]);
    const double inverse = 1.0 / GetLength(map.Grid.GetPoints()[number]);
    for (int i = 0; i < 3; ++i)
    {
      matrix[i] = matrix[i] + direction[i] * direction;
      right[i] += inverse * direction[i];
    }
  }
  const auto& [p, q, r] = matrix;
  const double determinant = Dot(p, Cross(q, r));
  const Vector plane = { Dot(right, Cross(q, r)) / determinant,
    Dot(p, Cross(right, r)) / determinant, Dot(p, Cross(q, right)) / determinant };
  const double tolerance = std::max(2.0 * map.Promise.MaximumError, 6.0 * map.Promise.Noise);
  return std::all_of(returns.begin(), returns.end(),
    [&](vtkIdType number)
    {
      const Vector& point = map.Grid.GetPoints()[number];
      return std::abs(1.0 / Dot(plane, Normalize(point)) - GetLength(point)) <= tolerance;
    });
}

// Whether a named return may be that of a speckle: with the returns at its depth, it is a small
// group, or it stands out of them in one.
bool MayBeSpeckle(const MapCase& map, const Beam& beam)
{
  const vtkIdType number = map.Grid.GetReturn(beam);
  const auto maximum = static_cast<std::size_t>(map.Promise.MaximumSpeckleSize);
  const auto isSmall = [&](const auto& counts)
  { return CountConnected(map, number, maximum, counts) <= maximum; };
  return number != ScanGrid::NoReturn &&
    (isSmall([](const Beam&) { return true; }) ||
      (isSmall([&](const Beam& other) { return map.IsSpeckle(other); }) && StandsOut(map, beam) &&
        AreOnOnePlane(map, FindSurroundings(map, beam))));
}
} // namespace

void JudgeSpeckles(const MapCase& map, const std::vector<vtkIdType>& leftOut, MapVerdict& verdict)
{
  for (int id : map.Speckles)
  {
    const Beam beam = { id / map.Grid.GetNumberOfBeams(), id % map.Grid.GetNumberOfBeams() };
    if (!MayBeSpeckle(map, beam))
    {
      verdict.Add("speckle",
        map.Grid.Describe(beam) + " has no return, or more than " +
          std::to_string(map.Promise.MaximumSpeckleSize) +
          " returns are connected to it and it does not stand out of them");
    }
  }
  const auto isNamed = [&](vtkIdType number) { return map.IsSpeckle(map.Grid.GetBeam(number)); };
  const std::set<int> counted = GetFieldNumbers(map.Map, "NumberOfReturnsOnSpeckles");
  if (!std::all_of(leftOut.begin(), leftOut.end(), isNamed) ||
    (counted.empty() ? 0 : *counted.begin()) != static_cast<int>(map.Speckles.size()))
  {
    verdict.Add("speckle",
      std::to_string(leftOut.size()) + " returns are left out, " +
        std::to_string(map.Speckles.size()) + " are named, and another number is counted");
  }
}
