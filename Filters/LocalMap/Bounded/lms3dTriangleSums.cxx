// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dTriangleSums.h"

#include "Geometry/lms3dWideLoops.h"

#include <algorithm>
#include <cstdint>

namespace
{
// Radians by which a beam may pass outside of a triangle that it hits, as in lms3dVertexFit.
constexpr double Margin = 1e-9;
// About the largest number of columns of a triangle that count, and of rows of a column.
constexpr int MaximumSamples = 16;

// A vector, multiplied with the beams of a column.
struct ColumnVector
{
  ColumnVector(const lms3dVector& vector, const std::array<double, 2>& horizontal)
    : Level(vector[0] * horizontal[0] + vector[1] * horizontal[1])
    , Up(vector[2])
  {
  }

  double Get(double cosine, double sine) const { return this->Level * cosine + this->Up * sine; }

  double Level;
  double Up;
};
} // namespace

lms3dTriangleSums::lms3dTriangleSums(const lms3dBeamDemands& demands, const Triangle& triangle)
{
  if (!(GetVolume(triangle) > 0.0))
  {
    return;
  }
  const auto& [a, b, c] = triangle.Corners;
  const Vectors shares = GetShares(triangle);
  const lms3dVector plane = GetPlane(shares, triangle);
  const lms3dTriangleRasterizer rasterizer(demands.GetSphere(), *a, *b, *c, Margin);
  const int columnStep = 1 + rasterizer.GetNumberOfColumns() / MaximumSamples;
  BeamSums beams;
  rasterizer.ForEachColumnOf([columnStep](int column) { return column % columnStep == 0; },
    [&](int column, int first, int last)
    {
      const int rowStep = 1 + (last - first + 1) / MaximumSamples;
      beams.Add(this->AddUp(demands, { column, first, last }, rowStep, shares, plane),
        static_cast<double>(columnStep) * rowStep, demands.GetSphere().GetHorizontal(column));
      return true;
    });
  this->SetSums(beams, shares);
}

// The volume of the parallelepiped of the corners.
double lms3dTriangleSums::GetVolume(const Triangle& triangle)
{
  return lms3dDot(lms3dCross(triangle.Corners[2]->Position, triangle.Corners[1]->Position),
    triangle.Corners[0]->Position);
}

// The vectors o_i.
lms3dTriangleSums::Vectors lms3dTriangleSums::GetShares(const Triangle& triangle)
{
  const lms3dVector& a = triangle.Corners[0]->Position;
  const lms3dVector& b = triangle.Corners[1]->Position;
  const lms3dVector& c = triangle.Corners[2]->Position;
  const double scale = 1.0 / GetVolume(triangle);
  return { lms3dScale(lms3dCross(c, b), scale), lms3dScale(lms3dCross(a, c), scale),
    lms3dScale(lms3dCross(b, a), scale) };
}

// The inverse range in a direction is its product with this vector.
lms3dVector lms3dTriangleSums::GetPlane(const Vectors& shares, const Triangle& triangle)
{
  const std::array<double, 3>& inverses = triangle.Inverses;
  return lms3dAdd(lms3dScale(shares[0], inverses[0]),
    lms3dAdd(lms3dScale(shares[1], inverses[1]), lms3dScale(shares[2], inverses[2])));
}

lms3dTriangleSums::ColumnSums lms3dTriangleSums::AddUp(const lms3dBeamDemands& demands,
  const Span& span, int step, const Vectors& shares, const lms3dVector& plane)
{
  const lms3dBeamSphere& sphere = demands.GetSphere();
  const lms3dBeamDemands::Demands column = demands[sphere.GetIndex(span.Column, 0)];
  const double* const ranges = sphere.GetRanges() + sphere.GetIndex(span.Column, 0);
  const std::array<double, 2>& horizontal = sphere.GetHorizontal(span.Column);
  const ColumnVector ofPlane(plane, horizontal);
  const ColumnVector ofShares[3] = { { shares[0], horizontal }, { shares[1], horizontal },
    { shares[2], horizontal } };
  ColumnSums sums;
  for (int row = span.First + (span.Last - span.First) % step / 2; row <= span.Last; row += step)
  {
    const double cosine = sphere.GetCosines()[row];
    const double sine = sphere.GetSines()[row];
    const double inverse = ofPlane.Get(cosine, sine);
    if (column.Minimum[row] < 0.0 || inverse < column.Minimum[row] || inverse > column.Maximum[row])
    {
      continue;
    }
    const double square = ranges[row] * ranges[row];
    const double weight = square * square;
    sums.CosineCosine += weight * cosine * cosine;
    sums.CosineSine += weight * cosine * sine;
    sums.SineSine += weight * sine * sine;
    sums.Cosine += square * ranges[row] * cosine;
    sums.Sine += square * ranges[row] * sine;
    for (int i = 0; i < 3; ++i)
    {
      this->LargestShares[i] = std::max(this->LargestShares[i], ofShares[i].Get(cosine, sine));
    }
  }
  return sums;
}

void lms3dTriangleSums::BeamSums::Add(
  const ColumnSums& column, double weight, const std::array<double, 2>& horizontal)
{
  const double x = horizontal[0];
  const double y = horizontal[1];
  this->Squares[0][0] += weight * column.CosineCosine * x * x;
  this->Squares[0][1] += weight * column.CosineCosine * x * y;
  this->Squares[1][1] += weight * column.CosineCosine * y * y;
  this->Squares[0][2] += weight * column.CosineSine * x;
  this->Squares[1][2] += weight * column.CosineSine * y;
  this->Squares[2][2] += weight * column.SineSine;
  this->Products[0] += weight * column.Cosine * x;
  this->Products[1] += weight * column.Cosine * y;
  this->Products[2] += weight * column.Sine;
}

void lms3dTriangleSums::SetSums(const BeamSums& beams, const Vectors& shares)
{
  const Vectors& squares = beams.Squares;
  for (int j = 0; j < 3; ++j)
  {
    const lms3dVector& share = shares[j];
    const lms3dVector product = { squares[0][0] * share[0] + squares[0][1] * share[1] +
        squares[0][2] * share[2],
      squares[0][1] * share[0] + squares[1][1] * share[1] + squares[1][2] * share[2],
      squares[0][2] * share[0] + squares[1][2] * share[1] + squares[2][2] * share[2] };
    for (int i = 0; i < 3; ++i)
    {
      this->Squares[i][j] = lms3dDot(shares[i], product);
    }
    this->Products[j] = lms3dDot(share, beams.Products);
  }
}

double lms3dTriangleSums::GetSum(const std::array<double, 3>& inverses) const
{
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    double slope = -2.0 * this->Products[i];
    for (int j = 0; j < 3; ++j)
    {
      slope += this->Squares[i][j] * inverses[j];
    }
    sum += slope * inverses[i];
  }
  return sum;
}

bool lms3dTriangleSums::IsWithinBound(const lms3dBeamDemands& demands, const Triangle& triangle)
{
  const auto& [a, b, c] = triangle.Corners;
  const lms3dVector plane = GetPlane(GetShares(triangle), triangle);
  return lms3dTriangleRasterizer(demands.GetSphere(), *a, *b, *c, Margin)
    .ForEachColumnWhile(
      [&](int column, int first, int last)
      {
        const ColumnVector onColumn(plane, demands.GetSphere().GetHorizontal(column));
        return IsColumnWithinBound(demands, { column, first, last }, onColumn.Level, onColumn.Up);
      });
}

// Without branches, so that the compiler makes it a loop over vectors.
LMS3D_WIDE_LOOPS
bool lms3dTriangleSums::IsColumnWithinBound(
  const lms3dBeamDemands& demands, const Span& span, double level, double up)
{
  const lms3dBeamSphere& sphere = demands.GetSphere();
  const lms3dBeamDemands::Demands column = demands[sphere.GetIndex(span.Column, 0)];
  const double* const cosines = sphere.GetCosines();
  const double* const sines = sphere.GetSines();
  std::int64_t outside = 0;
  for (int row = span.First; row <= span.Last; ++row)
  {
    const double inverse = level * cosines[row] + up * sines[row];
    const bool isInside = (inverse >= column.Minimum[row]) & (inverse <= column.Maximum[row]);
    outside += isInside ? 0 : 1;
  }
  return outside == 0;
}
