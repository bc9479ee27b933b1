// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The angles of the rows and columns of lms3dBeamSphere.
 */
#ifndef lms3dGridLines_h
#define lms3dGridLines_h

#include <vector>

/// A row or column of lms3dBeamSphere.
struct lms3dGridLine
{
  /// The elevation or platform angle, degrees.
  double Angle;
  /// The beam or turn of the scan, -1 in the halo.
  int ScanIndex;
};

/**
 * Sorts the elevations of a scan, degrees, and adds rows of the halo: `step` degrees below and
 * above the scan, except at poles, and between rows more than 120 degrees apart. Throws
 * std::runtime_error, with a message for the user, if angles are not strictly monotonic or exceed
 * 90 degrees. There must be an angle. If not `arePoles`, rows at 90 degrees are no poles, and get a
 * neighbour in the halo at the same elevation.
 */
std::vector<lms3dGridLine> lms3dMakeRowLines(
  const std::vector<double>& angles, double step, bool arePoles = true);

/**
 * The same for platform angles. If they are not `isClosed`, columns of the halo complete the
 * circle. Throws std::runtime_error as well if open angles span 360 degrees or more.
 */
std::vector<lms3dGridLine> lms3dMakeColumnLines(
  const std::vector<double>& angles, double step, bool isClosed);

/// Adds two columns of the halo where turns before `seam` lie next to others, so that the map does
/// not join these. Returns the lines as they are if `seam` is 0.
std::vector<lms3dGridLine> lms3dAddSeams(
  const std::vector<lms3dGridLine>& lines, int seam, bool isClosed);

#endif
