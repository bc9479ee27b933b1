// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Many errors in four numbers.
 */
#ifndef lms3dErrorStatistics_h
#define lms3dErrorStatistics_h

#include <vector>

struct lms3dErrorStatistics
{
  /// Of at least one error, each 0 or more. Adds in the order given, so that nothing else counts.
  explicit lms3dErrorStatistics(std::vector<double> errors);

  double Mean;
  double RootMeanSquare;
  /// The least error that is not exceeded by 95 of 100.
  double Percentile95;
  double Maximum;
};

/// The share of the errors, 0 to 1, that do not exceed a tolerance.
double lms3dGetShareWithin(const std::vector<double>& errors, double tolerance);

#endif
