// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the corner of a map that is nearest to a return.
 */
#ifndef lms3dNearestCorner_h
#define lms3dNearestCorner_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Geometry/lms3dVector.h"

#include <cstdint>
#include <vector>

/// A beam towards a corner on the border of a map hits or misses it by rounding. In a plain grid
/// all returns are corners.
class lms3dNearestCorner
{
public:
  /// Keeps a reference.
  explicit lms3dNearestCorner(const lms3dTriangleMesh& mesh);

  /// Returns the number of a triangle whose corner is nearest to `point`, of several the smallest,
  /// or -1 if there is none within `distance`.
  std::int32_t FindTriangle(const lms3dVector& point, double distance) const;

private:
  struct Corner
  {
    /// Along a fixed direction.
    double Place;
    std::int32_t Triangle;
    int Number;
  };

  const lms3dTriangleMesh& Mesh;
  /// By place.
  std::vector<Corner> Corners;
};

#endif
