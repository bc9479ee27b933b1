// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Edges and triangles between directions from the sensor, unit vectors.
 */
#ifndef lms3dTriangleOfDirections_h
#define lms3dTriangleOfDirections_h

#include "Geometry/lms3dVector.h"

#include <algorithm>

/// The square of the chord between two directions.
inline double lms3dGetSquareOfChord(const lms3dVector& a, const lms3dVector& b)
{
  const lms3dVector edge = lms3dSubtract(a, b);
  return lms3dDot(edge, edge);
}

/// Positive if the sensor sees the corners counter-clockwise.
inline double lms3dGetTurn(const lms3dVector& a, const lms3dVector& b, const lms3dVector& c)
{
  return lms3dDot(lms3dCross(c, b), a);
}

/// The height of a triangle, as a share of its longest edge.
inline double lms3dGetHeightShare(const lms3dVector& a, const lms3dVector& b, const lms3dVector& c)
{
  return lms3dGetTurn(a, b, c) /
    std::max(
      { lms3dGetSquareOfChord(a, b), lms3dGetSquareOfChord(b, c), lms3dGetSquareOfChord(c, a) });
}

#endif
