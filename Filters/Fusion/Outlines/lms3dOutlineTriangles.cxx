// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Outlines/lms3dOutlineTriangles.h"

#include "Triangulation/lms3dTriangulation.h"

#include <cstdint>
#include <map>

std::optional<std::vector<lms3dTriangle2>> lms3dTriangulateOutlines(
  const std::vector<lms3dLoop>& loops)
{
  std::vector<lms3dPoint2> points;
  std::map<lms3dPoint2, std::int32_t> numbers;
  std::vector<std::int32_t> corners;
  std::vector<std::int32_t> ends;
  for (const lms3dLoop& loop : loops)
  {
    if (loop.size() < 3)
    {
      continue;
    }
    for (const lms3dPoint2& point : loop)
    {
      const auto [place, isNew] =
        numbers.try_emplace(point, static_cast<std::int32_t>(points.size()));
      if (isNew)
      {
        points.push_back(point);
      }
      corners.push_back(place->second);
    }
    ends.push_back(static_cast<std::int32_t>(corners.size()));
  }
  std::vector<lms3dTriangle2> triangles;
  if (points.empty())
  {
    return triangles;
  }
  const lms3dTriangulation triangulation(points, corners, ends);
  if (!triangulation.IsValid())
  {
    return {};
  }
  for (int i = 0; i < triangulation.GetNumberOfTriangles(); ++i)
  {
    if (triangulation.IsInside(i))
    {
      const std::array<std::int32_t, 3>& ids = triangulation.GetCorners(i);
      triangles.push_back({ points[ids[0]], points[ids[1]], points[ids[2]] });
    }
  }
  return triangles;
}
