// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dVertexFits.h"

#include "LocalMap/Bounded/lms3dParallelTasks.h"
#include "LocalMap/Bounded/lms3dVertexFit.h"

#include <algorithm>
#include <cstddef>

namespace
{
// The number of vertices that a thread fits at least.
constexpr std::size_t VerticesOfTask = 4;
} // namespace

// Each fit uses the ranges of the neighbours that come before it. So vertices of one level have no
// edge between them, and the neighbours that come before them have lower levels.
std::vector<std::vector<std::int32_t>> lms3dVertexFits::FindLevels(
  const lms3dVertexStars& stars, const std::vector<std::uint8_t>& isChosen)
{
  std::vector<std::vector<std::int32_t>> levels;
  std::vector<int> levelOf(isChosen.size(), -1);
  for (std::int32_t vertex = 0; vertex < stars.GetNumberOfVertices(); ++vertex)
  {
    if (isChosen[vertex] == 0)
    {
      continue;
    }
    int level = 0;
    stars.ForEachTriangle(vertex,
      [&](std::int32_t, std::int32_t next, std::int32_t last)
      {
        level = std::max(level, 1 + std::max(levelOf[next], levelOf[last]));
        return true;
      });
    levelOf[vertex] = level;
    if (level == static_cast<int>(levels.size()))
    {
      levels.emplace_back();
    }
    levels[level].push_back(vertex);
  }
  return levels;
}

void lms3dVertexFits::FitOne(
  const lms3dBeamDemands& demands, std::int32_t vertex, lms3dVertexStars& stars)
{
  const lms3dTriangleCorner& corner = stars.GetVertex(vertex).Corner;
  lms3dVertexFit fit(demands);
  if (stars.ForEachTriangle(vertex,
        [&](std::int32_t, std::int32_t next, std::int32_t last)
        { return fit.Add(corner, lms3dVertexFit::GetSide(stars, next, last)); }) &&
    fit.IsDetermined() && fit.GetInverse() > 0.0)
  {
    stars.SetInverse(vertex, fit.GetInverse());
  }
}

void lms3dVertexFits::Run(const lms3dBeamDemands& demands,
  const std::vector<std::uint8_t>& isChosen, lms3dVertexStars& stars)
{
  for (const std::vector<std::int32_t>& level : FindLevels(stars, isChosen))
  {
    lms3dForEachInTasks(
      level.size(), VerticesOfTask, [&](std::size_t i) { FitOne(demands, level[i], stars); });
  }
}
