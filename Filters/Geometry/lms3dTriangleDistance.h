// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How far a point is from a triangle.
 */
#ifndef lms3dTriangleDistance_h
#define lms3dTriangleDistance_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Geometry/lms3dVector.h"

/// The distance to the nearest point of the triangle; of one without area, to its edges.
double lms3dGetDistance(const double point[3], const lms3dCorners& corners);

inline double lms3dGetDistance(
  const lms3dVector& point, const lms3dVector& a, const lms3dVector& b, const lms3dVector& c)
{
  return lms3dGetDistance(point.data(), { a.data(), b.data(), c.data() });
}

/// The normal by the right-hand rule, as long as twice the triangle's area.
lms3dVector lms3dGetWeightedNormal(const lms3dCorners& corners);

#endif
