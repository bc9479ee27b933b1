// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A triangle in the sensor frame, and exact tests of whether beams hit it.
 *
 * With the corners a, b, c relative to the sensor, a beam along d passes inside the triangle if the
 * three edge functions d.(b x c), d.(c x a), d.(a x b) have the same sign. Two triangles that share
 * an edge compute the same number for that edge, except for its sign, so no beam passes between
 * them.
 *
 * A triangle is closed (an edge or a corner counts as a hit) and has two sides. A beam in its plane
 * never hits it, and a triangle without area is never hit.
 *
 * Corners and origin are in world coordinates, metres. Determinants are sums without rounding
 * (lms3dExactSum) of coordinate differences without rounding (lms3dTwoDifference).
 */
#ifndef lms3dTriangle_h
#define lms3dTriangle_h

#include "Geometry/lms3dTriangleMesh.h"
#include "Kernels/lms3dPacketKernels.h"

/// Returns the corners relative to the sensor, each coordinate rounded once.
inline lms3dSensorFrameTriangle lms3dToSensorFrame(
  const lms3dCorners& corners, const double origin[3])
{
  lms3dSensorFrameTriangle triangle;
  for (int corner = 0; corner < 3; ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      triangle.Corner[corner][axis] = corners[corner][axis] - origin[axis];
    }
  }
  return triangle;
}

/// Returns whether a beam passes inside, by exact arithmetic. For the beams that double precision
/// leaves undecided.
bool lms3dIsInside(const lms3dCorners& corners, const double origin[3], const double direction[3]);

/// Returns the directions of the corners, rounded to single precision. Corners within 1e-300 m
/// count as at the sensor.
lms3dCornerDirections lms3dGetCornerDirections(const lms3dSensorFrameTriangle& triangle);

/// Returns whether the corners do not lie on one line, with exact arithmetic.
bool lms3dHasArea(const lms3dCorners& corners);

/// Returns 1 if the corners are counter-clockwise as the sensor sees them and -1 if they are
/// clockwise, with exact arithmetic. Returns 0 if the triangle has no area or its plane contains
/// the sensor.
int lms3dGetSide(const lms3dCorners& corners, const double origin[3]);

/// Returns whether lms3dGetSide is 0. No beam hits such a triangle.
inline bool lms3dIsEdgeOn(const lms3dCorners& corners, const double origin[3])
{
  return lms3dGetSide(corners, origin) == 0;
}

/// Returns whether the sensor is so near to the triangle's plane that the 31 digits of `plane` are
/// not enough for a range.
bool lms3dIsNearPlane(
  const lms3dCorners& corners, const double origin[3], const lms3dDoubleDoublePlane& plane);

///@{
/// Computes the range of a beam in such a plane, or of all beams of a packet, metres: two exact
/// determinants, each rounded once, and their quotient.
double lms3dIntersectNearPlane(
  const lms3dCorners& corners, const double origin[3], const double direction[3]);
void lms3dIntersectNearPlane(const lms3dCorners& corners, const double origin[3],
  const lms3dBeamPacket& packet, double* ranges);
///@}

#endif
