// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The small triangle around a return that no other triangle explains.
 */
#ifndef lms3dFacet_h
#define lms3dFacet_h

#include "Triangulation/lms3dOrientation.h"

#include <array>
#include <cmath>

/// The corners of a facet around a point of a plane. Coordinates are cells.
inline std::array<lms3dPoint2, 3> lms3dMakeFacet(const lms3dPoint2& centre)
{
  constexpr double Circumradius = 0.25;
  const double half = Circumradius * std::sqrt(0.75);
  return { { { centre[0] - half, centre[1] - Circumradius / 2.0 },
    { centre[0] + half, centre[1] - Circumradius / 2.0 },
    { centre[0], centre[1] + Circumradius } } };
}

#endif
