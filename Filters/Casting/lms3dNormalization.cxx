// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dNormalization.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// The minimum distance from the scene's centre at which the ray offset begins, in diagonals.
constexpr double MinimumOriginDistance = 2.0;

// Relative margins for the rounding of the cone, and for that of coordinates at a large offset.
constexpr double ConeMargin = 1e-9;
constexpr double RoundingMargin = 1e-15;

// The share of the scene's diagonal by which boxes are enlarged. The single precision of vertices,
// ray origins, directions and traversal errs by less than 1e-6 of the diagonal together.
constexpr float BoxMargin = 4e-6f;

// Enough for the preparations of a task to cost little.
constexpr std::size_t TrianglesOfTask = 4096;

struct Bounds
{
  void Add(const std::array<double, 3>& low, const std::array<double, 3>& high)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Low[i] = std::min(this->Low[i], low[i]);
      this->High[i] = std::max(this->High[i], high[i]);
    }
  }

  std::array<double, 3> Low = { Infinity, Infinity, Infinity };
  std::array<double, 3> High = { -Infinity, -Infinity, -Infinity };
};

// The tasks, and the order of their results, do not depend on the threads.
Bounds FindBounds(const lms3dTriangleMesh& mesh, const std::vector<std::uint32_t>& excluded)
{
  return tbb::parallel_deterministic_reduce(
    tbb::blocked_range<std::size_t>(0, mesh.GetNumberOfTriangles(), TrianglesOfTask), Bounds(),
    [&](const tbb::blocked_range<std::size_t>& range, Bounds bounds)
    {
      auto skipped = std::lower_bound(excluded.begin(), excluded.end(), range.begin());
      for (std::size_t triangle = range.begin(); triangle < range.end(); ++triangle)
      {
        if (skipped != excluded.end() && *skipped == triangle)
        {
          ++skipped;
          continue;
        }
        for (std::uint32_t corner : mesh.Triangles[triangle])
        {
          bounds.Add(mesh.Points[corner], mesh.Points[corner]);
        }
      }
      return bounds;
    },
    [](Bounds a, const Bounds& b)
    {
      a.Add(b.Low, b.High);
      return a;
    });
}
} // namespace

lms3dNormalizedBox lms3dJoin(const lms3dNormalizedBox& a, const lms3dNormalizedBox& b)
{
  lms3dNormalizedBox both;
  for (int axis = 0; axis < 3; ++axis)
  {
    both.Low[axis] = std::min(a.Low[axis], b.Low[axis]);
    both.High[axis] = std::max(a.High[axis], b.High[axis]);
  }
  return both;
}

lms3dNormalization::lms3dNormalization(
  const lms3dTriangleMesh& mesh, const std::vector<std::uint32_t>& excluded)
{
  const Bounds bounds = FindBounds(mesh, excluded);
  for (int i = 0; i < 3; ++i)
  {
    this->Center[i] = 0.5 * bounds.Low[i] + 0.5 * bounds.High[i];
  }
  const double diagonal = std::hypot(
    bounds.High[0] - bounds.Low[0], bounds.High[1] - bounds.Low[1], bounds.High[2] - bounds.Low[2]);
  this->Diagonal = diagonal > 0.0 ? diagonal : 1.0;
}

lms3dNormalizedBox lms3dNormalization::GetBox(const lms3dCorners& corners) const
{
  lms3dNormalizedBox box;
  for (int axis = 0; axis < 3; ++axis)
  {
    double x[3];
    for (int corner = 0; corner < 3; ++corner)
    {
      x[corner] = this->NormalizeCoordinate(corners[corner], axis);
    }
    box.Low[axis] = static_cast<float>(std::min({ x[0], x[1], x[2] })) - BoxMargin;
    box.High[axis] = static_cast<float>(std::max({ x[0], x[1], x[2] })) + BoxMargin;
  }
  return box;
}

lms3dCone lms3dNormalization::GetCone(const double origin[3]) const
{
  lms3dCone cone;
  double rounding = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    cone.Axis[i] = this->Center[i] - origin[i];
    rounding += std::abs(this->Center[i]) + std::abs(origin[i]);
  }
  const double radius = 0.5 * this->Diagonal * (1.0 + ConeMargin) + RoundingMargin * rounding;
  const double distance = std::hypot(cone.Axis[0], cone.Axis[1], cone.Axis[2]);
  const double tangent = std::sqrt(std::max(0.0, distance - radius) * (distance + radius));
  cone.Minimum = distance > radius ? tangent * (1.0 - ConeMargin) : -Infinity;
  return cone;
}

double lms3dNormalization::GetRayOffset(const double origin[3]) const
{
  const double distance = std::hypot(
    origin[0] - this->Center[0], origin[1] - this->Center[1], origin[2] - this->Center[2]);
  return std::max(0.0, distance - MinimumOriginDistance * this->Diagonal);
}
