// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Returns/lms3dRegroupedPlane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace
{
// As a share of the bound: planes from which the returns deviate by more are curved.
constexpr double CurvedShare = 0.05;
// Bounds: beams that meet a plane farther apart may have a gap between them.
constexpr double LargestStep = 24.0;
// The cosine of the largest angle between planes that are nearly the same.
constexpr double SmallestCosine = 0.9;

/// Where the beams of scans end: the numbers of a scan and of a beam, and a point.
using Beam = std::pair<int, int>;
using PointsOfBeams = std::vector<std::pair<Beam, lms3dVector>>;

bool IsBefore(const PointsOfBeams::value_type& a, const PointsOfBeams::value_type& b)
{
  return a.first < b.first;
}

// Returns nullptr if the points, which are in order, have none of the beam.
const lms3dVector* Find(const Beam& beam, const PointsOfBeams& points)
{
  const auto found =
    std::lower_bound(points.begin(), points.end(), PointsOfBeams::value_type(beam, {}), IsBefore);
  return found != points.end() && found->first == beam ? &found->second : nullptr;
}

// Lets a plane have surface between neighbouring beams.
void GuessBetween(int number, const std::vector<lms3dMappedReturn>& returns,
  const std::vector<int>& onPlane, const lms3dTablesOfScans& tables, lms3dFusedPlanes& planes)
{
  PointsOfBeams points;
  points.reserve(onPlane.size());
  for (const int i : onPlane)
  {
    points.push_back({ { returns[i].Scan, returns[i].BeamId }, returns[i].Point });
  }
  std::sort(points.begin(), points.end(), IsBefore);
  const double largest = LargestStep * planes.GetMaximumError();
  for (const auto& [beam, point] : points)
  {
    std::vector<lms3dVector> corners;
    for (const int neighbour : tables[beam.first]->GetNeighbours(beam.second))
    {
      const lms3dVector* const found = Find({ beam.first, neighbour }, points);
      if (found && lms3dGetLength(lms3dSubtract(*found, point)) <= largest)
      {
        corners.push_back(*found);
      }
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      planes.GuessTriangle(
        number, { point, corners[i], corners[std::min(i + 1, corners.size() - 1)] });
    }
  }
}

// Lets a plane have surface where the triangles of another plane are near it, and adds their
// corners to a box.
void GuessTriangles(int number, int old, lms3dFusedPlanes& planes, lms3dWorldBox& box)
{
  const lms3dPlaneFrame& frame = planes[number].Frame;
  for (const lms3dFusedTile& tile : planes[old].Tiles)
  {
    for (const lms3dFusedMesh::Triangle& triangle : tile.Mesh.Triangles)
    {
      const std::array<lms3dVector, 3> corners = { tile.Mesh.Points[triangle[0]],
        tile.Mesh.Points[triangle[1]], tile.Mesh.Points[triangle[2]] };
      if (std::all_of(corners.begin(), corners.end(),
            [&](const lms3dVector& corner)
            { return std::abs(frame.GetHeight(corner)) <= planes.GetMaximumError(); }))
      {
        planes.GuessTriangle(number, corners);
        std::for_each(
          corners.begin(), corners.end(), [&](const lms3dVector& corner) { box.Add(corner); });
      }
    }
  }
}

// Numbers of returns, in the order of their scans.
std::vector<int> SortByScan(std::vector<int> numbers, const std::vector<lms3dMappedReturn>& returns)
{
  std::stable_sort(numbers.begin(), numbers.end(),
    [&](int a, int b) { return returns[a].Scan < returns[b].Scan; });
  return numbers;
}

// The middle of the first old plane that is nearly the same, otherwise that of the returns.
lms3dVector FindMiddle(
  const lms3dReturnGroup& group, const std::vector<int>& oldPlanes, const lms3dFusedPlanes& planes)
{
  const auto same = std::find_if(oldPlanes.begin(), oldPlanes.end(),
    [&](int old)
    {
      const lms3dPlaneFrame& frame = planes[old].Frame;
      return std::abs(frame.GetHeight(group.Centre)) <= planes.GetMaximumError() &&
        lms3dDot(frame.GetNormal(), group.Normal) >= SmallestCosine;
    });
  return same != oldPlanes.end() ? planes[*same].Frame.GetMiddle() : group.Centre;
}
} // namespace

int lms3dMakeRegroupedPlane(
  const lms3dReturnGroup& group, const std::vector<int>& oldPlanes, lms3dFusedPlanes& planes)
{
  const int number =
    planes.MakePlane(group.Centre, group.Normal, FindMiddle(group, oldPlanes, planes));
  planes[number].IsWeak = true;
  planes[number].IsCurved = group.Deviation > CurvedShare * planes.GetMaximumError();
  return number;
}

lms3dWorldBox lms3dFillRegroupedPlane(int number, const std::vector<lms3dMappedReturn>& returns,
  const lms3dReturnGroup& group, const std::vector<int>& oldPlanes,
  const lms3dTablesOfScans& tables, lms3dFusedPlanes& planes)
{
  lms3dWorldBox box;
  GuessBetween(number, returns, group.Returns, tables, planes);
  for (const int old : oldPlanes)
  {
    GuessTriangles(number, old, planes, box);
  }
  planes.AcceptGuesses(number);
  // AddReturn() counts a scan if it is later than those before. It takes each return, since the
  // bound of groups is below GetLargestDistance().
  for (const int i : SortByScan(group.Returns, returns))
  {
    box.Add(returns[i].Point);
    planes.AddReturn(number, returns[i]);
  }
  return box;
}
