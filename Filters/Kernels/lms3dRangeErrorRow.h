// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the kernels of range errors need: the key of random numbers, and the errors.
 */
#ifndef lms3dRangeErrorRow_h
#define lms3dRangeErrorRow_h

#include <cstdint>

/// The effects that draw random numbers. Each effect has its own numbers, so switching one effect
/// on changes no number of another. A value must never change: results depend on it.
enum class lms3dEffect : std::uint32_t
{
  RANGE_NOISE = 1
};

/**
 * The key of the random numbers of one turn.
 *
 * A number is a function of this key and of the beam alone: the counter-based generator
 * Threefry2x64-20 (Salmon, Moraes, Dror and Shaw, "Parallel random numbers: as easy as 1, 2, 3",
 * 2011) encrypts the counter (effect and turn, pair of beams) with the key (seed, scan). So the
 * numbers depend neither on threads and processes nor on the order of the returns.
 */
struct lms3dDrawKey
{
  std::uint64_t Seed;

  /// Differs between the scans of a trajectory.
  std::uint64_t Scan;

  lms3dEffect Effect;
  std::uint32_t Turn;
};

/// The errors of all ranges of a scan. Lengths are metres.
struct lms3dRangeErrorModel
{
  double Bias;

  /// One standard deviation.
  double Noise;

  /// Whether ranges are multiples of StepNumerator / StepDenominator.
  bool HasSteps;

  ///@{
  /// Two numbers, because the decimal step of a device (0.001) is no double, and its inverse (1000)
  /// is: a reported range is then the double nearest to the decimal number.
  double StepNumerator;
  double StepDenominator;
  ///@}
};

#endif
