// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where outlines cross or overlap.
 */
#ifndef lms3dOutlineCrossings_h
#define lms3dOutlineCrossings_h

#include "Fusion/Outlines/lms3dRasterOutline.h"
#include "Triangulation/lms3dOrientation.h"

#include <vector>

/// Returns the points in which edges of the loops cross, corners that lie on other edges, and the
/// corners of equal edges. A point may be there several times. Loops of less than three corners are
/// left out. Different loops with such points cannot be divided into triangles.
std::vector<lms3dPoint2> lms3dFindCrossingEdges(const std::vector<lms3dLoop>& loops);

/// The same. If there are none, returns the corners that loops have in common, since loops may
/// cross in these.
std::vector<lms3dPoint2> lms3dFindCrossings(const std::vector<lms3dLoop>& loops);

#endif
