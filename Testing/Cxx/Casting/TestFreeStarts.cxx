// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Beams that are not cast because they start outside of the scene and pass by.
 */
#include "Fixtures/MeshFixtures.h"

#include "Casting/lms3dNormalization.h"
#include "Casting/lms3dPacketBeams.h"
#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
constexpr int Size = lms3dBeamPacket::Size;

// Beams along the silhouette of a sphere around the origin, from near and far.
void FillPacket(double radius, Random& random, lms3dFreePacket& packet)
{
  for (int beam = 0; beam < Size; ++beam)
  {
    const Vector start = std::pow(10.0, random.Get(-1.0, 12.0)) * random.GetDirection();
    const Vector aim = random.Get(0.9, 1.1) * radius * random.GetDirection();
    const Vector direction = Normalize(aim - start);
    for (int axis = 0; axis < 3; ++axis)
    {
      packet.Origin[axis][beam] = start[axis];
      packet.Direction[axis][beam] = direction[axis];
    }
  }
}
} // namespace

TEST(FreeStarts, ArePassingByOnlyOutsideOfTheConeOfTheScene)
{
  Random random(33);
  const lms3dNormalization normalization(MakeCube(1));
  const lms3dSceneFrame frame = { { normalization.GetCenter(0), normalization.GetCenter(1),
                                    normalization.GetCenter(2) },
    normalization.GetDiagonal() };
  int passing = 0;
  for (int i = 0; i < 5000; ++i)
  {
    lms3dFreePacket packet;
    FillPacket(0.5 * frame.Unit, random, packet);
    float x[Size], y[Size], z[Size];
    float* const starts[3] = { x, y, z };
    const lms3dFreeStarts located =
      lms3dGetPacketKernels().Free.LocateStarts(frame, packet, starts);
    for (int beam = 0; beam < Size; ++beam)
    {
      const lms3dCone cone = normalization.GetCone(lms3dGetOrigin(packet, beam).data());
      const lms3dVector axis = { cone.Axis[0], cone.Axis[1], cone.Axis[2] };
      const bool isInCone = lms3dDot(lms3dGetDirection(packet, beam), axis) >= cone.Minimum;
      const bool isPassingBy = (located.PassingBy >> beam) & 1u;
      ASSERT_FALSE(isPassingBy && isInCone);
      ASSERT_FALSE(((located.Inside >> beam) & 1u) && cone.Minimum >= 0.0);
      passing += isPassingBy;
    }
  }
  EXPECT_GT(passing, 1000);
}
