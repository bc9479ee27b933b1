// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A box along the axes of the world.
 */
#ifndef lms3dWorldBox_h
#define lms3dWorldBox_h

#include "Geometry/lms3dVector.h"

#include <algorithm>

/// A new box is empty. Metres.
struct lms3dWorldBox
{
  lms3dVector Low = { 1e300, 1e300, 1e300 };
  lms3dVector High = { -1e300, -1e300, -1e300 };

  void Add(const lms3dVector& point)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], point[axis]);
      this->High[axis] = std::max(this->High[axis], point[axis]);
    }
  }

  void Add(const lms3dWorldBox& other)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], other.Low[axis]);
      this->High[axis] = std::max(this->High[axis], other.High[axis]);
    }
  }

  /// Whether a point is nearer than a distance along each axis.
  bool IsNear(const lms3dVector& point, double distance) const
  {
    return this->IsNear(lms3dWorldBox{ point, point }, distance);
  }

  /// Whether another box is nearer than a distance along each axis.
  bool IsNear(const lms3dWorldBox& other, double distance) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (this->High[axis] < other.Low[axis] - distance ||
        this->Low[axis] > other.High[axis] + distance)
      {
        return false;
      }
    }
    return true;
  }
};

#endif
