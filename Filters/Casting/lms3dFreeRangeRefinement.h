// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Computes the range of beams whose triangle is known, and which start at points of their
 * own.
 */
#ifndef lms3dFreeRangeRefinement_h
#define lms3dFreeRangeRefinement_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dBeamPacket.h"

///@{
/// Each beam gets what lms3dRefineRangesInDouble and lms3dRangeRefinement give for its start. The
/// second function has no maximum range.
void lms3dRefineFreeRangesInDouble(
  const lms3dTriangleMesh& mesh, double maximumRange, lms3dFreePacket* packets, int count);
void lms3dRefineFreeRanges(const lms3dTriangleMesh& mesh, lms3dFreePacket* packets, int count);
///@}

#endif
