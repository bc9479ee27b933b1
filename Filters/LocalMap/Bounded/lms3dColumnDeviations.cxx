// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dColumnDeviations.h"

#include "Geometry/lms3dWideLoops.h"

#include <cstdint>

namespace
{
// More than a few operations round.
constexpr double Rounding = 1e-12;
} // namespace

// Without branches, so that the compiler makes it a loop over vectors.
LMS3D_WIDE_LOOPS
bool lms3dAreWithin(const lms3dBeamSphere& sphere, const lms3dColumnPlane& plane, int column,
  int firstRow, int lastRow, double limit)
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
