// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The places to which corners of outlines may move.
 */
#ifndef lms3dCornerPlaces_h
#define lms3dCornerPlaces_h

#include "Triangulation/lms3dOrientation.h"

#include <array>
#include <vector>

/// Returns the places of one corner instead of two or more between a first and a last point, the
/// best ones first: where lines through the two ends and corners near them meet, and the corners
/// themselves. Two corners have places between them, too.
std::vector<lms3dPoint2> lms3dFindMergedPlaces(const std::vector<lms3dPoint2>& points);

/// Returns how the second of three corners moves if edges beside it move outwards by one: both of
/// them, the second one alone, the first one alone. The region is on the left of the edges. Ways
/// are at most two cells long. Leaves ways out where the outline turns back, or hardly turns.
std::vector<lms3dPoint2> lms3dFindWaysOutwards(const std::array<lms3dPoint2, 3>& corners);

/// Whether the region has an angle below 6.9 degrees at the second of three corners. It is then
/// narrower than a cell up to 8 cells from the corner and farther, so returns there would lie
/// beside it. The region is on the left of the edges.
bool lms3dIsSharpCorner(const std::array<lms3dPoint2, 3>& corners);

#endif
