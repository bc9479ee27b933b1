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
#include <limits>

namespace
{
// The elevations of one tile's beams. Beyond the last, the last is repeated.
struct TileElevations
{
  alignas(64) double Cosine[Size];

  /// The sine times the upward axis.
  alignas(64) double Up[3][Size];
};

// The smallest range above 0.
constexpr double SmallestRange = std::numeric_limits<double>::denorm_min();

// Whether the ranges of each column of beams are within the limits, -1 or 0. As wide as the ranges,
// so that the compiler can vectorize the loops.
struct ColumnsWithin
{
  ColumnsWithin()
  {
    for (std::int64_t& column : this->Columns)
    {
      column = -1;
    }
  }

  bool AreAll() const
  {
    std::int64_t all = -1;
    for (std::int64_t column : this->Columns)
    {
      all &= column;
    }
    return all != 0;
  }

  alignas(64) std::int64_t Columns[Size];
};

// Intersects the beams of one turn. Directions have the bits that GenerateDirections gives. Ranges
// have the bits that Intersect gives: since the slopes exceed their errors, fewer sums are enough.
// `ranges` must not overlap the input, so that the compiler can vectorize the loop.
[[gnu::always_inline]] inline void IntersectTurn(const lms3dDoubleDoublePlane& plane,
  const TileElevations& elevations, const double* fan, const lms3dRangeWindow& within,
  double* __restrict ranges, ColumnsWithin& areWithin)
{
  const double minimum = Maximum(within.Minimum, SmallestRange);
  for (int i = 0; i < Size; ++i)
  {
    const double cosine = elevations.Cosine[i];
    const double direction[3] = { cosine * fan[0] + elevations.Up[0][i],
      cosine * fan[1] + elevations.Up[1][i], cosine * fan[2] + elevations.Up[2][i] };
    const Pair slope = GetSlope(plane.Normal, direction);
    const double range = Divide(plane.Offset, SumOfLargerFirst(slope.High, slope.Low));
    areWithin.Columns[i] &= (range >= minimum) & (range <= within.Maximum) ? -1 : 0;
    ranges[i] = range;
  }
}

bool IntersectTile(const lms3dDoubleDoublePlane& plane, const lms3dBeamsOfTile& beams,
  const lms3dRangeWindow& within, double* ranges, std::ptrdiff_t stride)
{
  // Copies, which the ranges certainly do not overlap.
  const lms3dDoubleDoublePlane copy = plane;
  TileElevations elevations;
  for (int i = 0; i < Size; ++i)
  {
    const int beam = Minimum(i, beams.Beams - 1);
    elevations.Cosine[i] = beams.Cosines[beam];
    for (int axis = 0; axis < 3; ++axis)
    {
      elevations.Up[axis][i] = beams.Sines[beam] * beams.Up[axis];
    }
  }
  ColumnsWithin areWithin;
  alignas(64) double ofTurn[Size];
  for (int turn = 0; turn < beams.Turns; ++turn, ranges += stride)
  {
    const double fan[3] = { beams.FanAxes[turn][0], beams.FanAxes[turn][1],
      beams.FanAxes[turn][2] };
    if (beams.Beams == Size)
    {
      IntersectTurn(copy, elevations, fan, within, ranges, areWithin);
      continue;
    }
    IntersectTurn(copy, elevations, fan, within, ofTurn, areWithin);
    __builtin_memcpy(ranges, ofTurn, static_cast<std::size_t>(beams.Beams) * sizeof(double));
  }
  return areWithin.AreAll();
}
} // namespace

#endif
