// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dParallelTasks.h"
#include "LocalMap/Bounded/lms3dSurfaceFit.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
// The smallest move that counts, in bounds.
constexpr double SmallShare = 0.01;
// How often a vertex moves back until it is where it was.
constexpr int MaximumMovesBack = 3;
// The number of triangles that a thread takes at least.
constexpr std::size_t TrianglesOfTask = 8;

void MakeUnique(std::vector<std::int32_t>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}
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

bool lms3dSurfaceFit::IsAtMoved(std::size_t triangle) const
{
  const lms3dVertexStars::Triangle& found = this->Stars.GetTriangles()[triangle];
  return !found.IsRemoved &&
    std::any_of(found.Corners.begin(), found.Corners.end(),
      [this](std::int32_t corner) { return this->HasMoved(corner); });
}

void lms3dSurfaceFit::MoveForbiddenBack()
{
  std::vector<std::int32_t> triangles;
  for (std::size_t i = 0; i < this->Sums.size(); ++i)
  {
    if (this->IsAtMoved(i))
    {
      triangles.push_back(static_cast<std::int32_t>(i));
    }
  }
  while (!triangles.empty())
  {
    triangles = this->MoveBack(this->FindForbidden(triangles));
  }
}

// Returns the vertices to move back.
std::vector<std::int32_t> lms3dSurfaceFit::FindForbidden(const std::vector<std::int32_t>& triangles)
{
  std::vector<std::uint8_t> found(triangles.size());
  lms3dForEachInTasks(triangles.size(), TrianglesOfTask,
    [&](std::size_t i) { found[i] = this->FindForbiddenCorners(triangles[i]); });
  std::vector<std::int32_t> vertices;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const Corners& corners = this->Stars.GetTriangles()[triangles[i]].Corners;
    for (int corner = 0; corner < 3; ++corner)
    {
      if (found[i] & 1 << corner && this->HasMoved(corners[corner]))
      {
        vertices.push_back(corners[corner]);
      }
    }
  }
  MakeUnique(vertices);
  return vertices;
}

// Returns a bit for each corner to move back.
std::uint8_t lms3dSurfaceFit::FindForbiddenCorners(std::int32_t triangle)
{
  const std::uint8_t ends = this->FindUnsupportedEnds(triangle);
  const bool isAllowed =
    ends != 0 || this->Beams[triangle].AreWithinBound(this->Demands, this->GetInverses(triangle));
  return isAllowed ? ends : AllCorners;
}

// Returns a bit for each end of a moved border that is at a depth step and not supported there.
std::uint8_t lms3dSurfaceFit::FindUnsupportedEnds(std::int32_t triangle)
{
  using Support = lms3dBorderShortcuts::Support;
  const Corners& corners = this->Stars.GetTriangles()[triangle].Corners;
  int ends = 0;
  for (int corner = 0; corner < 3; ++corner)
  {
    const int next = (corner + 1) % 3;
    const bool mayBeStep = (this->MayBeSteps[triangle] & 1 << corner) != 0;
    if (!mayBeStep || !(this->HasMoved(corners[corner]) || this->HasMoved(corners[next])))
    {
      continue;
    }
    const Support support = this->GetSupport(corners[corner], corners[next]);
    this->MayBeSteps[triangle] &= support == Support::NoDepthStep ? ~(1 << corner) : AllCorners;
    ends |= support == Support::Unsupported ? 1 << corner | 1 << next : 0;
  }
  return static_cast<std::uint8_t>(ends);
}

// Whether the edge from one corner of a triangle to the next belongs to no other triangle.
bool lms3dSurfaceFit::IsBorder(std::int32_t from, std::int32_t to) const
{
  return this->Stars.ForEachTriangle(
    from, [to](std::int32_t, std::int32_t, std::int32_t last) { return last != to; });
}

lms3dBorderShortcuts::Support lms3dSurfaceFit::GetSupport(std::int32_t from, std::int32_t to) const
{
  if (!this->IsBorder(from, to))
  {
    return lms3dBorderShortcuts::Support::NoDepthStep;
  }
  const auto getVertex = [this](std::int32_t number)
  {
    return lms3dVertexStars::Vertex{ this->Stars.GetVertex(number).Corner, this->Inverses[number],
      false, false, false, {} };
  };
  return this->Borders.GetSupportAtDepthSteps(getVertex(from), getVertex(to));
}

// Moves vertices back a bit, and returns the triangles to check again.
std::vector<std::int32_t> lms3dSurfaceFit::MoveBack(const std::vector<std::int32_t>& vertices)
{
  std::vector<std::int32_t> changed;
  for (std::int32_t vertex : vertices)
  {
    this->Inverses[vertex] = ++this->MovesBack[vertex] < MaximumMovesBack
      ? 0.5 * (this->Inverses[vertex] + this->Before[vertex])
      : this->Before[vertex];
    const std::vector<std::int32_t>& around = this->Stars.GetVertex(vertex).Triangles;
    std::copy_if(around.begin(), around.end(), std::back_inserter(changed),
      [this](std::int32_t triangle) { return this->IsAtMoved(triangle); });
  }
  MakeUnique(changed);
  return changed;
}

// The sum of the squared distances without a constant.
double lms3dSurfaceFit::GetSum(const std::vector<double>& inverses) const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < this->Sums.size(); ++i)
  {
    const Corners& corners = this->Stars.GetTriangles()[i].Corners;
    sum +=
      this->Sums[i].GetSum({ inverses[corners[0]], inverses[corners[1]], inverses[corners[2]] });
  }
  return sum;
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
