// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ranges of beams that start at points of their own in a triangle's plane.
 */
#ifndef lms3dFreePlane_h
#define lms3dFreePlane_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dPacketKernels.h"

#include <cstdint>

/// Computes the plane of a triangle in world coordinates, metres.
lms3dFreePlane lms3dMakeFreePlane(const lms3dCorners& corners);

/// Computes the ranges of some beams of a packet in a plane, metres, with all digits of a double.
/// The ranges of the other beams are undefined.
void lms3dIntersectFreePlane(const lms3dCorners& corners, const lms3dFreePlane& plane,
  std::uint32_t beams, const lms3dFreePacket& packet, double* ranges);

#endif
