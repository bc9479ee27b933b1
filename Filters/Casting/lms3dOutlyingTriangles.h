// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The few triangles that are far larger, or farther away, than all the others.
 */
#ifndef lms3dOutlyingTriangles_h
#define lms3dOutlyingTriangles_h

#include "Geometry/lms3dTriangleMesh.h"

#include <cstdint>
#include <vector>

/**
 * At most 16 triangles, in increasing order, without which the scene is a hundred times smaller: an
 * endless floor, a backdrop, a stray vertex. None where the scene is of one size.
 *
 * Single precision has so many digits of the whole scene. Whoever uses it for the others is better
 * off with these looked at one by one.
 */
std::vector<std::uint32_t> lms3dFindOutlyingTriangles(const lms3dTriangleMesh& mesh);

#endif
