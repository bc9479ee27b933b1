// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/lms3dErrorStatistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

lms3dErrorStatistics::lms3dErrorStatistics(std::vector<double> errors)
{
  if (errors.empty())
  {
    return;
  }
  double sum = 0.0;
  double sumOfSquares = 0.0;
  for (double error : errors)
  {
    sum += error;
    sumOfSquares += error * error;
  }
  const double count = static_cast<double>(errors.size());
  this->Mean = sum / count;
  this->RootMeanSquare = std::sqrt(sumOfSquares / count);
  this->Maximum = *std::max_element(errors.begin(), errors.end());
  const auto rank = errors.begin() + static_cast<std::ptrdiff_t>(std::ceil(0.95 * count)) - 1;
  std::nth_element(errors.begin(), rank, errors.end());
  this->Percentile95 = *rank;
}

double lms3dGetShareWithin(const std::vector<double>& errors, double tolerance)
{
  const auto within = std::count_if(
    errors.begin(), errors.end(), [tolerance](double error) { return error <= tolerance; });
  return static_cast<double>(within) / static_cast<double>(errors.size());
}
