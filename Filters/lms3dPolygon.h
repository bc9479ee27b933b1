// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cuts a polygon into triangles.
 */
#ifndef lms3dPolygon_h
#define lms3dPolygon_h

#include <array>
#include <vector>

struct lms3dPolygonTriangles
{
  /// False for a polygon that crosses itself; it has no triangles then.
  bool IsSimple;
  /// Indices into the polygon's corners.
  std::vector<std::array<int, 3>> Triangles;
};

/**
 * Clips ears in the polygon's own plane (that of Newell's normal). Concave polygons, repeated
 * corners, very thin ones and holes that a bridge joins to the rim are cut right. A polygon without
 * area has no triangles.
 */
lms3dPolygonTriangles lms3dCutPolygon(const std::vector<std::array<double, 3>>& corners);

#endif
