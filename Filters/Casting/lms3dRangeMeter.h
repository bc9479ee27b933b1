// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Measures the range of beams whose triangle is known.
 */
#ifndef lms3dRangeMeter_h
#define lms3dRangeMeter_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dBeamPacket.h"

///@{
/**
 * Sets Range of all beams with a Triangle; takes the hit back where it is not above 0, or too far.
 *
 * The first is right to the last bits of a double. The second keeps about 13 digits, and fewer at a
 * grazing angle: as many fewer as the cosine of the incidence has zeros.
 */
void lms3dMeasureRanges(const lms3dTriangleMesh& mesh, const lms3dViewpoint& viewpoint,
  lms3dBeamPacket* packets, int count);
void lms3dMeasureRangesRoughly(const lms3dTriangleMesh& mesh, const lms3dViewpoint& viewpoint,
  lms3dBeamPacket* packets, int count);
///@}

#endif
