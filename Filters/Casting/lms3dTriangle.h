// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A triangle seen from the sensor, and exactly where beams pass it.
 *
 * With a, b, c the corners seen from the sensor, a beam along D passes inside the triangle where
 * the three edge functions D.(b x c), D.(c x a), D.(a x b) have one sign. Two triangles that share
 * an edge compute the same number for it but for its sign, so no beam passes between them.
 *
 * A triangle is closed (an edge or a corner counts as a hit) and has two sides. A beam within its
 * own plane, and a triangle without area, are never hit.
 */
#ifndef lms3dTriangle_h
#define lms3dTriangle_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dPacketKernels.h"

inline lms3dSeenTriangle lms3dSee(const lms3dCorners& corners, const double origin[3])
{
  lms3dSeenTriangle seen;
  for (int corner = 0; corner < 3; ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      seen.Corner[corner][axis] = corners[corner][axis] - origin[axis];
    }
  }
  return seen;
}

/// Whether a beam passes inside, without rounding: for those that double leaves in doubt.
bool lms3dIsInside(const lms3dCorners& corners, const double origin[3], const double direction[3]);

/// Whether a triangle's corners are not on one line, without rounding.
bool lms3dHasArea(const lms3dCorners& corners);

/// Whether a triangle has no area, or the sensor stands on its plane, without rounding: then no beam
/// hits it.
bool lms3dIsEdgeOn(const lms3dCorners& corners, const double origin[3]);

/// Whether the sensor stands on a triangle's plane, or so nearly that the plane's 31 digits may put
/// it beside.
bool lms3dIsNearPlane(
  const lms3dCorners& corners, const double origin[3], const lms3dSeenPlane& plane);

/// The ranges of all beams of a packet in such a plane, rounded three times in all.
void lms3dMeasureNearPlane(const lms3dCorners& corners, const double origin[3],
  const lms3dBeamPacket& packet, double* ranges);

#endif
