// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VisibleScene.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <utility>

namespace
{
// Metres: points farther from a plane do not lie in it.
constexpr double PlaneTolerance = 1e-6;
// The sine of the largest angle between successive edges of a straight border.
constexpr double SmallestSine = 1e-9;

using Point = std::array<double, 3>;
using Edge = std::pair<int, int>;

Point Subtract(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Point Cross(const Point& a, const Point& b)
{
  Point cross;
  vtkMath::Cross(a.data(), b.data(), cross.data());
  return cross;
}
} // namespace

VisibleScene::VisibleScene(vtkPolyData* scene)
{
  std::map<Point, int> numbers;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < scene->GetNumberOfCells(); ++cell)
  {
    scene->GetCellPoints(cell, ids);
    if (ids->GetNumberOfIds() != 3)
    {
      throw std::runtime_error("a cell of the scene is not a triangle");
    }
    Corners corners = {};
    for (int i = 0; i < 3; ++i)
    {
      Point point;
      scene->GetPoint(ids->GetId(i), point.data());
      const auto [place, isNew] = numbers.try_emplace(point, static_cast<int>(this->Points.size()));
      if (isNew)
      {
        this->Points.push_back(point);
      }
      corners[i] = place->second;
    }
    this->Triangles.push_back(corners);
  }
  this->IsHit.resize(this->Triangles.size());
}

void VisibleScene::Add(vtkPolyData* scan)
{
  vtkDataArray* const cells = scan->GetPointData()->GetArray("CellId");
  for (vtkIdType i = 0; i < cells->GetNumberOfTuples(); ++i)
  {
    this->IsHit[static_cast<std::size_t>(cells->GetTuple1(i))] = true;
  }
}

bool VisibleScene::AreInOnePlane(int a, int b) const
{
  const Corners& corners = this->Triangles[a];
  Point normal = Cross(Subtract(this->Points[corners[1]], this->Points[corners[0]]),
    Subtract(this->Points[corners[2]], this->Points[corners[0]]));
  vtkMath::Normalize(normal.data());
  return std::all_of(this->Triangles[b].begin(), this->Triangles[b].end(),
    [&](int corner)
    {
      const Point way = Subtract(this->Points[corner], this->Points[corners[0]]);
      return std::abs(vtkMath::Dot(way.data(), normal.data())) <= PlaneTolerance;
    });
}

// Returns the number of the polygon of each triangle that was hit, -1 for others.
std::vector<int> VisibleScene::FindPolygons() const
{
  std::vector<int> links(this->Triangles.size());
  std::iota(links.begin(), links.end(), 0);
  const auto getFirst = [&](int triangle)
  {
    while (links[triangle] != triangle)
    {
      triangle = links[triangle];
    }
    return triangle;
  };
  std::map<Edge, std::vector<int>> trianglesOfEdge;
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    const auto triangle = static_cast<int>(i);
    for (int corner = 0; this->IsHit[i] && corner < 3; ++corner)
    {
      std::vector<int>& others = trianglesOfEdge[std::minmax(
        this->Triangles[i][corner], this->Triangles[i][(corner + 1) % 3])];
      for (const int other : others)
      {
        if (this->AreInOnePlane(triangle, other))
        {
          links[getFirst(triangle)] = getFirst(other);
        }
      }
      others.push_back(triangle);
    }
  }
  std::vector<int> polygons(this->Triangles.size(), -1);
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    polygons[i] = this->IsHit[i] ? getFirst(static_cast<int>(i)) : -1;
  }
  return polygons;
}

bool VisibleScene::IsStraight(int before, int at, int after) const
{
  Point a = Subtract(this->Points[at], this->Points[before]);
  Point b = Subtract(this->Points[after], this->Points[at]);
  vtkMath::Normalize(a.data());
  vtkMath::Normalize(b.data());
  const Point cross = Cross(a, b);
  return vtkMath::Norm(cross.data()) < SmallestSine;
}

// The corners of the polygon's border, less twice its Euler number, which is 1 less its holes.
vtkIdType VisibleScene::CountTrianglesOf(const std::vector<int>& polygon) const
{
  std::map<Edge, int> edges;
  std::set<int> points;
  for (const int triangle : polygon)
  {
    const Corners& corners = this->Triangles[triangle];
    points.insert(corners.begin(), corners.end());
    for (int i = 0; i < 3; ++i)
    {
      ++edges[std::minmax(corners[i], corners[(i + 1) % 3])];
    }
  }
  std::map<int, std::vector<int>> borderOfPoint;
  for (const auto& [edge, count] : edges)
  {
    if (count == 1)
    {
      borderOfPoint[edge.first].push_back(edge.second);
      borderOfPoint[edge.second].push_back(edge.first);
    }
  }
  vtkIdType corners = 0;
  for (const auto& [point, ends] : borderOfPoint)
  {
    const bool isStraight = ends.size() == 2 && this->IsStraight(ends[0], point, ends[1]);
    // Where the border touches itself, each further pass saves what a point less would save.
    corners += isStraight ? 0 : 2 - static_cast<vtkIdType>(ends.size() / 2);
  }
  const auto euler = static_cast<vtkIdType>(points.size()) - static_cast<vtkIdType>(edges.size()) +
    static_cast<vtkIdType>(polygon.size());
  return corners - 2 * euler;
}

vtkIdType VisibleScene::CountTriangles() const
{
  std::map<int, std::vector<int>> polygons;
  const std::vector<int> polygonOf = this->FindPolygons();
  for (std::size_t i = 0; i < polygonOf.size(); ++i)
  {
    if (polygonOf[i] >= 0)
    {
      polygons[polygonOf[i]].push_back(static_cast<int>(i));
    }
  }
  vtkIdType sum = 0;
  for (const auto& [first, triangles] : polygons)
  {
    sum += this->CountTrianglesOf(triangles);
  }
  return sum;
}
