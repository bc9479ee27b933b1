// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Kernels that intersect beams with a plane, in double precision and with twice its digits.
 */
#ifndef lms3dRangeKernels_inl
#define lms3dRangeKernels_inl

#include "Kernels/lms3dPacketMask.inl"
#include "Kernels/lms3dPairArithmetic.inl"

namespace
{
lms3dDoubleDoublePlane MakeDoubleDoublePlane(const double* const* corners, const double* origin)
{
  Pair p[3], q[3], a[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    p[axis] = lms3dTwoDifference(corners[1][axis], corners[0][axis]);
    q[axis] = lms3dTwoDifference(corners[2][axis], corners[0][axis]);
    a[axis] = lms3dTwoDifference(corners[0][axis], origin[axis]);
  }
  lms3dDoubleDoublePlane plane;
  plane.Offset = { 0.0, 0.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    plane.Normal[axis] = Add(Multiply(p[next], q[last]), Negate(Multiply(p[last], q[next])));
    plane.Offset = Add(plane.Offset, Multiply(plane.Normal[axis], a[axis]));
  }
  return plane;
}

// Returns offset / normal.direction of beam i, with one rounding.
[[gnu::always_inline]] inline double Intersect(
  const Pair* normal, const Pair& offset, const double (&directions)[3][Size], int i)
{
  // The dot product normal.direction; `error` sums the rounding errors of its products and sums
  // (Ogita, Rump and Oishi, "Accurate sum and dot product", 2005).
  const Pair first = Multiply(normal[0].High, directions[0][i]);
  double slope = first.High;
  double error = first.Low + normal[0].Low * directions[0][i];
  for (int axis = 1; axis < 3; ++axis)
  {
    const double direction = directions[axis][i];
    const Pair product = Multiply(normal[axis].High, direction);
    const Pair sum = lms3dTwoSum(slope, product.High);
    slope = sum.High;
    error += sum.Low + (product.Low + normal[axis].Low * direction);
  }
  // At grazing incidence the error is not small compared with the slope.
  const Pair whole = lms3dTwoSum(slope, error);
  // The quotient, corrected by the remainder of the division.
  const double quotient = offset.High / whole.High;
  const Pair back = Multiply(quotient, whole.High);
  const double remainder =
    ((offset.High - back.High) - back.Low) + (offset.Low - quotient * whole.Low);
  return quotient + remainder / whole.High;
}

// `ranges` must not overlap the input, so that the compiler can vectorize the loop.
void IntersectDoubleDoublePlane(
  const lms3dDoubleDoublePlane& plane, const lms3dBeamPacket& packet, double* __restrict ranges)
{
  for (int i = 0; i < Size; ++i)
  {
    ranges[i] = Intersect(plane.Normal, plane.Offset, packet.Direction, i);
  }
}

void IntersectDoublePlane(
  const lms3dDoublePlane& plane, const lms3dBeamPacket& packet, double* ranges)
{
  for (int i = 0; i < Size; ++i)
  {
    ranges[i] = plane.Offset / Dot(packet.Direction, i, plane.Normal);
  }
}

// Returns whether all ranges are above 0 and not above a maximum.
bool AreWithin(const double* ranges, double maximumRange)
{
  // As wide as the ranges, so that the compiler can vectorize the loop.
  std::int64_t areWithin = -1;
  for (int i = 0; i < Size; ++i)
  {
    areWithin &= (ranges[i] > 0.0) & (ranges[i] <= maximumRange) ? -1 : 0;
  }
  return areWithin != 0;
}

// For packets with several triangles, and where hits are lost.
void StoreSomeRanges(
  const double* ranges, std::int32_t triangle, double maximumRange, lms3dBeamPacket& packet)
{
  Mask lost;
  for (int i = 0; i < Size; ++i)
  {
    const bool isMeasured = packet.Triangle[i] == triangle;
    const bool isHit = (ranges[i] > 0.0) & (ranges[i] <= maximumRange);
    packet.Range[i] = isMeasured ? (isHit ? ranges[i] : lms3dBeamPacket::NoRange) : packet.Range[i];
    lost.Set(i, isMeasured & !isHit);
  }
  for (int i = 0; i < Size; ++i)
  {
    packet.Triangle[i] |= lost.Beams[i];
  }
}

std::uint32_t StoreRanges(
  const double* ranges, std::int32_t triangle, double maximumRange, lms3dBeamPacket& packet)
{
  constexpr std::uint32_t all = (1u << Size) - 1u;
  Mask measured;
  for (int i = 0; i < Size; ++i)
  {
    measured.Set(i, packet.Triangle[i] == triangle);
  }
  const std::uint32_t bits = measured.GetBits();
  if (bits != all || !AreWithin(ranges, maximumRange))
  {
    StoreSomeRanges(ranges, triangle, maximumRange, packet);
    return bits;
  }
  for (int i = 0; i < Size; ++i)
  {
    packet.Range[i] = ranges[i];
  }
  return bits;
}
} // namespace

#endif
