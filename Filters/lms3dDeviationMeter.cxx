// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dDeviationMeter.h"

#include "lms3dTriangleDistance.h"

#include <algorithm>
#include <cmath>

namespace
{
// Of the limit: the returns that are measured first.
constexpr double FirstShare = 0.7;
// Radians by which a beam may miss a triangle that is asked all the same.
constexpr double Margin = 1e-6;
} // namespace

// No return is farther from a triangle than along its beam, so those that are nearer along their
// beams than the largest distance so far cannot change it.
double lms3dDeviationMeter::GetLargest(const std::vector<Triangle>& triangles, double limit) const
{
  const double least = FirstShare * limit;
  const double largest = this->GetLargestAbove(triangles, least);
  return largest >= least ? largest : this->GetLargestAbove(triangles, largest);
}

double lms3dDeviationMeter::GetLargestAbove(
  const std::vector<Triangle>& triangles, double least) const
{
  std::vector<std::pair<Place, double>> distances;
  for (const Triangle& triangle : triangles)
  {
    this->Measure(triangle, least, distances);
  }
  // Of each return the smallest comes first.
  std::sort(distances.begin(), distances.end());
  double largest = 0.0;
  Place last = -1;
  for (const auto& [place, distance] : distances)
  {
    largest = place != last ? std::max(largest, distance) : largest;
    last = place;
  }
  return largest;
}

void lms3dDeviationMeter::Measure(
  const Triangle& triangle, double least, std::vector<std::pair<Place, double>>& distances) const
{
  const lms3dCorner& a = *triangle[0];
  const lms3dCorner& b = *triangle[1];
  const lms3dCorner& c = *triangle[2];
  const lms3dBeamsOfTriangle beams(this->Sphere, a, b, c, Margin);
  const auto measure = [&](int column, int first, int last)
  {
    const lms3dColumnPlane inColumn(beams.GetPlane(), this->Sphere, column);
    const Place start = this->Sphere.GetPlace(column, 0);
    for (int row = first; row <= last; ++row)
    {
      const Place place = start + row;
      const double range = this->Sphere.GetRange(place);
      const double inverse =
        inColumn.GetInverseRange(this->Sphere.GetCosines()[row], this->Sphere.GetSines()[row]);
      if (this->Patches.Labels[place] == this->Patch && !this->Sphere.IsPoleRow(row) &&
        !(std::abs(range - 1.0 / inverse) <= least))
      {
        const lms3dVector point = lms3dScale(this->Sphere.GetDirection(place), range);
        distances.emplace_back(place, lms3dGetDistance(point, a.Position, b.Position, c.Position));
      }
    }
  };
  beams.ForColumns(measure);
}
