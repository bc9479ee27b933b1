// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The echoes of the rays of one beam, and the one that a device reports.
 */
#ifndef lms3dEchoes_h
#define lms3dEchoes_h

#include <vector>

/// What a beam reports.
struct lms3dEcho
{
  /// Metres, NaN if no ray has a return.
  double Range;

  /// The ray of the echo with the smallest number. -1 if there is none.
  int Ray;
};

/**
 * Rays whose ranges exceed that of the nearest ray by at most the length of the pulse form one
 * echo. The rays beyond form further echoes in the same way. The device reports the mean range of
 * the echo with the most rays; of equal ones, of the nearest.
 */
class lms3dEchoes
{
public:
  /// Metres.
  explicit lms3dEchoes(double pulseLength)
    : PulseLength(pulseLength)
  {
  }

  /// Takes the ranges of all rays of a beam, metres, NaN without a return. An echo of equal ranges
  /// has this range to the bit.
  lms3dEcho FindReported(const std::vector<double>& ranges);

private:
  bool IsInEcho(double range, double nearest) const
  {
    return range >= nearest && range - nearest <= this->PulseLength;
  }

  double FindStartOfLargest(const std::vector<double>& ranges);

  double PulseLength;
  std::vector<double> Sorted;
};

#endif
