// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapJudge.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
// The smallest height of a triangle, as a share of its longest edge, at which it has an area.
constexpr double MinimumHeight = 1e-9;

// The tolerance for unit vectors in single precision.
constexpr double NormalRounding = 1e-6;

void JudgeTriangle(const MapCase& map, std::size_t number, MapVerdict& verdict)
{
  const auto [i, j, k] = map.Triangles[number];
  const Vector& a = map.Points[i];
  const Vector& b = map.Points[j];
  const Vector& c = map.Points[k];
  const Vector normal = Cross(b - a, c - a);
  const double longest = std::max({ GetLength(b - a), GetLength(c - b), GetLength(a - c) });
  const bool hasArea = GetLength(normal) > MinimumHeight * longest * longest;
  if (!hasArea || !(Dot(normal, a) < 0.0))
  {
    verdict.Add(hasArea ? "facing" : "area",
      "triangle " + std::to_string(number) + " of " + ToWords(a) + ", " + ToWords(b) + ", " +
        ToWords(c));
  }
  if (vtkDataArray* normals = map.Map->GetCellData()->GetNormals())
  {
    Vector given;
    normals->GetTuple(static_cast<vtkIdType>(number), given.data());
    if (!(GetLength(given - Normalize(normal)) <= NormalRounding))
    {
      verdict.Add("normal", "triangle " + std::to_string(number) + " has " + ToWords(given));
    }
  }
}

void JudgePoint(const MapCase& map, vtkIdType number, MapVerdict& verdict)
{
  const Vector& point = map.Points[number];
  const auto describe = [&] { return "point " + std::to_string(number) + " at " + ToWords(point); };
  const double range = GetLength(point);
  if (!std::isfinite(range) || range == 0.0)
  {
    verdict.Add("point", describe());
    return;
  }
  const double given = map.Map->GetPointData()->GetArray("Range")->GetTuple1(number);
  if (!(std::abs(given - range) <= MapCase::GetRounding(range)))
  {
    verdict.Add("range", describe() + " has the Range " + std::to_string(given));
  }
  if (vtkDataArray* normals = map.Map->GetPointData()->GetNormals())
  {
    Vector normal;
    normals->GetTuple(number, normal.data());
    if (!(std::abs(GetLength(normal) - 1.0) <= NormalRounding) ||
      !(Dot(normal, point) <= NormalRounding * range))
    {
      verdict.Add("normal", describe() + " has the normal " + ToWords(normal));
    }
  }
}

void JudgeUse(const MapCase& map, MapVerdict& verdict)
{
  std::vector<bool> isUsed(map.Points.size(), false);
  for (const TriangleTree::Triangle& triangle : map.Triangles)
  {
    for (vtkIdType corner : triangle)
    {
      isUsed[corner] = true;
    }
  }
  for (std::size_t i = 0; i < isUsed.size() && !map.IsPlain(); ++i)
  {
    if (!isUsed[i])
    {
      verdict.Add("point", "point " + std::to_string(i) + " belongs to no triangle");
    }
  }
  verdict.EulerCharacteristic = std::count(isUsed.begin(), isUsed.end(), true);
}

} // namespace

void JudgeShape(const MapCase& map, MapVerdict& verdict)
{
  vtkDataArray* ranges = map.Map->GetPointData()->GetArray("Range");
  if (!ranges || ranges->GetDataType() != VTK_DOUBLE)
  {
    verdict.Add("range", "there is no Range of float64");
    return;
  }
  if (!map.Map->GetPointData()->GetNormals() && !map.Map->GetCellData()->GetNormals())
  {
    verdict.Add("normal", "there are no Normals");
  }
  for (std::size_t i = 0; i < map.Points.size(); ++i)
  {
    JudgePoint(map, static_cast<vtkIdType>(i), verdict);
  }
  for (std::size_t i = 0; i < map.Triangles.size(); ++i)
  {
    JudgeTriangle(map, i, verdict);
  }
  JudgeUse(map, verdict);
}
