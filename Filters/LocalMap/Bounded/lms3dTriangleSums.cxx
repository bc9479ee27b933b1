// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dTriangleSums.h"

#include <algorithm>

namespace
{
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

lms3dTriangleSums::lms3dTriangleSums(const lms3dBeamDemands& demands,
  const lms3dTriangleBeams& beams, const std::array<double, 3>& inverses)
{
  if (!beams.FacesSensor())
  {
    return;
  }
  const lms3dVector plane = beams.GetPlane(inverses);
  const int columnStep = 1 + beams.GetNumberOfColumns() / MaximumSamples;
  const double scale = lms3dTriangleBeams::GetScale(plane);
  BeamSums sums;
  for (const lms3dTriangleBeams::Span& span : beams.GetSpans())
  {
    if (span.Column % columnStep == 0)
    {
      const int rowStep = 1 + (span.Last - span.First + 1) / MaximumSamples;
      sums.Add(this->AddUp(demands, span, rowStep, beams.GetShares(), plane),
        scale * columnStep * rowStep, demands.GetSphere().GetHorizontal(span.Column));
    }
  }
  this->SetSums(sums, beams.GetShares());
}

lms3dTriangleSums::ColumnSums lms3dTriangleSums::AddUp(const lms3dBeamDemands& demands,
  const lms3dTriangleBeams::Span& span, int step, const Shares& shares, const lms3dVector& plane)
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
    const double range = ranges[row];
    const double square = range * range;
    const double ofProducts = lms3dTriangleBeams::GetWeight(range, cosine) * square * range;
    const double ofSquares = ofProducts * range;
    sums.CosineCosine += ofSquares * cosine * cosine;
    sums.CosineSine += ofSquares * cosine * sine;
    sums.SineSine += ofSquares * sine * sine;
    sums.Cosine += ofProducts * cosine;
    sums.Sine += ofProducts * sine;
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

void lms3dTriangleSums::SetSums(const BeamSums& beams, const Shares& shares)
{
  const std::array<lms3dVector, 3>& squares = beams.Squares;
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
