// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Summarizes a list of errors by four numbers.
 */
#ifndef lms3dErrorStatistics_h
#define lms3dErrorStatistics_h

#include <limits>
#include <vector>

/// In the unit of the errors; NaN without errors.
struct lms3dErrorStatistics
{
  lms3dErrorStatistics() = default;

  /// The errors are 0 or more. They are added in the given order, so that the same list always
  /// gives the same bits.
  explicit lms3dErrorStatistics(std::vector<double> errors);

  double Mean = std::numeric_limits<double>::quiet_NaN();
  double RootMeanSquare = std::numeric_limits<double>::quiet_NaN();
  /// The smallest error that 95 % of the errors do not exceed.
  double Percentile95 = std::numeric_limits<double>::quiet_NaN();
  double Maximum = std::numeric_limits<double>::quiet_NaN();
};

/// The share of the errors, 0 to 1, that do not exceed a tolerance; NaN without errors.
double lms3dGetShareWithin(const std::vector<double>& errors, double tolerance);

#endif
