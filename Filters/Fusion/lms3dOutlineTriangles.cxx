// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dOutlineTriangles.h"

#include "Fusion/lms3dRasterRows.h"
#include "Triangulation/lms3dTriangulation.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

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

std::vector<lms3dTriangle2> lms3dDropIslands(
  const std::vector<lms3dTriangle2>& triangles, const lms3dRaster& raster)
{
  std::vector<std::size_t> group(triangles.size());
  std::iota(group.begin(), group.end(), std::size_t{ 0 });
  const auto find = [&group](std::size_t i)
  {
    while (group[i] != i)
    {
      group[i] = group[group[i]];
      i = group[i];
    }
    return i;
  };
  std::map<std::pair<lms3dPoint2, lms3dPoint2>, std::size_t> edges;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const auto [place, isNew] =
        edges.try_emplace(std::minmax(triangles[i][corner], triangles[i][(corner + 1) % 3]), i);
      group[find(i)] = find(place->second);
    }
  }
  std::vector<bool> hasReturn(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    if (!hasReturn[find(i)])
    {
      hasReturn[find(i)] = !lms3dForCentreRows(triangles[i],
        [&](std::int32_t row, std::int32_t first, std::int32_t last)
        { return !raster.HasAny(&lms3dRasterBlock::Must, row, first, last); });
    }
  }
  std::vector<lms3dTriangle2> kept;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    if (hasReturn[find(i)])
    {
      kept.push_back(triangles[i]);
    }
  }
  return kept;
}
