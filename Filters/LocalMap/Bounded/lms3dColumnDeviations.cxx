// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dColumnDeviations.h"

#include "Geometry/lms3dWideLoops.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
constexpr int Lanes = 8;
// More than a few operations round.
constexpr double Rounding = 1e-12;
} // namespace

lms3dColumnDeviations::lms3dColumnDeviations(const lms3dBeamSphere& sphere,
  const lms3dColumnPlane& plane, int column, int firstRow, int lastRow, double limit)
{
  this->Measure(sphere, plane, column, firstRow, lastRow, limit);
}

// Without branches, and with a maximum for each lane, so that the compiler makes it a loop over
// vectors.
LMS3D_WIDE_LOOPS
void lms3dColumnDeviations::Measure(const lms3dBeamSphere& sphere, const lms3dColumnPlane& plane,
  int column, int firstRow, int lastRow, double limit)
{
  const double* const ranges = sphere.GetRanges() + sphere.GetIndex(column, 0);
  const double* const halfSpreads = sphere.GetPoleHalfSpreads();
  std::array<double, Lanes> largest{};
  std::array<std::int64_t, Lanes> beyond{};
  const auto measure = [&](int row, int lane)
  {
    const double hit = 1.0 / plane.GetInverseRangeOfRegular(row);
    const double deviation = std::abs(ranges[row] - hit) + halfSpreads[row];
    largest[lane] = deviation > largest[lane] ? deviation : largest[lane];
    beyond[lane] += deviation <= limit ? 0 : 1;
  };
  int row = firstRow;
  for (; row + Lanes <= lastRow + 1; row += Lanes)
  {
    for (int lane = 0; lane < Lanes; ++lane)
    {
      measure(row + lane, lane);
    }
  }
  for (; row <= lastRow; ++row)
  {
    measure(row, 0);
  }
  for (int lane = 0; lane < Lanes; ++lane)
  {
    this->Largest = std::max(this->Largest, largest[lane]);
    this->Beyond += beyond[lane];
  }
}

double lms3dColumnDeviations::GetLargestOfReturns(const lms3dBeamSphere& sphere,
  const lms3dColumnPlane& plane, int column, int firstRow, int lastRow)
{
  double largest = 0.0;
  for (int row = firstRow; row <= lastRow; ++row)
  {
    const lms3dBeamSphere::GridIndex index = sphere.GetIndex(column, row);
    if (!sphere.IsFilled(index))
    {
      const double hit = 1.0 / plane.GetInverseRangeOfRegular(row);
      largest =
        std::max(largest, std::abs(sphere.GetRange(index) - hit) + sphere.GetPoleHalfSpread(row));
    }
  }
  return largest;
}

LMS3D_WIDE_LOOPS
bool lms3dColumnDeviations::AreWithin(const lms3dBeamSphere& sphere, const lms3dColumnPlane& plane,
  int column, int firstRow, int lastRow, double limit)
{
  const double* const ranges = sphere.GetRanges() + sphere.GetIndex(column, 0);
  const double* const halfSpreads = sphere.GetPoleHalfSpreads();
  std::int64_t uncertain = 0;
  for (int row = firstRow; row <= lastRow; ++row)
  {
    const double inverse = plane.GetInverseRangeOfRegular(row);
    const double tolerance = limit - halfSpreads[row];
    const bool isBefore = (ranges[row] - tolerance) * inverse <= 1.0 - Rounding;
    const bool isBehind = (ranges[row] + tolerance) * inverse >= 1.0 + Rounding;
    uncertain += isBefore & isBehind ? 0 : 1;
  }
  return uncertain == 0;
}
