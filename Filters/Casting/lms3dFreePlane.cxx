// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dFreePlane.h"

#include "Casting/lms3dBitMask.h"
#include "Casting/lms3dPacketBeams.h"
#include "Casting/lms3dTriangle.h"

#include <algorithm>
#include <cmath>

namespace
{
double GetSumOfMagnitudes(const lms3dVector& p)
{
  return std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]);
}
} // namespace

lms3dFreePlane lms3dMakeFreePlane(const lms3dCorners& corners)
{
  // The normal does not depend on the origin.
  const lms3dDoubleDoublePlane atCorner =
    lms3dGetPacketKernels().MakeDoubleDoublePlane(corners.data(), corners[0]);
  lms3dFreePlane plane;
  std::copy_n(atCorner.Normal, 3, plane.Normal);
  std::copy_n(corners[0], 3, plane.Corner);
  for (int edge = 0; edge < 2; ++edge)
  {
    plane.EdgeLengths[edge] = GetSumOfMagnitudes(lms3dSubtract(corners[edge + 1], corners[0]));
  }
  return plane;
}

void lms3dIntersectFreePlane(const lms3dCorners& corners, const lms3dFreePlane& plane,
  std::uint32_t beams, const lms3dFreePacket& packet, double* ranges)
{
  std::uint32_t near = beams & lms3dGetPacketKernels().Free.IntersectPlane(plane, packet, ranges);
  while (near != 0)
  {
    const int beam = lms3dGetFirstBit(near);
    near &= near - 1;
    ranges[beam] = lms3dIntersectNearPlane(
      corners, lms3dGetOrigin(packet, beam).data(), lms3dGetDirection(packet, beam).data());
  }
}
