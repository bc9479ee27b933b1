// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How far the returns of a column are from a triangle, along their beams.
 */
#ifndef lms3dColumnDeviations_h
#define lms3dColumnDeviations_h

#include "LocalMap/Bounded/lms3dTriangleRasterizer.h"

#include <cstdint>

/**
 * The deviation of a return is the distance along its beam, metres, to the plane of a triangle. At
 * a pole, half of the spread of its returns (lms3dBeamSphere::GetPoleHalfSpread) is added.
 */
struct lms3dColumnDeviations
{
  /// Measures the returns of a column from one row to another, both included. Entries without a
  /// return count as returns at range 0. Beams must be regular.
  lms3dColumnDeviations(const lms3dBeamSphere& sphere, const lms3dColumnPlane& plane, int column,
    int firstRow, int lastRow, double limit);

  /// The largest deviation without filled entries, metres.
  static double GetLargestOfReturns(const lms3dBeamSphere& sphere, const lms3dColumnPlane& plane,
    int column, int firstRow, int lastRow);

  /// Returns true only if all deviations are within the limit. Takes no division; rounding can make
  /// it return false.
  static bool AreWithin(const lms3dBeamSphere& sphere, const lms3dColumnPlane& plane, int column,
    int firstRow, int lastRow, double limit);

  /// The number of deviations that are not within the limit.
  std::int64_t Beyond = 0;
  /// The largest deviation, if all are within the limit.
  double Largest = 0.0;

private:
  void Measure(const lms3dBeamSphere& sphere, const lms3dColumnPlane& plane, int column,
    int firstRow, int lastRow, double limit);
};

#endif
