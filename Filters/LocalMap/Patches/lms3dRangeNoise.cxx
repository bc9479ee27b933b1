// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dRangeNoise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace
{
// One column in so many is asked.
constexpr int Stride = 8;
// Of a normal distribution, in medians of the absolute value.
constexpr double DeviationOfMedian = 1.4826;

void AppendRests(const lms3dBeamSphere& sphere, int column, std::vector<double>& rests)
{
  const double* ranges = sphere.GetRanges() + sphere.GetIndex(column, 0);
  const double* cosines = sphere.GetCosines();
  const double* sines = sphere.GetSines();
  for (int row = 1; row + 1 < sphere.GetNumberOfRows(); ++row)
  {
    if (ranges[row - 1] > 0.0 && ranges[row] > 0.0 && ranges[row + 1] > 0.0)
    {
      // The cosine of half of the step from the row below to the row above.
      const double cosine = 0.5 *
        (cosines[row] * (cosines[row - 1] + cosines[row + 1]) +
          sines[row] * (sines[row - 1] + sines[row + 1]));
      rests.push_back(
        std::abs(1.0 / ranges[row - 1] + 1.0 / ranges[row + 1] - 2.0 * cosine / ranges[row]) *
        ranges[row] * ranges[row]);
    }
  }
}
} // namespace

double lms3dEstimateNoise(const lms3dBeamSphere& sphere)
{
  std::vector<double> rests;
  for (int column = 0; column < sphere.GetNumberOfColumns(); column += Stride)
  {
    AppendRests(sphere, column, rests);
  }
  if (rests.empty())
  {
    return 0.0;
  }
  const auto median = rests.begin() + static_cast<std::ptrdiff_t>(rests.size() / 2);
  std::nth_element(rests.begin(), median, rests.end());
  return DeviationOfMedian * *median / std::sqrt(6.0);
}
