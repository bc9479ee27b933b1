// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the few triangles that are far larger, or much farther away, than all others.
 */
#ifndef lms3dOutlyingTriangles_h
#define lms3dOutlyingTriangles_h

#include "Geometry/lms3dTriangleMesh.h"

#include <cstdint>
#include <vector>

/**
 * Returns at most 16 triangles, in increasing order, without which the scene is a hundred times
 * smaller: an endless floor, a backdrop, a stray vertex. Returns none if there are no such
 * triangles. Uses the threads of the calling TBB arena.
 *
 * Single precision resolves a fixed share of the scene's size. If the caller tests the outliers one
 * by one, single precision resolves the rest a hundred times better.
 */
std::vector<std::uint32_t> lms3dFindOutlyingTriangles(const lms3dTriangleMesh& mesh);

/// Returns all triangles but the outliers, which are in increasing order; an empty list if there
/// are none.
std::vector<std::uint32_t> lms3dFindOtherTriangles(
  const lms3dTriangleMesh& mesh, const std::vector<std::uint32_t>& outliers);

#endif
