// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Polygons of many corners.
 */
#ifndef PolygonFixtures_h
#define PolygonFixtures_h

#include "Geometry/lms3dVector.h"

#include <vector>

using Corners = std::vector<lms3dVector>;

/// A comb of four corners a tooth.
Corners MakeComb(int teeth);

Corners MakeRegularPolygon(int sides, double radius);

/// Returns the upper half of a disk without the upper half of an ellipse.
Corners MakeCrescent(int count, double radius, double far);

/// Returns an equilateral triangle of side 1 whose sides are parabolas that bow inwards by 0.1.
Corners MakeBowedTriangle(int cornersPerSide);

Corners MakeStar(int points);

#endif
