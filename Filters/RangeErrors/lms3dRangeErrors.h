// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The errors of a device's ranges, and how they change the grid of a scan.
 */
#ifndef lms3dRangeErrors_h
#define lms3dRangeErrors_h

#include "Device/lms3dScanGeometry.h"

#include <cstdint>
#include <string>

/// The properties of vtkLMS3DRangeErrorFilter. Lengths are metres.
struct lms3dRangeErrorSettings
{
  double Bias;

  /// One standard deviation.
  double Noise;

  /// 0 stands for no rounding.
  double Resolution;

  int Seed;

  /// Whether no range changes.
  bool AreOff() const { return this->Bias == 0.0 && this->Noise == 0.0 && this->Resolution == 0.0; }
};

/// Returns a text for the user, with the bad value, or an empty string if all values are good.
std::string lms3dFindRangeErrorProblem(const lms3dRangeErrorSettings& settings);

/**
 * Replaces the ranges of a grid (turn by turn, metres, NaN without a return) by what the device
 * reports: bias, noise and resolution, in this order. A range that would not be above 0 and finite
 * becomes NaN. `scan` is a number that differs between the scans of a trajectory. The settings must
 * be good. Uses the threads of the calling TBB arena.
 */
void lms3dAddRangeErrors(const lms3dRangeErrorSettings& settings, std::uint64_t scan,
  const lms3dScanGeometry& geometry, double* grid);

/// Does the same with the ranges of one turn, by the calling thread.
void lms3dAddRangeErrors(
  const lms3dRangeErrorSettings& settings, std::uint64_t scan, int turn, int beams, double* ranges);

/// Returns the number of a scan for its time (seconds): different times have different numbers.
std::uint64_t lms3dGetScanNumber(double time);

#endif
