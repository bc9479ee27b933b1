// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cells of regions, and a judge of their borders.
 */
#ifndef BorderFixtures_h
#define BorderFixtures_h

#include "Fusion/Outlines/lms3dRasterOutline.h"

#include <cstdint>

/// Sets a bit of a cell. Makes its block.
void Set(lms3dRegion::BitsOf bits, std::int32_t u, std::int32_t v, lms3dRegion& region);

bool IsInside(const lms3dPoint2& point, const lms3dLoop& loop);

/// The distance from the edges of a loop, cells.
double GetDistance(const lms3dPoint2& point, const lms3dLoop& loop);

/// Judges the cells of rows 0 to 127 and columns 0 to 255, one by one: returns are inside, or
/// outside at most `reach` cells away, and beams passed outside.
void ExpectLimitsKept(const lms3dLoop& loop, const lms3dRegion& region, double reach);

#endif
