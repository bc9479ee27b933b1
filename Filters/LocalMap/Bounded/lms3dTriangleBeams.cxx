// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dTriangleBeams.h"

#include "Geometry/lms3dWideLoops.h"

#include <cstdint>

lms3dTriangleBeams::lms3dTriangleBeams(const lms3dBeamSphere& sphere, const Corners& corners)
{
  const lms3dVector& a = corners[0]->Position;
  const lms3dVector& b = corners[1]->Position;
  const lms3dVector& c = corners[2]->Position;
  const lms3dVector opposite = lms3dCross(c, b);
  const double volume = lms3dDot(opposite, a);
  this->IsFacingSensor = volume > 0.0;
  const double scale = 1.0 / volume;
  this->SharesOfCorners = { lms3dScale(opposite, scale), lms3dScale(lms3dCross(a, c), scale),
    lms3dScale(lms3dCross(b, a), scale) };
  const lms3dTriangleRasterizer rasterizer(
    sphere, *corners[0], *corners[1], *corners[2], lms3dTriangleRasterizer::VertexMargin);
  this->NumberOfColumns = rasterizer.GetNumberOfColumns();
  this->Spans.reserve(this->NumberOfColumns);
  rasterizer.ForEachColumn(
    [this](int column, int first, int last) {
      this->Spans.push_back({ column, first, last });
    });
}

lms3dVector lms3dTriangleBeams::GetPlane(const std::array<double, 3>& inverses) const
{
  const Shares& shares = this->SharesOfCorners;
  return lms3dAdd(lms3dScale(shares[0], inverses[0]),
    lms3dAdd(lms3dScale(shares[1], inverses[1]), lms3dScale(shares[2], inverses[2])));
}

bool lms3dTriangleBeams::AreWithinBound(
  const lms3dBeamDemands& demands, const std::array<double, 3>& inverses) const
{
  const Span* const first = this->Spans.data();
  return AreWithin(demands, this->GetPlane(inverses), first, first + this->Spans.size());
}

// Without branches in a column, so that the compiler makes it a loop over vectors.
LMS3D_WIDE_LOOPS
bool lms3dTriangleBeams::AreWithin(
  const lms3dBeamDemands& demands, const lms3dVector& plane, const Span* first, const Span* last)
{
  const lms3dBeamSphere& sphere = demands.GetSphere();
  const double* const cosines = sphere.GetCosines();
  const double* const sines = sphere.GetSines();
  const double up = plane[2];
  std::int64_t outside = 0;
  for (const Span* span = first; span != last && outside == 0; ++span)
  {
    const std::array<double, 2>& horizontal = sphere.GetHorizontal(span->Column);
    const double level = plane[0] * horizontal[0] + plane[1] * horizontal[1];
    const lms3dBeamDemands::Demands column = demands[sphere.GetIndex(span->Column, 0)];
    for (int row = span->First; row <= span->Last; ++row)
    {
      const double inverse = level * cosines[row] + up * sines[row];
      const bool isInside = (inverse >= column.Minimum[row]) & (inverse <= column.Maximum[row]);
      outside += isInside ? 0 : 1;
    }
  }
  return outside == 0;
}

double lms3dTriangleBeams::GetSum(
  const lms3dBeamDemands& demands, const std::array<double, 3>& inverses) const
{
  const lms3dBeamSphere& sphere = demands.GetSphere();
  const lms3dVector plane = this->GetPlane(inverses);
  double sum = 0.0;
  for (const Span& span : this->Spans)
  {
    const std::array<double, 2>& horizontal = sphere.GetHorizontal(span.Column);
    const double level = plane[0] * horizontal[0] + plane[1] * horizontal[1];
    const lms3dBeamSphere::GridIndex start = sphere.GetIndex(span.Column, 0);
    for (int row = span.First; row <= span.Last; ++row)
    {
      const double range = sphere.GetRanges()[start + row];
      const double cosine = sphere.GetCosines()[row];
      const double inverse = level * cosine + plane[2] * sphere.GetSines()[row];
      const double distance = range * (range * inverse - 1.0);
      const bool counts = !(demands[start].Minimum[row] < 0.0);
      sum += counts ? GetWeight(range, cosine) * distance * distance : 0.0;
    }
  }
  return GetScale(plane) * sum;
}
