// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dParallelTasks.h"
#include "LocalMap/Bounded/lms3dSurfaceFit.h"

#include <algorithm>
#include <cmath>

namespace
{
// The smallest move that counts, in bounds.
constexpr double SmallShare = 0.01;
// How often a vertex moves back until it is where it was.
constexpr int MaximumMovesBack = 3;
// The number of triangles that a thread takes at least.
constexpr std::size_t TrianglesOfTask = 8;
} // namespace

void lms3dSurfaceFit::ForgetSmallMoves()
{
  for (std::size_t vertex = 0; vertex < this->Inverses.size(); ++vertex)
  {
    const double before = this->Before[vertex];
    if (std::abs(this->Inverses[vertex] - before) <
      SmallShare * this->MaximumError * before * before)
    {
      this->Inverses[vertex] = before;
    }
  }
}

void lms3dSurfaceFit::MoveForbiddenBack()
{
  std::vector<std::int32_t> triangles;
  for (std::size_t i = 0; i < this->Sums.size(); ++i)
  {
    const lms3dVertexStars::Triangle& triangle = this->Stars.GetTriangles()[i];
    if (!triangle.IsRemoved &&
      std::any_of(triangle.Corners.begin(), triangle.Corners.end(),
        [this](std::int32_t corner) { return this->HasMoved(corner); }))
    {
      triangles.push_back(static_cast<std::int32_t>(i));
    }
  }
  while (!triangles.empty())
  {
    triangles = this->MoveBack(this->FindForbidden(triangles));
  }
}

std::vector<std::int32_t> lms3dSurfaceFit::FindForbidden(
  const std::vector<std::int32_t>& triangles) const
{
  std::vector<std::uint8_t> isAllowed(triangles.size());
  lms3dForEachInTasks(triangles.size(), TrianglesOfTask,
    [&](std::size_t i) { isAllowed[i] = this->IsAllowed(triangles[i]); });
  std::vector<std::int32_t> forbidden;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    if (!isAllowed[i])
    {
      forbidden.push_back(triangles[i]);
    }
  }
  return forbidden;
}

bool lms3dSurfaceFit::IsAllowed(std::int32_t triangle) const
{
  const auto& [a, b, c] = this->Stars.GetTriangles()[triangle].Corners;
  return lms3dTriangleSums::IsWithinBound(this->Demands, this->GetTriangle(triangle)) &&
    this->IsSupported(a, b) && this->IsSupported(b, c) && this->IsSupported(c, a);
}

// Whether the edge from one corner of a triangle to the next belongs to no other triangle.
bool lms3dSurfaceFit::IsBorder(std::int32_t from, std::int32_t to) const
{
  return this->Stars.ForEachTriangle(
    from, [to](std::int32_t, std::int32_t, std::int32_t last) { return last != to; });
}

// Whether the returns support a moved edge if it is at a depth step.
bool lms3dSurfaceFit::IsSupported(std::int32_t from, std::int32_t to) const
{
  if (!(this->HasMoved(from) || this->HasMoved(to)) || !this->IsBorder(from, to))
  {
    return true;
  }
  const auto getVertex = [this](std::int32_t number)
  {
    return lms3dVertexStars::Vertex{ this->Stars.GetVertex(number).Corner, this->Inverses[number],
      false, false, false, {} };
  };
  return this->Borders.IsSupportedAtDepthSteps(getVertex(from), getVertex(to));
}

// Moves the corners of triangles back a bit, and returns the triangles that have changed.
std::vector<std::int32_t> lms3dSurfaceFit::MoveBack(const std::vector<std::int32_t>& triangles)
{
  std::vector<std::int32_t> changed;
  for (std::int32_t triangle : triangles)
  {
    for (std::int32_t corner : this->Stars.GetTriangles()[triangle].Corners)
    {
      if (this->HasMoved(corner))
      {
        this->Inverses[corner] = ++this->MovesBack[corner] < MaximumMovesBack
          ? 0.5 * (this->Inverses[corner] + this->Before[corner])
          : this->Before[corner];
        const std::vector<std::int32_t>& around = this->Stars.GetVertex(corner).Triangles;
        changed.insert(changed.end(), around.begin(), around.end());
      }
    }
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  return changed;
}

void lms3dSurfaceFit::MoveVertices()
{
  for (std::int32_t vertex = 0; vertex < this->Stars.GetNumberOfVertices(); ++vertex)
  {
    if (this->HasMoved(vertex))
    {
      this->Stars.SetInverse(vertex, this->Inverses[vertex]);
    }
  }
}
