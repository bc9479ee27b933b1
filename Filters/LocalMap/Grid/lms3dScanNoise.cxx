// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Grid/lms3dScanNoise.h"

#include "Geometry/lms3dAngle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{
constexpr std::int64_t MaximumSamples = 4096;
// The quantile of the samples that noise alone explains: a tenth, but a quarter of a few samples.
constexpr double LowQuantile = 0.1;
constexpr double HighQuantile = 0.25;
constexpr double SamplesBelowLowQuantile = 50.0;
// The estimate's own standard deviations that are added to it.
constexpr double ErrorsAdded = 2.0;

// The share of a normal distribution's absolute values below a number of standard deviations.
double GetShareBelow(double deviations)
{
  return std::erf(deviations / std::sqrt(2.0));
}

// The inverse, for small shares: one step of Newton's method from the slope at 0.
double GetDeviations(double share)
{
  const double slope = std::sqrt(2.0 / lms3dPi);
  const double start = share / slope;
  return start + (share - GetShareBelow(start)) / (slope * std::exp(-0.5 * start * start));
}
} // namespace

double lms3dEstimateScanNoise(const lms3dRangeGrid& grid, int interlaced)
{
  double sine, cosine;
  lms3dSinCosDegrees(interlaced * grid.GetGeometry().GetAlphaStep(), sine, cosine);
  const int beams = grid.GetNumberOfBeams();
  const std::int64_t count = static_cast<std::int64_t>(grid.GetNumberOfTurns()) * beams;
  const std::int64_t stride = count / MaximumSamples + 1;
  std::vector<double> residuals;
  for (std::int64_t i = 0; i < count; i += stride)
  {
    const double* const ranges = grid.GetRanges(static_cast<int>(i / beams));
    const auto beam = static_cast<int>(i % beams);
    if (beam < interlaced || beam + interlaced >= beams)
    {
      continue;
    }
    const double before = ranges[beam - interlaced];
    const double range = ranges[beam];
    const double behind = ranges[beam + interlaced];
    if (before > 0.0 && range > 0.0 && behind > 0.0)
    {
      const double bend = 1.0 / before + 1.0 / behind - 2.0 * cosine / range;
      residuals.push_back(std::abs(bend) * range * range);
    }
  }
  if (residuals.empty())
  {
    return 0.0;
  }
  const auto size = static_cast<double>(residuals.size());
  const double share = std::clamp(SamplesBelowLowQuantile / size, LowQuantile, HighQuantile);
  const auto quantile = residuals.begin() + static_cast<std::ptrdiff_t>(share * size);
  std::nth_element(residuals.begin(), quantile, residuals.end());
  const double error = std::sqrt((1.0 - share) / (share * size));
  return (1.0 + ErrorsAdded * error) * *quantile / (GetDeviations(share) * std::sqrt(6.0));
}
