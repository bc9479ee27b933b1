// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Searches the triangle nearest to a point.
 */
#ifndef lms3dEmbreePointQuery_h
#define lms3dEmbreePointQuery_h

#include "Casting/lms3dEmbreeTriangles.h"

#include <cstdint>

/// Computes the distances of the candidates that Embree finds.
class lms3dNearestTest
{
public:
  /// Takes a triangle of the mesh. Returns the distance of the nearest triangle so far, metres.
  virtual double Test(std::uint32_t triangle) = 0;

protected:
  ~lms3dNearestTest() = default;
};

/// Calls `test` with all triangles that can be the nearest to a point, and with all others at the
/// same distance. Coordinates are world coordinates. The search ends at a maximum distance, metres.
/// All coordinates of the point must be finite.
void lms3dFindNearestTriangle(const lms3dEmbreeTriangles& triangles, const double point[3],
  double maximumDistance, lms3dNearestTest& test);

#endif
