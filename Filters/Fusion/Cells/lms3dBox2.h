// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A box in a plane.
 */
#ifndef lms3dBox2_h
#define lms3dBox2_h

#include "Triangulation/lms3dOrientation.h"

#include <algorithm>
#include <limits>

/// The smallest box with some points, along both axes. A new box has no points and is near nothing.
/// Coordinates have any unit.
struct lms3dBox2
{
  void Add(const lms3dPoint2& point)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], point[axis]);
      this->High[axis] = std::max(this->High[axis], point[axis]);
    }
  }

  /// Whether the boxes are at most `distance` apart along each axis.
  bool IsNear(const lms3dBox2& other, double distance) const
  {
    return this->Low[0] - distance <= other.High[0] && other.Low[0] - distance <= this->High[0] &&
      this->Low[1] - distance <= other.High[1] && other.Low[1] - distance <= this->High[1];
  }

  /// The least coordinates. They are above the largest ones in a box without points.
  lms3dPoint2 Low = { std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() };
  /// The largest coordinates.
  lms3dPoint2 High = { -std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
};

#endif
