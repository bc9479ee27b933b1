// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dVertexFit.h"

#include <algorithm>

namespace
{
// A beam with a smaller share of the vertex in its range lies on the opposite edge, and demands nothing.
constexpr double MinimumShare = 1e-9;
// A beam with at least this share of the vertex determines its range.
constexpr double DeterminingShare = 0.5;
// Radians by which a beam may pass outside of a triangle that it hits. Rounding can put a beam through
// a vertex outside of all triangles there.
constexpr double Margin = 1e-9;
// More than a product and a quotient round.
constexpr double Rounding = 1.0 + 1e-14;
} // namespace

bool lms3dVertexFit::Add(const lms3dTriangleCorner& vertex, const Side& side)
{
  const lms3dVector toLast = lms3dCross(side.Last.Position, side.Next.Position);
  const double scale = 1.0 / lms3dDot(toLast, vertex.Position);
  const Triangle triangle = { lms3dTriangleRasterizer(
                                this->Beams.GetSphere(), vertex, side.Next, side.Last, Margin),
    lms3dScale(toLast, scale),
    lms3dAdd(lms3dScale(lms3dCross(vertex.Position, side.Last.Position), scale * side.NextInverse),
      lms3dScale(lms3dCross(side.Next.Position, vertex.Position), scale * side.LastInverse)) };
  triangle.Beams.ForEachColumn(
    [&](int column, int first, int last)
    {
      if (this->Sum.IsPossible())
      {
        this->AddColumn(triangle, column, first, last);
      }
    });
  return this->Sum.IsPossible();
}

void lms3dVertexFit::AddColumn(const Triangle& triangle, int column, int first, int last)
{
  const lms3dVector& own = triangle.Own;
  const lms3dVector& rest = triangle.Rest;
  const lms3dBeamSphere& sphere = this->Beams.GetSphere();
  const std::array<double, 2>& level = sphere.GetHorizontal(column);
  const double ownLevel = own[0] * level[0] + own[1] * level[1];
  const double restLevel = rest[0] * level[0] + rest[1] * level[1];
  const lms3dBeamDemands::Demand* const demands = &this->Beams[sphere.GetIndex(column, 0)];
  const double* const cosines = sphere.GetCosines();
  const double* const sines = sphere.GetSines();
  Sums sums = this->Sum;
  for (int row = first; row <= last; ++row)
  {
    const lms3dBeamDemands::Demand& demand = demands[row];
    const double share = ownLevel * cosines[row] + own[2] * sines[row];
    const double others = restLevel * cosines[row] + rest[2] * sines[row];
    if (demand.Weight == 0.0 || share < MinimumShare)
    {
      continue;
    }
    // Most beams do not narrow the interval, which takes no division to see.
    const double low = demand.Minimum - others;
    const double high = demand.Maximum - others;
    if (!(low * Rounding < sums.Minimum * share))
    {
      sums.Minimum = std::max(sums.Minimum, low / share);
    }
    if (!(high > sums.Maximum * share * Rounding))
    {
      sums.Maximum = std::min(sums.Maximum, high / share);
    }
    sums.LargestShare = std::max(sums.LargestShare, share);
    sums.Squares += demand.Weight * share * share;
    sums.Products += demand.Weight * share * (demand.Inverse - others);
  }
  this->Sum = sums;
}

bool lms3dVertexFit::IsDetermined() const
{
  return this->Sum.LargestShare >= DeterminingShare && this->Sum.IsPossible();
}

double lms3dVertexFit::GetInverse() const
{
  return std::clamp(this->Sum.Products / this->Sum.Squares, this->Sum.Minimum, this->Sum.Maximum);
}
