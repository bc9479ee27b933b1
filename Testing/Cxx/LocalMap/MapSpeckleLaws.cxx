// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapJudge.h"
#include "LocalMap/SpeckleSurroundings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace
{
using Beam = ScanGrid::Beam;

// The returns around a speckle are flat if they lie on a plane within this share of the bound.
constexpr double FlatShare = 0.25;

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
    const vtkIdType number = GetReturnOf(map, next);
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
        SpeckleSurroundings(map, beam).AreOnOnePlane(
          std::max(2.0 * map.Promise.MaximumError, 6.0 * map.Promise.Noise))));
}

// Whether the beam of a speckle meets surface at the plane around the speckle. True, too, if there
// is no such plane. The surface may be off by the bound where this plane is off by it to the other
// side.
bool HasSurface(const MapCase& map, const TriangleTree& surface, const Beam& beam)
{
  const SpeckleSurroundings around(map, beam);
  const double bound = map.Promise.MaximumError;
  if (!around.AreWhole() || !around.AreOnOnePlane(FlatShare * bound))
  {
    return true;
  }
  const Vector direction =
    map.Grid.GetDirection({ static_cast<double>(beam.Turn), static_cast<double>(beam.Number) });
  const double range = around.GetRange(direction);
  std::vector<TriangleTree::Hit> hits;
  surface.Cast(direction, BeamMargin, hits);
  return std::any_of(hits.begin(), hits.end(),
    [&](const TriangleTree::Hit& hit) { return std::abs(hit.Range - range) <= 2.0 * bound; });
}

void JudgeSurface(const MapCase& map, const TriangleTree& surface, MapVerdict& verdict)
{
  for (int id : map.Speckles)
  {
    const Beam beam = { id / map.Grid.GetNumberOfBeams(), id % map.Grid.GetNumberOfBeams() };
    if (GetReturnOf(map, beam) != ScanGrid::NoReturn && !HasSurface(map, surface, beam))
    {
      verdict.Add("hole", map.Grid.Describe(beam) + " is a speckle without surface behind it");
    }
  }
}
} // namespace

void JudgeSpeckles(const MapCase& map, const TriangleTree& surface,
  const std::vector<vtkIdType>& leftOut, MapVerdict& verdict)
{
  if (!map.IsPlain())
  {
    JudgeSurface(map, surface, verdict);
  }
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
