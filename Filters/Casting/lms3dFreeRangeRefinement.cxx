// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dFreeRangeRefinement.h"

#include "Casting/lms3dBitMask.h"
#include "Casting/lms3dFreePlane.h"
#include "Casting/lms3dHitRanges.h"
#include "Casting/lms3dPacketBeams.h"
#include "Casting/lms3dPlaneCache.h"

#include <limits>

namespace
{
// Enough for the packets of one call.
constexpr int EntriesOfCall = 64;

/// Intersects beams with a triangle's plane, with about 31 digits.
class DoubleDoubleIntersector
{
public:
  explicit DoubleDoubleIntersector(const lms3dTriangleMesh& mesh)
    : Mesh(mesh)
  {
  }

  void Intersect(std::int32_t triangle, const lms3dFreePacket& packet, double* ranges)
  {
    const lms3dCorners corners = lms3dGetCorners(this->Mesh, triangle);
    const lms3dFreePlane& plane =
      this->Planes.Get(triangle, [&](std::int32_t) { return lms3dMakeFreePlane(corners); });
    lms3dIntersectFreePlane(
      corners, plane, lms3dFindBeams(triangle, packet.Active, packet), packet, ranges);
  }

private:
  const lms3dTriangleMesh& Mesh;
  lms3dPlaneCache<lms3dFreePlane, EntriesOfCall> Planes;
};

/// The same in double precision. If that cannot represent the plane of a beam well, the plane is
/// computed with more digits and rounded.
class DoubleIntersector
{
public:
  explicit DoubleIntersector(const lms3dTriangleMesh& mesh)
    : Mesh(mesh)
  {
  }

  void Intersect(std::int32_t triangle, const lms3dFreePacket& packet, double* ranges) const
  {
    const lms3dCorners corners = lms3dGetCorners(this->Mesh, triangle);
    std::uint32_t remaining = lms3dFindBeams(triangle, packet.Active, packet) &
      ~this->Kernels.Free.IntersectDoublePlane(corners.data(), packet, ranges);
    while (remaining != 0)
    {
      const int beam = lms3dGetFirstBit(remaining);
      remaining &= remaining - 1;
      ranges[beam] = this->GetRange(corners, packet, beam);
    }
  }

private:
  double GetRange(const lms3dCorners& corners, const lms3dFreePacket& packet, int beam) const
  {
    const lms3dDoubleDoublePlane plane =
      this->Kernels.MakeDoubleDoublePlane(corners.data(), lms3dGetOrigin(packet, beam).data());
    const lms3dVector normal = { plane.Normal[0].High, plane.Normal[1].High, plane.Normal[2].High };
    return plane.Offset.High / lms3dDot(lms3dGetDirection(packet, beam), normal);
  }

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dTriangleMesh& Mesh;
};
} // namespace

void lms3dRefineFreeRangesInDouble(
  const lms3dTriangleMesh& mesh, double maximumRange, lms3dFreePacket* packets, int count)
{
  DoubleIntersector intersector(mesh);
  lms3dStoreHitRanges(intersector, maximumRange, packets, count);
}

void lms3dRefineFreeRanges(const lms3dTriangleMesh& mesh, lms3dFreePacket* packets, int count)
{
  DoubleDoubleIntersector intersector(mesh);
  lms3dStoreHitRanges(intersector, std::numeric_limits<double>::infinity(), packets, count);
}
