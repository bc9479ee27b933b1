// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dExactFreeTest.h"

#include "Casting/lms3dBitMask.h"
#include "Casting/lms3dFreePlane.h"
#include "Casting/lms3dPacketBeams.h"
#include "Casting/lms3dTriangle.h"

namespace
{
bool IsInside(const lms3dCorners& corners, const lms3dFreePacket& packet, int beam)
{
  return lms3dIsInside(
    corners, lms3dGetOrigin(packet, beam).data(), lms3dGetDirection(packet, beam).data());
}
} // namespace

lms3dExactFreeTest::lms3dExactFreeTest(const lms3dTriangleMesh& mesh, double maximumRange)
  : Mesh(mesh)
  , MaximumRange(maximumRange)
{
}

std::uint32_t lms3dExactFreeTest::Test(
  std::uint32_t triangle, std::uint32_t beams, lms3dFreePacket& packet) const
{
  const lms3dCorners corners = lms3dGetCorners(this->Mesh, triangle);
  const std::int32_t number = static_cast<std::int32_t>(triangle);
  const lms3dFreeMasks masks =
    this->Kernels.Free.UpdateNearest(corners.data(), number, beams, this->MaximumRange, packet);
  return masks.Uncertain == 0 ? masks.Changed
                              : masks.Changed | this->TestUncertain(number, masks, packet);
}

// Updates the uncertain beams with more digits than double precision gives.
std::uint32_t lms3dExactFreeTest::TestUncertain(
  std::int32_t triangle, const lms3dFreeMasks& masks, lms3dFreePacket& packet) const
{
  const lms3dCorners corners = lms3dGetCorners(this->Mesh, triangle);
  double ranges[lms3dBeamPacket::Size];
  lms3dIntersectFreePlane(corners, lms3dMakeFreePlane(corners), masks.Uncertain, packet, ranges);
  std::uint32_t changed = 0;
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    const double range = ranges[beam];
    if (lms3dHasBit(masks.Uncertain, beam) && range > 0.0 && range <= this->MaximumRange &&
      lms3dIsNearerHit(range, triangle, packet, beam) &&
      (!lms3dHasBit(masks.NeedInsideTest, beam) || IsInside(corners, packet, beam)))
    {
      packet.Range[beam] = range;
      packet.Triangle[beam] = triangle;
      changed |= 1u << beam;
    }
  }
  return changed;
}
