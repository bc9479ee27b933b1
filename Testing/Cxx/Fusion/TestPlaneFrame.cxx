// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where the cells of planes lie.
 */
#include "Fusion/Planes/lms3dPlaneFrame.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
constexpr double Cell = 0.01 / 3.0; // metres
const lms3dVector Up = { 0.0, 0.0, 1.0 };

lms3dPlaneFrame MakeFloor(const lms3dVector& middle)
{
  return { middle, Up, Cell, middle };
}
} // namespace

TEST(PlaneFrame, BeginsNearTheMiddleByWholeBlocks)
{
  const lms3dVector middle = { 700.0, -30.0, 2.0 };
  const lms3dPlaneFrame frame = MakeFloor(middle);
  const lms3dPoint2 first = frame.ToCells(middle);
  EXPECT_LE(std::abs(first[0]), 0.5 * lms3dRaster::Size);
  EXPECT_LE(std::abs(first[1]), 0.5 * lms3dRaster::Size);
  const lms3dPoint2 origin = frame.ToCells({ 0.0, 0.0, 0.0 });
  EXPECT_EQ(std::remainder(origin[0], lms3dRaster::Size), 0.0);
  EXPECT_EQ(std::remainder(origin[1], lms3dRaster::Size), 0.0);
}

/// Points of scans are at most 6e8 bounds from the origin.
TEST(PlaneFrame, NumbersAllCellsWith32Bits)
{
  constexpr double Farthest = 6e6;
  for (const double middle : { 3e5, 4e5, 5e6, Farthest })
  {
    const lms3dPlaneFrame frame = MakeFloor({ middle, -middle, 0.0 });
    for (const double sign : { -1.0, 1.0 })
    {
      const lms3dPoint2 cells = frame.ToCells({ sign * Farthest, -sign * Farthest, 0.0 });
      EXPECT_LT(std::abs(cells[0]), 2e9) << middle;
      EXPECT_LT(std::abs(cells[1]), 2e9) << middle;
    }
  }
}
