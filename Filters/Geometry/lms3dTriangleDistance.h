// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The distance of a point from a triangle, and a triangle's normal. Any units.
 */
#ifndef lms3dTriangleDistance_h
#define lms3dTriangleDistance_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Geometry/lms3dVector.h"

/// Returns the distance to the nearest point of a triangle. A triangle without area counts as its
/// edges.
double lms3dGetDistance(const double point[3], const lms3dCorners& corners);

inline double lms3dGetDistance(
  const lms3dVector& point, const lms3dVector& a, const lms3dVector& b, const lms3dVector& c)
{
  return lms3dGetDistance(point.data(), { a.data(), b.data(), c.data() });
}

/// Returns the normal by the right-hand rule. Its length is twice the triangle's area.
lms3dVector lms3dGetWeightedNormal(const lms3dCorners& corners);

#endif
