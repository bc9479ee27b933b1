// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A crease in the frame of a plane.
 */
#ifndef lms3dCreaseLine_h
#define lms3dCreaseLine_h

#include "Triangulation/lms3dOrientation.h"

#include <utility>
#include <vector>

/// A part of the line in which two planes meet, from `first` to `second` along the line's
/// direction.
using lms3dCreaseParts = std::vector<std::pair<double, double>>;

/// The parts of a line at which two planes end.
struct lms3dCrease
{
  /// As local maps have them.
  lms3dCreaseParts Seen;
  /// The same when they last changed the shapes of the planes: a few cells more do not count.
  lms3dCreaseParts Drawn;
};

/// A line, and the parts of it at which the other plane ends. Coordinates are cells.
struct lms3dCreaseLine
{
  lms3dPoint2 Point;
  /// With length 1.
  lms3dPoint2 Direction;
  /// Along the direction from the point.
  lms3dCrease Parts;
};

#endif
