// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Points spread evenly over a surface: each point stands for the same area.
 */
#ifndef lms3dSurfaceSamples_h
#define lms3dSurfaceSamples_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Geometry/lms3dVector.h"

#include <cstdint>
#include <vector>

/// The area of all triangles, square metres. Counts each triangle once, not once for each side.
double lms3dGetArea(const lms3dTriangleMesh& mesh);

/// Removes degenerate triangles, which have no plane. Keeps the points.
void lms3dDropTrianglesWithoutArea(lms3dTriangleMesh& mesh);

struct lms3dSurfaceSamples
{
  /**
   * Divides the area into `count` equal shares, triangle after triangle, and puts one point into
   * the triangle at the middle of each share. Within a triangle the points follow a low-discrepancy
   * sequence (Roberts 2018, the generalised golden ratio). The same mesh gives the same samples.
   * Requires an area above 0.
   */
  lms3dSurfaceSamples(const lms3dTriangleMesh& mesh, std::int64_t count);

  /// World coordinates, metres.
  std::vector<lms3dVector> Points;
  /// The triangle of each point.
  std::vector<std::uint32_t> Triangles;
};

#endif
