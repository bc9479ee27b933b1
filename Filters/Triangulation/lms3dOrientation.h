// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief On which side of a line a point of the plane lies, without rounding.
 */
#ifndef lms3dOrientation_h
#define lms3dOrientation_h

#include <array>

using lms3dPoint2 = std::array<double, 2>;

/// Positive where c lies left of the line from a to b, negative right of it, 0 on it.
int lms3dGetOrientation(const lms3dPoint2& a, const lms3dPoint2& b, const lms3dPoint2& c);

/// True where d lies inside the circle through a, b, c, counter-clockwise, by more than rounding:
/// so of the two diagonals of four points at most one is ever taken for the better.
bool lms3dIsInCircle(
  const lms3dPoint2& a, const lms3dPoint2& b, const lms3dPoint2& c, const lms3dPoint2& d);

#endif
