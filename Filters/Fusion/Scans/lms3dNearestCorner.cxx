// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Scans/lms3dNearestCorner.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace
{
// Length 1. Few walls are at right angles to it, so few corners of a map have one place.
constexpr lms3dVector Direction = { 0.48, 0.6, 0.64 };

lms3dVector GetCorner(const lms3dTriangleMesh& mesh, std::int32_t triangle, int number)
{
  const double* const point = mesh.GetCorner(triangle, number);
  return { point[0], point[1], point[2] };
}
} // namespace

lms3dNearestCorner::lms3dNearestCorner(const lms3dTriangleMesh& mesh)
  : Mesh(mesh)
{
  for (std::size_t i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    const auto triangle = static_cast<std::int32_t>(i);
    for (int number = 0; number < 3; ++number)
    {
      this->Corners.push_back(
        { lms3dDot(GetCorner(mesh, triangle, number), Direction), triangle, number });
    }
  }
  std::sort(this->Corners.begin(), this->Corners.end(),
    [](const Corner& a, const Corner& b) { return a.Place < b.Place; });
}

std::int32_t lms3dNearestCorner::FindTriangle(const lms3dVector& point, double distance) const
{
  const double place = lms3dDot(point, Direction);
  auto corner = std::lower_bound(this->Corners.begin(), this->Corners.end(), place - distance,
    [](const Corner& other, double first) { return other.Place < first; });
  std::pair<double, std::int32_t> nearest = { distance, -1 };
  for (; corner != this->Corners.end() && corner->Place <= place + distance; ++corner)
  {
    const lms3dVector at = GetCorner(this->Mesh, corner->Triangle, corner->Number);
    const std::pair<double, std::int32_t> found = { lms3dGetLength(lms3dSubtract(at, point)),
      corner->Triangle };
    const bool isFirst = nearest.second < 0 && found.first <= distance;
    nearest = isFirst || found < nearest ? found : nearest;
  }
  return nearest.second;
}
