// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dVertexFit.h"

#include "Geometry/lms3dWideLoops.h"

#include <algorithm>

namespace
{
// A beam with a smaller share of the vertex in its range lies on the opposite edge, and demands
// nothing.
constexpr double MinimumShare = 1e-9;
// A beam with at least this share of the vertex determines its range.
constexpr double DeterminingShare = 0.5;
// More than a product and a quotient round.
constexpr double Rounding = 1.0 + 1e-14;
} // namespace

lms3dVertexFit::Triangle::Triangle(
  const lms3dBeamSphere& sphere, const lms3dTriangleCorner& vertex, const Side& side)
  : Beams(sphere, vertex, side.Next, side.Last, lms3dTriangleRasterizer::VertexMargin)
{
  const lms3dVector toLast = lms3dCross(side.Last.Position, side.Next.Position);
  const double scale = 1.0 / lms3dDot(toLast, vertex.Position);
  this->Own = lms3dScale(toLast, scale);
  this->Rest =
    lms3dAdd(lms3dScale(lms3dCross(vertex.Position, side.Last.Position), scale * side.NextInverse),
      lms3dScale(lms3dCross(side.Next.Position, vertex.Position), scale * side.LastInverse));
}

lms3dVertexFit::ColumnShares::ColumnShares(
  const lms3dBeamSphere& sphere, const Triangle& triangle, int column)
  : Cosines(sphere.GetCosines())
  , Sines(sphere.GetSines())
  , OwnUp(triangle.Own[2])
  , RestUp(triangle.Rest[2])
{
  const std::array<double, 2>& level = sphere.GetHorizontal(column);
  this->OwnLevel = triangle.Own[0] * level[0] + triangle.Own[1] * level[1];
  this->RestLevel = triangle.Rest[0] * level[0] + triangle.Rest[1] * level[1];
}

bool lms3dVertexFit::Add(const lms3dTriangleCorner& vertex, const Side& side)
{
  const Triangle triangle(this->Beams.GetSphere(), vertex, side);
  return this->Sum.IsPossible() &&
    triangle.Beams.ForEachColumnWhile(
      [&](int column, int first, int last)
      {
        this->AddColumn(triangle, column, { first, last });
        return this->Sum.IsPossible();
      });
}

void lms3dVertexFit::AddColumn(const Triangle& triangle, int column, const Rows& rows)
{
  const lms3dBeamSphere& sphere = this->Beams.GetSphere();
  const lms3dBeamDemands::Demands demands = this->Beams[sphere.GetIndex(column, 0)];
  const ColumnShares shares(sphere, triangle, column);
  if (!KeepsInterval(demands, shares, rows, this->Sum))
  {
    Narrow(demands, shares, rows, this->Sum);
  }
  AddSquares(sphere.GetRanges() + sphere.GetIndex(column, 0), demands, shares, rows, this->Sum);
}

// Whether no beam narrows the interval, which takes no division to see. Without branches, so that
// the compiler makes it a loop over vectors. Few columns have a beam that does.
LMS3D_WIDE_LOOPS
bool lms3dVertexFit::KeepsInterval(const lms3dBeamDemands::Demands& demands,
  const ColumnShares& shares, const Rows& rows, const Sums& sums)
{
  const double minimum = sums.Minimum;
  const double maximum = sums.Maximum;
  std::int64_t uncertain = 0;
  for (int row = rows.First; row <= rows.Last; ++row)
  {
    const double share = shares.GetOwn(row);
    const double others = shares.GetRest(row);
    const bool isInside = ((demands.Minimum[row] - others) * Rounding < minimum * share) &
      (demands.Maximum[row] - others > maximum * share * Rounding);
    const bool demandsNothing = (demands.Minimum[row] < 0.0) | (share < MinimumShare);
    uncertain += (isInside | demandsNothing) ? 0 : 1;
  }
  return uncertain == 0;
}

void lms3dVertexFit::Narrow(const lms3dBeamDemands::Demands& demands, const ColumnShares& shares,
  const Rows& rows, Sums& sums)
{
  for (int row = rows.First; row <= rows.Last; ++row)
  {
    const double share = shares.GetOwn(row);
    const double others = shares.GetRest(row);
    if (demands.Minimum[row] < 0.0 || share < MinimumShare)
    {
      continue;
    }
    const double low = demands.Minimum[row] - others;
    const double high = demands.Maximum[row] - others;
    if (!(low * Rounding < sums.Minimum * share))
    {
      sums.Minimum = std::max(sums.Minimum, low / share);
    }
    if (!(high > sums.Maximum * share * Rounding))
    {
      sums.Maximum = std::min(sums.Maximum, high / share);
    }
  }
}

// The compiler makes loops over vectors of what has no branches. Sums keep the order of the rows.
LMS3D_WIDE_LOOPS
void lms3dVertexFit::AddSquares(const double* ranges, const lms3dBeamDemands::Demands& demands,
  const ColumnShares& shares, const Rows& rows, Sums& sums)
{
  constexpr int Part = 32;
  double squares[Part];
  double products[Part];
  for (int first = rows.First; first <= rows.Last; first += Part)
  {
    const int count = std::min(Part, rows.Last - first + 1);
    std::int64_t determining = 0;
    for (int i = 0; i < count; ++i)
    {
      const double share = shares.GetOwn(first + i);
      const double range = ranges[first + i];
      const bool counts = !(demands.Minimum[first + i] < 0.0) & !(share < MinimumShare);
      determining += counts & (share >= DeterminingShare) ? 1 : 0;
      // The weight of a difference in inverse range.
      const double weight = range * range * range * range;
      const double difference = 1.0 / range - shares.GetRest(first + i);
      squares[i] = counts ? weight * share * share : 0.0;
      products[i] = counts ? weight * share * difference : 0.0;
    }
    sums.DeterminingBeams += determining;
    for (int i = 0; i < count; ++i)
    {
      sums.Squares += squares[i];
      sums.Products += products[i];
    }
  }
}

bool lms3dVertexFit::Allows(const lms3dBeamDemands& beams, const lms3dTriangleCorner& vertex,
  double inverse, const Side& side)
{
  const lms3dBeamSphere& sphere = beams.GetSphere();
  const Triangle triangle(sphere, vertex, side);
  return inverse >= 0.0 &&
    triangle.Beams.ForEachColumnWhile(
      [&](int column, int first, int last)
      {
        return AllowsColumn(beams[sphere.GetIndex(column, 0)],
          ColumnShares(sphere, triangle, column), { first, last }, inverse);
      });
}

// Without branches, so that the compiler makes it a loop over vectors. Few columns have a beam near
// its limits.
LMS3D_WIDE_LOOPS
bool lms3dVertexFit::AllowsColumn(const lms3dBeamDemands::Demands& demands,
  const ColumnShares& shares, const Rows& rows, double inverse)
{
  std::int64_t uncertain = 0;
  for (int row = rows.First; row <= rows.Last; ++row)
  {
    const double own = shares.GetOwn(row);
    const double share = own * inverse;
    const double others = shares.GetRest(row);
    const double low = demands.Minimum[row] - others;
    const double high = demands.Maximum[row] - others;
    const bool isInside = (low * Rounding < share) & (high > share * Rounding);
    uncertain += (isInside | (own < MinimumShare)) ? 0 : 1;
  }
  return uncertain == 0 || AllowsExactly(demands, shares, rows, inverse);
}

bool lms3dVertexFit::AllowsExactly(const lms3dBeamDemands::Demands& demands,
  const ColumnShares& shares, const Rows& rows, double inverse)
{
  for (int row = rows.First; row <= rows.Last; ++row)
  {
    const double share = shares.GetOwn(row);
    const double others = shares.GetRest(row);
    if (!(share < MinimumShare) &&
      ((demands.Minimum[row] - others) / share > inverse ||
        (demands.Maximum[row] - others) / share < inverse))
    {
      return false;
    }
  }
  return true;
}

bool lms3dVertexFit::IsDetermined() const
{
  return this->Sum.DeterminingBeams > 0 && this->Sum.IsPossible();
}

double lms3dVertexFit::GetInverse() const
{
  return std::clamp(this->Sum.Products / this->Sum.Squares, this->Sum.Minimum, this->Sum.Maximum);
}
