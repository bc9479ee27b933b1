// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Computes the range of beams whose triangle is known.
 */
#ifndef lms3dRangeRefinement_h
#define lms3dRangeRefinement_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dBeamPacket.h"

///@{
/**
 * Sets Range of all beams of some packets that have a Triangle, metres: the distance to the plane of
 * that triangle. Removes a hit if the range is not above 0 or beyond the maximum. Triangles are
 * indices into the mesh.
 *
 * The first function gives all digits of a double. The second gives about 13 digits. At grazing
 * incidence it gives fewer: each zero after the decimal point of the cosine of incidence costs one.
 */
void lms3dRefineRanges(
  const lms3dTriangleMesh& mesh, const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count);
void lms3dRefineRangesInDouble(
  const lms3dTriangleMesh& mesh, const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count);
///@}

#endif
