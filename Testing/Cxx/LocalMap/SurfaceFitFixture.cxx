// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/SurfaceFitFixture.h"

#include <algorithm>
#include <cmath>

SurfaceFit::SurfaceFit()
  : Sphere(this->Scan.Grid, this->Scan.Joins)
{
  this->Patches.Patches.resize(1);
  this->Patches.Labels.assign(this->Sphere.GetSize(), 0);
}

void SurfaceFit::Fit(
  double bound, const std::vector<std::uint8_t>& isChosen, lms3dVertexStars& stars) const
{
  const lms3dBeamDemands demands(this->Sphere, this->Patches, bound);
  const lms3dBorderShortcuts borders(this->Sphere, this->Patches, bound);
  lms3dSurfaceFit(demands, borders, bound, isChosen, stars).Run();
}

void SurfaceFit::FitAll(double bound, lms3dVertexStars& stars) const
{
  this->Fit(bound, std::vector<std::uint8_t>(stars.GetNumberOfVertices(), 1), stars);
}

SurfaceFit::Distances SurfaceFit::Measure(const lms3dVertexStars& stars) const
{
  Distances distances;
  for (const lms3dVertexStars::Triangle& triangle : stars.GetTriangles())
  {
    const auto& [a, b, c] = triangle.Corners;
    const lms3dTriangleRasterizer beams(this->Sphere, lms3dTriangleCorner(stars.GetPosition(a)),
      lms3dTriangleCorner(stars.GetPosition(b)), lms3dTriangleCorner(stars.GetPosition(c)));
    beams.ForEachColumn(
      [&](int column, int first, int last)
      {
        const lms3dTriangleRasterizer::ColumnRanges ranges(beams, column);
        for (int row = first; row <= last; ++row)
        {
          const double distance = std::abs(ranges.GetRange(row) - Radius);
          distances.Largest = std::max(distances.Largest, distance);
          distances.SumOfSquares += distance * distance;
        }
      });
  }
  return distances;
}
