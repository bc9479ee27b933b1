// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The kernel that intersects all beams of a tile with one plane.
 */
#ifndef lms3dTileRangeKernels_inl
#define lms3dTileRangeKernels_inl

#include "Kernels/lms3dRangeKernels.inl"

#include <cstddef>
#include <cstdint>

namespace
{
// The elevations of one tile's beams. Beyond the last, the last is repeated.
struct TileElevations
{
  alignas(64) double Cosine[Size];
  alignas(64) double Sine[Size];
};

// Intersects the beams of one turn. Directions have the bits that GenerateDirections gives.
// `ranges` must not overlap the input, so that the compiler can vectorize the loop.
[[gnu::always_inline]] inline bool IntersectTurn(const lms3dDoubleDoublePlane& plane,
  const TileElevations& elevations, const double* fan, const double* up,
  const lms3dRangeInterval& within, double* __restrict ranges)
{
  // As wide as the ranges, so that the compiler can vectorize the loop.
  std::int64_t areWithin = -1;
  for (int i = 0; i < Size; ++i)
  {
    const double cosine = elevations.Cosine[i];
    const double sine = elevations.Sine[i];
    const double direction[3] = { cosine * fan[0] + sine * up[0], cosine * fan[1] + sine * up[1],
      cosine * fan[2] + sine * up[2] };
    const double range = Intersect(plane.Normal, plane.Offset, direction);
    areWithin &= (range > 0.0) & (range >= within.Minimum) & (range <= within.Maximum) ? -1 : 0;
    ranges[i] = range;
  }
  return areWithin != 0;
}

bool IntersectTile(const lms3dDoubleDoublePlane& plane, const lms3dBeamsOfTile& beams,
  const lms3dRangeInterval& within, double* ranges, std::ptrdiff_t stride)
{
  // Copies, which the ranges certainly do not overlap.
  const lms3dDoubleDoublePlane copy = plane;
  const double up[3] = { beams.Up[0], beams.Up[1], beams.Up[2] };
  TileElevations elevations;
  for (int i = 0; i < Size; ++i)
  {
    const int beam = Minimum(i, beams.Beams - 1);
    elevations.Cosine[i] = beams.Cosines[beam];
    elevations.Sine[i] = beams.Sines[beam];
  }
  bool areWithin = true;
  alignas(64) double ofTurn[Size];
  for (int turn = 0; turn < beams.Turns; ++turn, ranges += stride)
  {
    const double fan[3] = { beams.FanAxes[turn][0], beams.FanAxes[turn][1],
      beams.FanAxes[turn][2] };
    if (beams.Beams == Size)
    {
      areWithin &= IntersectTurn(copy, elevations, fan, up, within, ranges);
      continue;
    }
    areWithin &= IntersectTurn(copy, elevations, fan, up, within, ofTurn);
    __builtin_memcpy(ranges, ofTurn, static_cast<std::size_t>(beams.Beams) * sizeof(double));
  }
  return areWithin;
}
} // namespace

#endif
