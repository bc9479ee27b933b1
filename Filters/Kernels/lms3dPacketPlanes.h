// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The planes of triangles, one or as many as a packet has beams.
 */
#ifndef lms3dPacketPlanes_h
#define lms3dPacketPlanes_h

#include "Geometry/lms3dTwoSum.h"
#include "Kernels/lms3dBeamPacket.h"

/// The plane of a triangle in the sensor frame, Normal.p = Offset, with about 31 digits. Normal is
/// the cross product of two edges.
struct lms3dDoubleDoublePlane
{
  lms3dDoubleDouble Normal[3];
  lms3dDoubleDouble Offset;
};

/// The same plane in double precision.
struct lms3dDoublePlane
{
  double Normal[3];
  double Offset;

  /// The range of a beam has at least 13 digits if |Normal.direction| is above this number.
  double MinimumSlope;

  /// False if Offset itself has fewer than 13 digits, because the triangle is very narrow or its
  /// plane passes very near to the sensor.
  bool IsWellConditioned;
};

/// The corners of triangles in world coordinates, by corner and axis.
struct lms3dPacketCorners
{
  alignas(64) double Corner[3][3][lms3dBeamPacket::Size];
};

/// Planes as in lms3dDoubleDoublePlane: the three components of Normal, then Offset.
struct lms3dPacketPlanes
{
  /// As many are computed at once.
  static constexpr int Step = 8;

  alignas(64) double High[4][lms3dBeamPacket::Size];
  alignas(64) double Low[4][lms3dBeamPacket::Size];
};

#endif
