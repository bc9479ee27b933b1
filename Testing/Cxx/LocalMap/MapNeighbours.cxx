// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapNeighbours.h"

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace
{
using Beam = ScanGrid::Beam;
using Place = ScanGrid::Place;

/// Corners in the order around the cell.
std::array<Beam, 4> GetCorners(const Beam& lowest)
{
  const auto [turn, number] = lowest;
  return { { { turn, number }, { turn + 1, number }, { turn + 1, number + 1 },
    { turn, number + 1 } } };
}

bool IsInTetrahedron(const Vector& point, const std::array<Vector, 4>& corners)
{
  const auto getVolume = [](const Vector& a, const Vector& b, const Vector& c, const Vector& d)
  { return Dot(b - a, Cross(c - a, d - a)); };
  const auto& [a, b, c, d] = corners;
  const double whole = getVolume(a, b, c, d);
  return whole != 0.0 && getVolume(point, b, c, d) / whole >= 0.0 &&
    getVolume(a, point, c, d) / whole >= 0.0 && getVolume(a, b, point, d) / whole >= 0.0 &&
    getVolume(a, b, c, point) / whole >= 0.0;
}

std::unique_ptr<TriangleTree> MakeTree(vtkPolyData* scene, const Vector& origin)
{
  std::vector<Vector> points(scene->GetNumberOfPoints());
  for (vtkIdType i = 0; i < scene->GetNumberOfPoints(); ++i)
  {
    scene->GetPoint(i, points[i].data());
    points[i] = points[i] - origin;
  }
  std::vector<TriangleTree::Triangle> triangles;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < scene->GetNumberOfCells(); ++cell)
  {
    scene->GetCellPoints(cell, corners);
    triangles.push_back({ corners->GetId(0), corners->GetId(1), corners->GetId(2) });
  }
  return std::make_unique<TriangleTree>(std::move(points), std::move(triangles));
}
} // namespace

MapNeighbours::MapNeighbours(const MapCase& map, const MapCase* ideal)
  : MapNeighbours(map)
{
  this->Ideal = ideal ? std::make_unique<const MapNeighbours>(*ideal) : nullptr;
}

MapNeighbours::MapNeighbours(const MapCase& map)
  : Map(map)
  , Bound(map.Promise.MaximumError + map.Promise.Noise)
{
  if (map.Promise.Scene)
  {
    this->Scene = MakeTree(map.Promise.Scene, map.Grid.GetSensor());
  }
  for (const TriangleTree::Triangle& triangle : map.Triangles)
  {
    for (vtkIdType corner : triangle)
    {
      this->Vertices.insert(map.Points[corner]);
    }
  }
}

bool MapNeighbours::IsAtScene(const Vector& point, double cells) const
{
  const double limit = this->Bound + MapCase::GetRounding(GetLength(point)) +
    cells * GetLength(point) *
      std::hypot(this->Map.Grid.GetFanStep(), this->Map.Grid.GetTurnStep());
  return this->Scene && this->Scene->GetDistance(point, 2.0 * limit) <= limit;
}

bool MapNeighbours::IsBeside(const Vector& point, const Beam& beam) const
{
  const double size = this->Map.Grid.GetCellSize(beam);
  const std::vector<vtkIdType> returns = this->Map.Grid.GetReturns(beam);
  return std::any_of(returns.begin(), returns.end(),
    [&](vtkIdType number)
    {
      const double range = this->Map.Grid.GetRange(number);
      return GetLength(point - this->Map.Grid.GetPoints()[number]) <=
        this->Bound + 0.5 * range * size + MapCase::GetRounding(range);
    });
}

bool MapNeighbours::IsInPlaneOf(const Vector& point, const Beam& beam) const
{
  const vtkIdType number = this->Map.Grid.GetReturn(beam);
  if (!this->Scene || number == ScanGrid::NoReturn)
  {
    return false;
  }
  const auto [a, b, c] = this->Scene->GetCorners(this->Map.Grid.GetCellId(number));
  const Vector normal = Normalize(Cross(b - a, c - a));
  return std::abs(Dot(normal, point - a)) <=
    2.0 * this->Bound + MapCase::GetRounding(GetLength(point));
}

// Where the ray through a point meets the scene, or the point itself.
Vector MapNeighbours::GetSceneBehind(const Vector& point) const
{
  std::vector<TriangleTree::Hit> hits;
  if (this->Scene)
  {
    this->Scene->Cast(Normalize(point), BeamMargin, hits);
  }
  const auto nearest = std::min_element(hits.begin(), hits.end(),
    [](const TriangleTree::Hit& p, const TriangleTree::Hit& q) { return p.Range < q.Range; });
  return nearest == hits.end() ? point : nearest->Range / GetLength(point) * point;
}

// What three joined corners span, and what is no farther from the scene than that, before it or
// behind it.
bool MapNeighbours::IsSpannedBy(const Vector& point, const Vector& behind, const Beam& lowest) const
{
  const std::array<Beam, 4> corners = GetCorners(lowest);
  std::array<Vector, 4> returns;
  std::array<bool, 4> isJoinedToNext;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Beam& next = corners[(i + 1) % 4];
    const vtkIdType number = this->Map.Grid.GetReturn(corners[i]);
    isJoinedToNext[i] = number != ScanGrid::NoReturn &&
      this->Map.Grid.GetReturn(next) != ScanGrid::NoReturn &&
      !this->Map.Steps.AreApart(corners[i], next);
    returns[i] = number == ScanGrid::NoReturn ? Vector{} : this->Map.Grid.GetPoints()[number];
  }
  const double limit = this->Bound + MapCase::GetRounding(GetLength(point));
  const Vector mirrored = 2.0 * behind - point;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const std::size_t before = (i + 3) % 4;
    const std::array<Vector, 3> triangle = { returns[before], returns[i], returns[(i + 1) % 4] };
    if (isJoinedToNext[before] && isJoinedToNext[i] &&
      (GetDistance(point, triangle) <= limit ||
        IsInTetrahedron(point, { triangle[0], triangle[1], triangle[2], behind }) ||
        IsInTetrahedron(mirrored, { triangle[0], triangle[1], triangle[2], behind })))
    {
      return true;
    }
  }
  return std::count(isJoinedToNext.begin(), isJoinedToNext.end(), true) == 4 &&
    IsInTetrahedron(point, returns);
}

bool MapNeighbours::IsSpannedAround(const Vector& point, const Place& place) const
{
  const Vector behind = this->GetSceneBehind(point);
  for (const Beam& beam :
    this->Map.Grid.GetBeamsAround({ place.Turn - 0.5, place.Number - 0.5 }, 0.5))
  {
    if (this->IsSpannedBy(point, behind, beam))
    {
      return true;
    }
  }
  return false;
}

bool MapNeighbours::ExplainOnBeam(const Vector& point, const Beam& beam) const
{
  return this->ExplainOnBeamAlone(point, beam) ||
    (this->Ideal && this->Ideal->ExplainOnBeamAlone(point, beam));
}

// Does it without the scan without errors.
bool MapNeighbours::ExplainOnBeamAlone(const Vector& point, const Beam& beam) const
{
  const double limit = this->Bound + MapCase::GetRounding(GetLength(point));
  const std::vector<vtkIdType> returns = this->Map.Grid.GetReturns(beam);
  return std::any_of(returns.begin(), returns.end(),
           [&](vtkIdType number)
           { return GetLength(point - this->Map.Grid.GetPoints()[number]) <= limit; }) ||
    this->IsAtScene(point, 0.0) ||
    this->IsSpannedAround(point, { 1.0 * beam.Turn, 1.0 * beam.Number });
}

// Whether a beam's return and neighbours on its surface, one along the fan and one along the turn,
// lie in the triangle's plane.
bool MapNeighbours::IsSupportedBy(const std::array<Vector, 3>& triangle, const Beam& beam) const
{
  const Vector& a = triangle[0];
  const Vector normal = Normalize(Cross(triangle[1] - a, triangle[2] - a));
  const auto isInPlane = [&](const Beam& other)
  {
    const vtkIdType number = this->Map.Grid.GetReturn(other);
    return number != ScanGrid::NoReturn &&
      std::abs(Dot(normal, this->Map.Grid.GetPoints()[number] - a)) <=
      2.0 * this->Bound + MapCase::GetRounding(GetLength(a));
  };
  const auto isSurface = [&](const Beam& other)
  { return this->Map.Steps.AreJoined(beam, other) && isInPlane(other); };
  const auto [turn, number] = beam;
  return isInPlane(beam) && (isSurface({ turn - 1, number }) || isSurface({ turn + 1, number })) &&
    (isSurface({ turn, number - 1 }) || isSurface({ turn, number + 1 }));
}

bool MapNeighbours::ExplainBetween(
  const Vector& point, const Place& place, const std::array<Vector, 3>& triangle) const
{
  return this->ExplainBetweenAlone(point, place, triangle) ||
    (this->Ideal && this->Ideal->ExplainBetweenAlone(point, place, triangle));
}

bool MapNeighbours::ExplainBetweenAlone(
  const Vector& point, const Place& place, const std::array<Vector, 3>& triangle) const
{
  const std::vector<Beam> around = this->Map.Grid.GetBeamsAround(place, 1.0);
  return std::any_of(around.begin(), around.end(),
           [&](const Beam& beam)
           {
             return this->IsBeside(point, beam) || this->IsInPlaneOf(point, beam) ||
               this->IsSupportedBy(triangle, beam);
           }) ||
    this->IsAtScene(point, 0.5) || this->IsSpannedAround(point, place);
}

bool MapNeighbours::AreJoined(const Place& place) const
{
  const std::vector<Beam> around = this->Map.Grid.GetBeamsAround(place, 1.0);
  return std::all_of(around.begin(), around.end(),
    [&](const Beam& beam)
    {
      const auto isIn = [&](const Beam& other)
      {
        return std::any_of(around.begin(), around.end(),
          [&](const Beam& one) { return one.Turn == other.Turn && one.Number == other.Number; });
      };
      const Beam inFan = { beam.Turn, beam.Number + 1 };
      const Beam inTurn = { beam.Turn + 1, beam.Number };
      return this->Map.Grid.GetReturn(beam) != ScanGrid::NoReturn && !this->Map.IsSpeckle(beam) &&
        (!isIn(inFan) || this->Map.Steps.AreJoined(beam, inFan)) &&
        (!isIn(inTurn) || this->Map.Steps.AreJoined(beam, inTurn));
    });
}
