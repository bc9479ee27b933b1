// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dBeamDemands.h"

#include "Geometry/lms3dWideLoops.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace
{
// Leaves room for rounding.
constexpr double BoundShare = 1.0 - 1e-9;
} // namespace

lms3dBeamDemands::lms3dBeamDemands(
  const lms3dBeamSphere& sphere, const lms3dPatches& patches, double maximumError)
  : Sphere(sphere)
  , Minima(sphere.GetSize())
  , Maxima(sphere.GetSize())
{
  tbb::parallel_for(0, sphere.GetNumberOfColumns(),
    [&](int column) { this->FillColumn(patches, maximumError, column); });
}

// Without branches, so that the compiler makes it a loop over vectors.
LMS3D_WIDE_LOOPS
void lms3dBeamDemands::FillColumn(const lms3dPatches& patches, double maximumError, int column)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  const GridIndex start = this->Sphere.GetIndex(column, 0);
  const int rows = this->Sphere.GetNumberOfRows();
  const std::int32_t* const labels = patches.Labels.data() + start;
  const double* const ranges = this->Sphere.GetRanges() + start;
  const double* const halfSpreads = this->Sphere.GetPoleHalfSpreads();
  double* const minima = this->Minima.data() + start;
  double* const maxima = this->Maxima.data() + start;
  for (int row = 0; row < rows; ++row)
  {
    const double range = ranges[row];
    const double error = BoundShare * (maximumError - halfSpreads[row]);
    const bool demands = labels[row] >= 0 && range > 0.0;
    const double nearest = 1.0 / (range - error);
    minima[row] = demands ? 1.0 / (range + error) : -Infinity;
    maxima[row] = demands && range > error ? nearest : Infinity;
  }
  for (int row = 0; column > 0 && row < rows; row += std::max(1, rows - 1))
  {
    if (this->Sphere.IsPoleRow(row))
    {
      minima[row] = -Infinity;
      maxima[row] = Infinity;
    }
  }
}
