// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Tests each beam against each triangle, for methods without an acceleration structure.
 */
#ifndef lms3dBruteForceCaster_h
#define lms3dBruteForceCaster_h

#include "Casting/lms3dBitMask.h"
#include "Casting/lms3dPacketBeams.h"
#include "Casting/lms3dRayCaster.h"
#include "Casting/lms3dTriangle.h"
#include "Geometry/lms3dVector.h"

/**
 * `TestT` is constructed from a triangle in the sensor frame. Its method double GetRange(const
 * lms3dVector& direction) const returns the range of a beam in metres, or NaN or a number that is
 * not above 0 if the beam misses. Triangles without area, and triangles whose plane contains the
 * sensor, are skipped, because rounding would decide about them.
 */
template <typename TestT>
class lms3dBruteForceCaster final : public lms3dRayCaster
{
public:
  explicit lms3dBruteForceCaster(lms3dTriangleMesh mesh)
    : lms3dRayCaster(std::move(mesh))
  {
  }

  void FindNearest(const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const override
  {
    for (int i = 0; i < count; ++i)
    {
      lms3dSetTriangle(lms3dBeamPacket::NoTriangle, packets[i]);
    }
    // Prepares each triangle once for all packets.
    for (std::size_t triangle = 0; triangle < this->GetMesh().GetNumberOfTriangles(); ++triangle)
    {
      const lms3dCorners corners = lms3dGetCorners(this->GetMesh(), triangle);
      if (lms3dIsEdgeOn(corners, origin.Position))
      {
        continue;
      }
      const TestT test(lms3dToSensorFrame(corners, origin.Position));
      for (int i = 0; i < count; ++i)
      {
        TestPacket(test, static_cast<std::int32_t>(triangle), origin.MaximumRange, packets[i]);
      }
    }
  }

private:
  static void TestPacket(
    const TestT& test, std::int32_t triangle, double maximumRange, lms3dBeamPacket& packet)
  {
    for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
    {
      if (!lms3dHasBit(packet.Active, beam))
      {
        continue;
      }
      const double range = test.GetRange(lms3dGetDirection(packet, beam));
      if (range > 0.0 && range <= maximumRange && range < packet.Range[beam])
      {
        packet.Range[beam] = range;
        packet.Triangle[beam] = triangle;
      }
    }
  }
};

#endif
