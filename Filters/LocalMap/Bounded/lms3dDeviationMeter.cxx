// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dDeviationMeter.h"

#include "Geometry/lms3dTriangleDistance.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace
{
// Returns below this share of the largest possible deviation are measured only if none lies above.
constexpr double FirstShare = 0.7;
// Radians by which a beam may pass outside of a triangle that it hits.
constexpr double Margin = 1e-6;
} // namespace

double lms3dDeviationMeter::GetLargest(std::vector<Part> parts)
{
  std::stable_sort(parts.begin(), parts.end(),
    [](const Part& a, const Part& b) { return a.MaximumAlongBeams > b.MaximumAlongBeams; });
  double largest = 0.0;
  for (const Part& part : parts)
  {
    if (part.MaximumAlongBeams <= largest)
    {
      break;
    }
    largest = std::max(largest, this->GetLargest(part, largest));
  }
  return largest;
}

// The largest deviation of a patch, or any number below the threshold if none exceeds it.
double lms3dDeviationMeter::GetLargest(const Part& part, double threshold)
{
  const double share = std::max(threshold, FirstShare * part.MaximumAlongBeams);
  const double largest = this->GetLargestAbove(part, share);
  return largest >= share ? largest : this->GetLargestAbove(part, std::max(threshold, largest));
}

double lms3dDeviationMeter::GetLargestAbove(const Part& part, double threshold)
{
  ++this->Pass;
  tbb::enumerable_thread_specific<Distances> ofThreads;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(part.First, part.End),
    [&](const tbb::blocked_range<std::size_t>& triangles)
    {
      Distances& distances = ofThreads.local();
      for (std::size_t triangle = triangles.begin(); triangle < triangles.end(); ++triangle)
      {
        this->Measure(part, triangle, threshold, distances);
      }
    });
  Distances distances;
  for (const Distances& ofThread : ofThreads)
  {
    distances.insert(distances.end(), ofThread.begin(), ofThread.end());
  }
  // A beam that passes an edge at a depth step can hit a triangle of the other side, too.
  distances.erase(std::remove_if(distances.begin(), distances.end(),
                    [this](const auto& entry) { return this->Near[entry.first] == this->Pass; }),
    distances.end());
  // For each return, the smallest distance comes first.
  std::sort(distances.begin(), distances.end());
  double largest = 0.0;
  GridIndex last = -1;
  for (const auto& [index, distance] : distances)
  {
    largest = index != last ? std::max(largest, distance) : largest;
    last = index;
  }
  return largest;
}

void lms3dDeviationMeter::Measure(
  const Part& part, std::size_t triangle, double threshold, Distances& distances)
{
  const std::array<std::int32_t, 3>& corners = this->Map.Triangles[triangle];
  const lms3dTriangleCorner& a = this->Corners[corners[0]];
  const lms3dTriangleCorner& b = this->Corners[corners[1]];
  const lms3dTriangleCorner& c = this->Corners[corners[2]];
  const lms3dTriangleRasterizer beams(this->Sphere, a, b, c, Margin);
  const int rows = this->Sphere.GetNumberOfRows();
  const int lowest = this->Sphere.IsPoleRow(0) ? 1 : 0;
  const int highest = this->Sphere.IsPoleRow(rows - 1) ? rows - 2 : rows - 1;
  const auto measure = [&](int column, int first, int last)
  {
    const lms3dTriangleRasterizer::ColumnRanges hits(beams, column);
    const GridIndex start = this->Sphere.GetIndex(column, 0);
    const double* const ranges = this->Sphere.GetRanges() + start;
    const std::int32_t* const labels = this->Patches.Labels.data() + start;
    std::atomic<std::int32_t>* const near = this->Near.data() + start;
    for (int row = std::max(first, lowest); row <= std::min(last, highest); ++row)
    {
      const bool isOwn = part.Patch == AllPatches ? labels[row] >= 0 : labels[row] == part.Patch;
      if (!isOwn || this->Sphere.IsFilled(start + row))
      {
        continue;
      }
      if (std::abs(ranges[row] - hits.GetRange(row)) <= threshold)
      {
        near[row].store(this->Pass, std::memory_order_relaxed);
      }
      else
      {
        const lms3dVector point = lms3dScale(this->Sphere.GetDirection(start + row), ranges[row]);
        distances.emplace_back(
          start + row, lms3dGetDistance(point, a.Position, b.Position, c.Position));
      }
    }
  };
  beams.ForEachColumn(measure);
}
