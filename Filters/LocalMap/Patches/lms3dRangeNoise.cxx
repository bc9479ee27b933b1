// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dRangeNoise.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace
{
// Every eighth column is sampled.
constexpr int Stride = 8;
// The standard deviation of a normal distribution, in medians of the absolute value.
constexpr double DeviationOfMedian = 1.4826;

// Whether one of three beams is filled.
bool HasFilled(const lms3dBeamSphere& sphere, lms3dBeamSphere::GridIndex index, int step)
{
  return sphere.IsFilled(index - step) || sphere.IsFilled(index) || sphere.IsFilled(index + step);
}

void AppendResiduals(const lms3dBeamSphere& sphere, int column, std::vector<double>& residuals)
{
  residuals.reserve(sphere.GetNumberOfRows());
  const double* ranges = sphere.GetRanges() + sphere.GetIndex(column, 0);
  const double* cosines = sphere.GetCosines();
  const double* sines = sphere.GetSines();
  for (int row = 1; row + 1 < sphere.GetNumberOfRows(); ++row)
  {
    if (ranges[row - 1] > 0.0 && ranges[row] > 0.0 && ranges[row + 1] > 0.0 &&
      !HasFilled(sphere, sphere.GetIndex(column, row), 1))
    {
      // The cosine of half of the angle from the row below to the row above.
      const double cosine = 0.5 *
        (cosines[row] * (cosines[row - 1] + cosines[row + 1]) +
          sines[row] * (sines[row - 1] + sines[row + 1]));
      residuals.push_back(
        std::abs(1.0 / ranges[row - 1] + 1.0 / ranges[row + 1] - 2.0 * cosine / ranges[row]) *
        ranges[row] * ranges[row]);
    }
  }
}
// The same along the beams' own rays, among rows that were measured in one turn of the mirror:
// these start together and lie in one plane.
void AppendResidualsOnRays(
  const lms3dBeamSphere& sphere, int column, std::vector<double>& residuals)
{
  const int step = sphere.GetInterlacedRows();
  for (int row = step; row + step < sphere.GetNumberOfRows(); ++row)
  {
    const lms3dBeamSphere::GridIndex index = sphere.GetIndex(column, row);
    const double below = sphere.GetRangeOnBeam(index - step);
    const double range = sphere.GetRangeOnBeam(index);
    const double above = sphere.GetRangeOnBeam(index + step);
    if (below > 0.0 && range > 0.0 && above > 0.0 && !HasFilled(sphere, index, step))
    {
      const lms3dBeamRays& rays = sphere.GetRays();
      const double cosine = 0.5 *
        lms3dDot(rays[index].Direction,
          lms3dAdd(rays[index - step].Direction, rays[index + step].Direction));
      residuals.push_back(
        std::abs(1.0 / below + 1.0 / above - 2.0 * cosine / range) * range * range);
    }
  }
}
} // namespace

double lms3dEstimateNoise(const lms3dBeamSphere& sphere)
{
  const int samples = (sphere.GetNumberOfColumns() + Stride - 1) / Stride;
  std::vector<std::vector<double>> ofSamples(samples);
  tbb::parallel_for(0, samples,
    [&](int sample)
    {
      sphere.IsRegular() ? AppendResiduals(sphere, sample * Stride, ofSamples[sample])
                         : AppendResidualsOnRays(sphere, sample * Stride, ofSamples[sample]);
    });
  // In the order of the columns: tiny ranges make residuals that are no numbers, and then the
  // median depends on the order.
  std::vector<double> residuals;
  for (const std::vector<double>& ofSample : ofSamples)
  {
    residuals.insert(residuals.end(), ofSample.begin(), ofSample.end());
  }
  return lms3dGetNoiseOfResiduals(residuals);
}

double lms3dGetNoiseOfResiduals(std::vector<double>& residuals)
{
  if (residuals.empty())
  {
    return 0.0;
  }
  const auto median = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::nth_element(residuals.begin(), median, residuals.end());
  return DeviationOfMedian * *median / std::sqrt(6.0);
}
