// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dDeviationMeter.h"

#include "Geometry/lms3dTriangleDistance.h"
#include "LocalMap/Bounded/lms3dTriangleRasterizer.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double FirstShare = 0.7;
constexpr double Margin = 1e-6;
} // namespace

double lms3dDeviationMeter::GetLargest(std::vector<Part> parts) const
{
  std::stable_sort(
    parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.OnBeams > b.OnBeams; });
  double largest = 0.0;
  for (const Part& part : parts)
  {
    if (part.OnBeams <= largest)
    {
      break;
    }
    largest = std::max(largest, this->GetLargest(part, largest));
  }
  return largest;
}

// Of those above a distance; less where there are none.
double lms3dDeviationMeter::GetLargest(const Part& part, double least) const
{
  const double share = std::max(least, FirstShare * part.OnBeams);
  const double largest = this->GetLargestAbove(part, share);
  return largest >= share ? largest : this->GetLargestAbove(part, std::max(least, largest));
}

double lms3dDeviationMeter::GetLargestAbove(const Part& part, double least) const
{
  Distances distances;
  for (std::size_t triangle = part.First; triangle < part.Last; ++triangle)
  {
    this->Measure(part, triangle, least, distances);
  }
  // Of each return the smallest comes first.
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
  const Part& part, std::size_t triangle, double least, Distances& distances) const
{
  const auto getCorner = [&](int i)
  { return lms3dTriangleCorner(this->Map.Points[this->Map.Triangles[triangle][i]]); };
  const lms3dTriangleCorner a = getCorner(0);
  const lms3dTriangleCorner b = getCorner(1);
  const lms3dTriangleCorner c = getCorner(2);
  const lms3dTriangleRasterizer beams(this->Sphere, a, b, c, Margin);
  const auto measure = [&](int column, int first, int last)
  {
    const lms3dColumnPlane inColumn(beams.GetPlane(), this->Sphere, column);
    const GridIndex start = this->Sphere.GetIndex(column, 0);
    for (int row = first; row <= last; ++row)
    {
      const GridIndex index = start + row;
      const double range = this->Sphere.GetRange(index);
      const double inverse =
        inColumn.GetInverseRange(this->Sphere.GetCosines()[row], this->Sphere.GetSines()[row]);
      if (this->Patches.Labels[index] == part.Patch && !this->Sphere.IsPoleRow(row) &&
        !(std::abs(range - 1.0 / inverse) <= least))
      {
        const lms3dVector point = lms3dScale(this->Sphere.GetDirection(index), range);
        distances.emplace_back(index, lms3dGetDistance(point, a.Position, b.Position, c.Position));
      }
    }
  };
  beams.ForColumns(measure);
}
