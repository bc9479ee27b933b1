// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/SeamFixtures.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
constexpr double Pi = 3.14159265358979323846;
// Metres: how far the samples of a border are from one another.
constexpr double Step = 0.02;

/// Vertices that are nearer to one another than this are one, metres.
constexpr double SameVertex = 1e-6;

using Region = std::vector<TriangleTree::Triangle>;

/// A fused map with the triangles of each region.
struct RegionsOfMap
{
  explicit RegionsOfMap(vtkPolyData* map)
    : Points(static_cast<std::size_t>(map->GetNumberOfPoints()))
  {
    for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
    {
      map->GetPoint(i, this->Points[i].data());
    }
    vtkDataArray* const numbers = map->GetCellData()->GetArray("RegionId");
    vtkNew<vtkIdList> ids;
    for (vtkIdType i = 0; i < map->GetNumberOfPolys(); ++i)
    {
      map->GetPolys()->GetCellAtId(i, ids);
      this->Regions[static_cast<int>(numbers->GetTuple1(i))].push_back(
        { ids->GetId(0), ids->GetId(1), ids->GetId(2) });
    }
  }

  /// The triangles of all regions but one.
  TriangleTree GetOthers(int number) const
  {
    std::vector<TriangleTree::Triangle> triangles;
    for (const auto& [other, region] : this->Regions)
    {
      if (other != number)
      {
        triangles.insert(triangles.end(), region.begin(), region.end());
      }
    }
    return { this->Points, triangles };
  }

  std::vector<Vector> Points;
  std::map<int, Region> Regions;
};

using Edge = std::pair<Vector, Vector>;

/// The edges of the triangles of a region, from the first point to the second one, with the third
/// corner.
std::map<Edge, Vector> FindEdges(const RegionsOfMap& map, const Region& region)
{
  std::map<Edge, Vector> edges;
  for (const TriangleTree::Triangle& triangle : region)
  {
    for (int i = 0; i < 3; ++i)
    {
      edges[{ map.Points[triangle[i]], map.Points[triangle[(i + 1) % 3]] }] =
        map.Points[triangle[(i + 2) % 3]];
    }
  }
  return edges;
}

/// The direction away from a triangle across an edge.
Vector GetOutwards(const Edge& edge, const Vector& third)
{
  const Vector way = lms3dNormalize(lms3dSubtract(edge.second, edge.first));
  const Vector inwards = lms3dSubtract(third, edge.first);
  return lms3dNormalize(lms3dSubtract(lms3dScale(way, Dot(inwards, way)), inwards));
}

} // namespace

Seams FindSeams(vtkPolyData* fused, vtkPolyData* scene, double bound)
{
  const TriangleTree surface = MakeTree(scene, { 0.0, 0.0, 0.0 });
  const RegionsOfMap map(fused);
  const TriangleTree all = map.GetOthers(-1);
  Seams seams;
  for (const auto& [number, region] : map.Regions)
  {
    const TriangleTree others = map.GetOthers(number);
    const std::map<Edge, Vector> edges = FindEdges(map, region);
    for (const auto& [edge, third] : edges)
    {
      if (edges.count({ edge.second, edge.first }) > 0)
      {
        continue;
      }
      const Vector way = lms3dSubtract(edge.second, edge.first);
      const Vector ahead = lms3dScale(GetOutwards(edge, third), 2.0 * bound);
      const int steps = 2 + static_cast<int>(lms3dGetLength(way) / Step);
      for (int i = 0; i <= steps; ++i)
      {
        const Vector point = lms3dAdd(edge.first, lms3dScale(way, static_cast<double>(i) / steps));
        if (surface.GetDistance(point) > bound)
        {
          continue;
        }
        const double distance = others.GetDistance(point, 1.0);
        const bool isOpen = distance > bound && all.GetDistance(lms3dAdd(point, ahead)) > bound;
        ++seams.Samples;
        seams.Open += isOpen ? 1 : 0;
        seams.Loose += distance > 0.1 * bound ? 1 : 0;
      }
    }
  }
  return seams;
}

double CountSheetsAround(vtkPolyData* fused, const Vector& place)
{
  const TriangleTree tree = MakeTree(fused, { place[0], place[1], place[2] });
  double angle = 0.0;
  for (std::size_t i = 0; i < tree.GetNumberOfTriangles(); ++i)
  {
    const auto [a, b, c] = tree.GetCorners(i);
    const double la = lms3dGetLength(a);
    const double lb = lms3dGetLength(b);
    const double lc = lms3dGetLength(c);
    angle += 2.0 *
      std::atan2(
        Dot(a, Cross(b, c)), la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb);
  }
  return std::abs(angle) / (4.0 * Pi);
}

JoinedMap::JoinedMap(vtkPolyData* map)
{
  const TriangleTree tree = MakeTree(map, { 0.0, 0.0, 0.0 });
  for (std::size_t i = 0; i < tree.GetNumberOfTriangles(); ++i)
  {
    std::array<int, 3> numbers = {};
    const std::array<Vector, 3> corners = tree.GetCorners(i);
    std::transform(corners.begin(), corners.end(), numbers.begin(),
      [this](const Vector& corner) { return this->Find(corner); });
    this->Triangles.push_back(numbers);
  }
  for (const std::array<int, 3>& triangle : this->Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->AddEdge(triangle[i], triangle[(i + 1) % 3]);
    }
  }
}

int JoinedMap::GetEulerNumber() const
{
  return static_cast<int>(this->Vertices.size()) - static_cast<int>(this->Edges.size()) +
    static_cast<int>(this->Triangles.size());
}

int JoinedMap::CountOpenEdges() const
{
  return static_cast<int>(std::count_if(this->Edges.begin(), this->Edges.end(),
    [](const auto& edge) {
      return edge.second != std::array<int, 2>{ 1, 1 };
    }));
}

int JoinedMap::Find(const Vector& point)
{
  const auto place = std::find_if(this->Vertices.begin(), this->Vertices.end(),
    [&](const Vector& vertex)
    { return lms3dGetLength(lms3dSubtract(vertex, point)) < SameVertex; });
  if (place == this->Vertices.end())
  {
    this->Vertices.push_back(point);
    return static_cast<int>(this->Vertices.size()) - 1;
  }
  return static_cast<int>(place - this->Vertices.begin());
}

void JoinedMap::AddEdge(int from, int to)
{
  const Vector way = lms3dSubtract(this->Vertices[to], this->Vertices[from]);
  std::map<double, int> along;
  for (std::size_t i = 0; i < this->Vertices.size(); ++i)
  {
    if (GetDistance(this->Vertices[i], this->Vertices[from], this->Vertices[to]) < SameVertex)
    {
      along[Dot(way, lms3dSubtract(this->Vertices[i], this->Vertices[from]))] = static_cast<int>(i);
    }
  }
  for (auto place = along.begin(); std::next(place) != along.end(); ++place)
  {
    const int a = place->second;
    const int b = std::next(place)->second;
    ++this->Edges[std::minmax(a, b)][a < b ? 0 : 1];
  }
}
