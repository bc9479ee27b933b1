// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dDeviationMeter.h"

#include "Geometry/lms3dTriangleDistance.h"
#include "LocalMap/Bounded/lms3dColumnDeviations.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace
{
// Returns below this share of the expected deviation are measured only if none lies above.
constexpr double FirstShare = 0.7;
// Radians by which a beam may pass outside of a triangle that it hits.
constexpr double Margin = 1e-6;
} // namespace

double lms3dDeviationMeter::GetLargest(double expected)
{
  const double share = FirstShare * expected;
  const double largest = this->GetLargestAbove(share);
  return largest >= share ? largest : this->GetLargestAbove(largest);
}

double lms3dDeviationMeter::GetLargestAbove(double threshold)
{
  Distances distances = this->FindDistances(threshold);
  if (distances.empty())
  {
    return 0.0;
  }
  // A beam that passes an edge at a depth step can hit a triangle of the other side, too.
  this->MarkNear(threshold, distances);
  distances.erase(std::remove_if(distances.begin(), distances.end(),
                    [this](const auto& entry) { return this->Marks[entry.first] == IsNear; }),
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

// The returns that are farther than the threshold from a triangle along their beams, and their
// distances from it.
lms3dDeviationMeter::Distances lms3dDeviationMeter::FindDistances(double threshold) const
{
  tbb::enumerable_thread_specific<Distances> ofThreads;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, this->Map.Triangles.size()),
    [&](const tbb::blocked_range<std::size_t>& triangles)
    {
      Distances& distances = ofThreads.local();
      for (std::size_t triangle = triangles.begin(); triangle < triangles.end(); ++triangle)
      {
        this->Measure(triangle, threshold, distances);
      }
    });
  Distances distances;
  for (const Distances& ofThread : ofThreads)
  {
    distances.insert(distances.end(), ofThread.begin(), ofThread.end());
  }
  return distances;
}

// Marks the returns that are far from a triangle, and those whose beams hit another triangle within
// the threshold.
void lms3dDeviationMeter::MarkNear(double threshold, const Distances& distances)
{
  std::vector<std::uint8_t> isIncluded(this->Sphere.GetNumberOfColumns(), 0);
  for (const auto& entry : distances)
  {
    isIncluded[this->Sphere.GetColumn(entry.first)] = 1;
    this->Marks[entry.first].store(IsFar, std::memory_order_relaxed);
  }
  tbb::parallel_for(std::size_t(0), this->Map.Triangles.size(),
    [&](std::size_t triangle)
    {
      const lms3dTriangleRasterizer beams = this->MakeRasterizer(triangle);
      beams.ForEachColumnOf([&](int column) { return isIncluded[column] != 0; },
        [&](int column, int first, int last)
        {
          const lms3dTriangleRasterizer::ColumnRanges hits(beams, column);
          for (int row = first; row <= last; ++row)
          {
            const GridIndex index = this->Sphere.GetIndex(column, row);
            if (this->Marks[index].load(std::memory_order_relaxed) == IsFar &&
              std::abs(this->Sphere.GetRange(index) - hits.GetRange(row)) <= threshold)
            {
              this->Marks[index].store(IsNear, std::memory_order_relaxed);
            }
          }
          return true;
        });
    });
}

lms3dTriangleRasterizer lms3dDeviationMeter::MakeRasterizer(std::size_t triangle) const
{
  const std::array<std::int32_t, 3>& corners = this->Map.Triangles[triangle];
  return { this->Sphere, this->Corners[corners[0]], this->Corners[corners[1]],
    this->Corners[corners[2]], Margin };
}

void lms3dDeviationMeter::Measure(
  std::size_t triangle, double threshold, Distances& distances) const
{
  const std::array<std::int32_t, 3>& corners = this->Map.Triangles[triangle];
  const lms3dTriangleRasterizer beams = this->MakeRasterizer(triangle);
  const int rows = this->Sphere.GetNumberOfRows();
  const int lowest = this->Sphere.IsPoleRow(0) ? 1 : 0;
  const int highest = this->Sphere.IsPoleRow(rows - 1) ? rows - 2 : rows - 1;
  const auto measure = [&](int column, int first, int last)
  {
    const lms3dTriangleRasterizer::ColumnRanges hits(beams, column);
    const int from = std::max(first, lowest);
    const int to = std::min(last, highest);
    if (lms3dAreWithin(this->Sphere, hits.GetPlane(), column, from, to, threshold))
    {
      return;
    }
    const GridIndex start = this->Sphere.GetIndex(column, 0);
    for (int row = from; row <= to; ++row)
    {
      const GridIndex index = start + row;
      const double range = this->Sphere.GetRange(index);
      if (this->Patches.Labels[index] >= 0 && !this->Sphere.IsFilled(index) &&
        !(std::abs(range - hits.GetRange(row)) <= threshold))
      {
        distances.emplace_back(index,
          lms3dGetDistance(lms3dScale(this->Sphere.GetDirection(index), range),
            this->Corners[corners[0]].Position, this->Corners[corners[1]].Position,
            this->Corners[corners[2]].Position));
      }
    }
  };
  beams.ForEachColumn(measure);
}
