// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The rays that stand for a beam with a width.
 */
#ifndef lms3dRayFan_h
#define lms3dRayFan_h

#include "Device/lms3dFan.h"
#include "Geometry/lms3dVector.h"
#include "Scan/lms3dDeviceSettings.h"

#include <vector>

class lms3dScanGeometry;

/// A point in the unit disc across a beam: U is in the fan's plane, V perpendicular to it.
struct lms3dDiscPoint
{
  double U;
  double V;
};

/**
 * Returns points that stand for equal parts of the unit disc: the centre, then rings of 6, 12, 18
 * and so on points. The last ring can have fewer. The circles between the rings enclose as many
 * parts of the area as they enclose points, and a ring is at the root mean square of the radii of
 * its two circles.
 *
 * Ring k is turned by k / 3 of the angle between its points. Then the share of the points beyond a
 * straight edge differs from the area by at most 0.55 / sqrt(count), if the last ring is complete.
 */
std::vector<lms3dDiscPoint> lms3dGetDiscPoints(int count);

/// One ray of each beam of a fan.
struct lms3dRayFan
{
  /// The beams themselves.
  explicit lms3dRayFan(const lms3dFan& fan);

  /// The rays through a point of each beam's disc.
  lms3dRayFan(const lms3dScanGeometry& geometry, const lms3dFan& fan,
    const lms3dFootprint& footprint, const lms3dDiscPoint& point);

  /// In the frame of the turn (lms3dPlatform.h), one for each beam: metres, and unit vectors.
  std::vector<lms3dVector> Origins;
  std::vector<lms3dVector> Directions;

  /// The cosine of the angle between a ray and its beam.
  double Cosine = 1.0;
};

#endif
