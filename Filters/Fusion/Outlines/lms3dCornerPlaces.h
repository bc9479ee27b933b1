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
#include <optional>
#include <vector>

/// Returns the places of one corner instead of two or more between a first and a last point, the
/// best ones first: where lines through the two ends and corners near them meet, and the corners
/// themselves. Two corners have places between them, too.
std::vector<lms3dPoint2> lms3dFindMergedPlaces(const std::vector<lms3dPoint2>& points);

/// Returns how the second of three corners moves if both edges beside it move outwards by one. The
/// region is on the left of the edges. Returns none if the outline turns back.
std::optional<lms3dPoint2> lms3dFindWayOutwards(const std::array<lms3dPoint2, 3>& corners);

#endif
