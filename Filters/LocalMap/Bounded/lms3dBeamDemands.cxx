// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dBeamDemands.h"

#include <tbb/parallel_for.h>

#include <limits>

namespace
{
// Leaves room for rounding.
constexpr double BoundShare = 1.0 - 1e-9;
} // namespace

lms3dBeamDemands::lms3dBeamDemands(
  const lms3dBeamSphere& sphere, const lms3dPatches& patches, double maximumError)
  : Sphere(sphere)
  , Demands(new Demand[sphere.GetSize()])
{
  tbb::parallel_for(0, sphere.GetNumberOfColumns(),
    [&](int column) { this->FillColumn(patches, maximumError, column); });
}

void lms3dBeamDemands::FillColumn(const lms3dPatches& patches, double maximumError, int column)
{
  const GridIndex start = this->Sphere.GetIndex(column, 0);
  for (int row = 0; row < this->Sphere.GetNumberOfRows(); ++row)
  {
    const GridIndex index = start + row;
    const double range = this->Sphere.GetRange(index);
    Demand& demand = this->Demands[index];
    demand = { 0.0, std::numeric_limits<double>::infinity(), 0.0, 0.0 };
    if (patches.Labels[index] < 0 || !(range > 0.0) || (column > 0 && this->Sphere.IsPoleRow(row)))
    {
      continue;
    }
    const double error = BoundShare * (maximumError - this->Sphere.GetPoleHalfSpread(row));
    demand.Inverse = 1.0 / range;
    demand.Minimum = 1.0 / (range + error);
    demand.Maximum = range > error ? 1.0 / (range - error) : demand.Maximum;
    demand.Weight = range * range * range * range;
  }
}
