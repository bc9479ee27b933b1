// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dDeviationMeter.h"

#include "Geometry/lms3dTriangleDistance.h"
#include "LocalMap/Bounded/lms3dTriangleRasterizer.h"

#include <algorithm>
#include <cmath>

namespace
{
// Returns below this share of the largest possible deviation are measured only if none lies above.
constexpr double FirstShare = 0.7;
// Radians by which a beam may pass outside of a triangle that it hits.
constexpr double Margin = 1e-6;
} // namespace

double lms3dDeviationMeter::GetLargest(std::vector<Part> parts) const
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
double lms3dDeviationMeter::GetLargest(const Part& part, double threshold) const
{
  const double share = std::max(threshold, FirstShare * part.MaximumAlongBeams);
  const double largest = this->GetLargestAbove(part, share);
  return largest >= share ? largest : this->GetLargestAbove(part, std::max(threshold, largest));
}

double lms3dDeviationMeter::GetLargestAbove(const Part& part, double threshold) const
{
  Distances distances;
  for (std::size_t triangle = part.First; triangle < part.End; ++triangle)
  {
    this->Measure(part, triangle, threshold, distances);
  }
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
  const Part& part, std::size_t triangle, double threshold, Distances& distances) const
{
  const auto getCorner = [&](int i)
  { return lms3dTriangleCorner(this->Map.Points[this->Map.Triangles[triangle][i]]); };
  const lms3dTriangleCorner a = getCorner(0);
  const lms3dTriangleCorner b = getCorner(1);
  const lms3dTriangleCorner c = getCorner(2);
  const lms3dTriangleRasterizer beams(this->Sphere, a, b, c, Margin);
  const auto measure = [&](int column, int first, int last)
  {
    const lms3dTriangleRasterizer::ColumnRanges hits(beams, column);
    const GridIndex start = this->Sphere.GetIndex(column, 0);
    for (int row = first; row <= last; ++row)
    {
      const GridIndex index = start + row;
      if (this->Patches.Labels[index] == part.Patch && !this->Sphere.IsPoleRow(row) &&
        !(std::abs(this->Sphere.GetRange(index) - hits.GetRange(row)) <= threshold))
      {
        const lms3dVector point =
          lms3dScale(this->Sphere.GetDirection(index), this->Sphere.GetRange(index));
        distances.emplace_back(index, lms3dGetDistance(point, a.Position, b.Position, c.Position));
      }
    }
  };
  beams.ForEachColumn(measure);
}
