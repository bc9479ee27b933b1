// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/lms3dSurfaceSamples.h"

#include "Geometry/lms3dTriangleDistance.h"

#include <cmath>
#include <utility>

namespace
{
double GetArea(const lms3dTriangleMesh& mesh, std::size_t triangle)
{
  const lms3dVector normal = lms3dGetWeightedNormal(lms3dGetCorners(mesh, triangle));
  return 0.5 * std::hypot(normal[0], normal[1], normal[2]);
}

// The plastic number solves x^3 = x + 1. These are its inverse and the square of its inverse.
constexpr double Steps[2] = { 0.7548776662466927, 0.5698402909980532 };

double GetFraction(double x)
{
  return x - std::floor(x);
}

// Returns the point of a triangle that belongs to a number of the low-discrepancy sequence.
lms3dVector GetPoint(const lms3dCorners& corners, std::size_t number)
{
  double u = GetFraction(0.5 + number * Steps[0]);
  double v = GetFraction(0.5 + number * Steps[1]);
  if (u + v > 1.0)
  {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  lms3dVector point;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double a = corners[0][axis];
    point[axis] = a + u * (corners[1][axis] - a) + v * (corners[2][axis] - a);
  }
  return point;
}
} // namespace

double lms3dGetArea(const lms3dTriangleMesh& mesh)
{
  double area = 0.0;
  for (std::size_t triangle = 0; triangle < mesh.GetNumberOfTriangles(); ++triangle)
  {
    area += GetArea(mesh, triangle);
  }
  return area;
}

void lms3dDropTrianglesWithoutArea(lms3dTriangleMesh& mesh)
{
  lms3dTriangleMesh kept;
  for (std::size_t triangle = 0; triangle < mesh.GetNumberOfTriangles(); ++triangle)
  {
    if (GetArea(mesh, triangle) > 0.0)
    {
      kept.Triangles.push_back(mesh.Triangles[triangle]);
      kept.Cells.push_back(mesh.GetCell(triangle));
    }
  }
  mesh.Triangles = std::move(kept.Triangles);
  mesh.Cells = std::move(kept.Cells);
}

lms3dSurfaceSamples::lms3dSurfaceSamples(const lms3dTriangleMesh& mesh, std::int64_t count)
  : Points(count)
  , Triangles(count)
{
  const double share = lms3dGetArea(mesh) / static_cast<double>(count);
  const std::size_t last = mesh.GetNumberOfTriangles() - 1;
  std::size_t triangle = 0;
  double end = GetArea(mesh, 0);
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    while ((static_cast<double>(i) + 0.5) * share > end && triangle < last)
    {
      end += GetArea(mesh, ++triangle);
    }
    this->Triangles[i] = static_cast<std::uint32_t>(triangle);
    this->Points[i] = GetPoint(lms3dGetCorners(mesh, triangle), i);
  }
}
