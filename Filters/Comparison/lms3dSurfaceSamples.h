// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Points spread over a surface, of which each stands for the same area.
 */
#ifndef lms3dSurfaceSamples_h
#define lms3dSurfaceSamples_h

#include "Geometry/lms3dTriangleMesh.h"

#include <array>
#include <cstdint>
#include <vector>

/// Square metres, both sides counted once.
double lms3dGetArea(const lms3dTriangleMesh& mesh);

/// Such triangles lie in no plane.
void lms3dDropTrianglesWithoutArea(lms3dTriangleMesh& mesh);

struct lms3dSurfaceSamples
{
  /**
   * The middles of `count` equal shares of the area, the triangles taken one after the other; within
   * a triangle by a sequence of low discrepancy (Roberts 2018, the generalised golden ratio). The
   * same mesh gives the same samples. Its area is above 0.
   */
  lms3dSurfaceSamples(const lms3dTriangleMesh& mesh, std::int64_t count);

  std::vector<std::array<double, 3>> Points;
  /// The triangle that each point lies in.
  std::vector<std::uint32_t> Triangles;
};

#endif
