// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The packet kernel that sums the normals of a map, with all instruction sets of this
 * processor.
 */
#include "Fixtures/VectorFixtures.h"

#include "Kernels/lms3dPacketKernels.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

TEST(PacketKernels, SumTheSameNormalsWithAllInstructions)
{
  std::vector<std::string> sums;
  for (int k = 0; k < lms3dGetNumberOfPacketKernels(); ++k)
  {
    Random random(12);
    lms3dNormalStrip strip = {};
    sums.emplace_back();
    for (int turn = 0; turn < 100; ++turn)
    {
      for (int i = 0; i < lms3dNormalStrip::Points; ++i)
      {
        strip.Triangles[i] = random.GetBits() % 16;
        for (auto& coordinates : strip.Next)
        {
          coordinates[i] = random.Get(-5.0, 5.0);
        }
      }
      lms3dGetPacketKernels(k).AddStrip(strip);
      sums.back().append(reinterpret_cast<const char*>(strip.Sum), sizeof(strip.Sum));
      sums.back().append(reinterpret_cast<const char*>(strip.Scale), sizeof(strip.Scale));
    }
    ASSERT_TRUE(sums[k] == sums[0]) << lms3dGetPacketKernels(k).Name;
  }
}
