// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The triangles of outlines.
 */
#ifndef lms3dOutlineTriangles_h
#define lms3dOutlineTriangles_h

#include "Fusion/Outlines/lms3dRasterOutline.h"

#include <array>
#include <optional>
#include <vector>

using lms3dTriangle2 = std::array<lms3dPoint2, 3>;

/// Returns none if outlines cross.
std::optional<std::vector<lms3dTriangle2>> lms3dTriangulateOutlines(
  const std::vector<lms3dLoop>& loops);

#endif
