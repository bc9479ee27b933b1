// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The kernel that decides on sixteen tiles at once whether they can meet a box.
 */
#ifndef lms3dTileBoxKernels_inl
#define lms3dTileBoxKernels_inl

#include "Kernels/lms3dTileKernels.inl"

namespace
{
// In a direction, the point of a box that lies farthest has the product center.side +
// halfSize.|side|. The 1-norm of a point of the box is at most that of the centre and of half the
// size together, N. So the bound is SideError N: the product errs by 18 u N for the side, u N for
// the six products and 5 u N for their sums, which with the 87 u above is 111 u N.
std::uint32_t FindTilesOfBox(const lms3dTiles& tiles, const lms3dTileBox& box)
{
  float norm = 0.0f;
  for (int axis = 0; axis < 3; ++axis)
  {
    norm += __builtin_fabsf(box.Center[axis]) + box.HalfSize[axis];
  }
  const float error = -SideError * norm;
  Mask met;
  for (int i = 0; i < Size; ++i)
  {
    float minimum = 1e30f;
#pragma GCC unroll 4
    for (const TileVector& side : tiles.Side)
    {
      const float center = NarrowDot(side, i, box.Center);
      const float reach = __builtin_fabsf(side[0][i]) * box.HalfSize[0] +
        __builtin_fabsf(side[1][i]) * box.HalfSize[1] +
        __builtin_fabsf(side[2][i]) * box.HalfSize[2];
      minimum = Minimum(minimum, center + reach);
    }
    met.Set(i, !(minimum < error));
  }
  return met.GetBits();
}
} // namespace

#endif
