// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Asks each beam about each triangle, for methods that have nothing but a test.
 */
#ifndef lms3dBruteForceCaster_h
#define lms3dBruteForceCaster_h

#include "Casting/lms3dRayCaster.h"
#include "Casting/lms3dTriangle.h"

/**
 * `TestT` is made from the corners of a triangle seen from the sensor, and its method
 * double GetRange(const double direction[3]) const returns the range of a beam, or anything not
 * above 0 (or not a number) where it misses. It is not asked about triangles without area, nor
 * about those on whose plane the sensor stands: rounding would put them anywhere.
 */
template <typename TestT>
class lms3dBruteForceCaster final : public lms3dRayCaster
{
public:
  explicit lms3dBruteForceCaster(lms3dTriangleMesh mesh)
    : lms3dRayCaster(std::move(mesh))
  {
  }

  void Choose(const lms3dViewpoint& viewpoint, lms3dBeamPacket* packets, int count) const override
  {
    for (int i = 0; i < count; ++i)
    {
      for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
      {
        packets[i].Range[beam] = lms3dBeamPacket::NoRange;
        packets[i].Triangle[beam] = lms3dBeamPacket::NoTriangle;
      }
    }
    // Each triangle is prepared once for all packets.
    for (std::size_t triangle = 0; triangle < this->GetMesh().GetNumberOfTriangles(); ++triangle)
    {
      const lms3dCorners corners = lms3dGetCorners(this->GetMesh(), triangle);
      if (lms3dIsEdgeOn(corners, viewpoint.Origin))
      {
        continue;
      }
      const TestT test(lms3dSee(corners, viewpoint.Origin));
      for (int i = 0; i < count; ++i)
      {
        TestPacket(test, static_cast<std::int32_t>(triangle), viewpoint.MaximumRange, packets[i]);
      }
    }
  }

private:
  static void TestPacket(
    const TestT& test, std::int32_t triangle, double maximumRange, lms3dBeamPacket& packet)
  {
    for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
    {
      const double direction[3] = { packet.Direction[0][beam], packet.Direction[1][beam],
        packet.Direction[2][beam] };
      const double range = test.GetRange(direction);
      if (range > 0.0 && range <= maximumRange && range < packet.Range[beam])
      {
        packet.Range[beam] = range;
        packet.Triangle[beam] = triangle;
      }
    }
  }
};

#endif
