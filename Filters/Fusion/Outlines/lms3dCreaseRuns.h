// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How far a border follows creases.
 */
#ifndef lms3dCreaseRuns_h
#define lms3dCreaseRuns_h

#include "Triangulation/lms3dOrientation.h"

#include <vector>

/// A corner of an outline near which creases were looked for.
struct lms3dSnappedCorner
{
  lms3dPoint2 Point;
  /// Whether the corner moved to a crease.
  bool IsMoved;
};

/// A border that touches a crease now and then, or that leaves it again and again for beams that
/// passed, is free to leave it: its corners count as not moved.
void lms3dFreeShortRuns(std::vector<lms3dSnappedCorner>& corners);

#endif
