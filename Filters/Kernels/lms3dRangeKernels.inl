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
// The four numbers of a plane, for the inner loop of several triangles at once.
struct PairPlane
{
  Pair X, Y, Z, Offset;
};

// One axis of a triangle: two edges, and the first corner relative to the origin.
struct PairAxis
{
  Pair P, Q, A;
};

[[gnu::always_inline]] inline PairAxis MakeAxis(double a, double b, double c, double origin)
{
  return { lms3dTwoDifference(b, a), lms3dTwoDifference(c, a), lms3dTwoDifference(a, origin) };
}

[[gnu::always_inline]] inline Pair GetNormal(const PairAxis& next, const PairAxis& last)
{
  return Add(Multiply(next.P, last.Q), Negate(Multiply(last.P, next.Q)));
}

// Straight through, without arrays of axes, so that compilers keep all numbers in registers.
[[gnu::always_inline]] inline PairPlane MakePairPlane(
  const PairAxis& x, const PairAxis& y, const PairAxis& z)
{
  const PairPlane normal = { GetNormal(y, z), GetNormal(z, x), GetNormal(x, y), { 0.0, 0.0 } };
  Pair offset = Add(normal.Offset, Multiply(normal.X, x.A));
  offset = Add(offset, Multiply(normal.Y, y.A));
  offset = Add(offset, Multiply(normal.Z, z.A));
  return { normal.X, normal.Y, normal.Z, offset };
}

lms3dDoubleDoublePlane MakeDoubleDoublePlane(const double* const* corners, const double* origin)
{
  const double* const a = corners[0];
  const double* const b = corners[1];
  const double* const c = corners[2];
  const PairPlane plane = MakePairPlane(MakeAxis(a[0], b[0], c[0], origin[0]),
    MakeAxis(a[1], b[1], c[1], origin[1]), MakeAxis(a[2], b[2], c[2], origin[2]));
  return { { plane.X, plane.Y, plane.Z }, plane.Offset };
}

// `planes` must not overlap the input, so that the compiler can vectorize the loop.
void MakeDoubleDoublePlanes(const lms3dPacketCorners& corners, int count, const double* origin,
  lms3dPacketPlanes& __restrict planes)
{
  constexpr int Step = lms3dPacketPlanes::Step;
  const double o[3] = { origin[0], origin[1], origin[2] };
  const auto& a = corners.Corner[0];
  const auto& b = corners.Corner[1];
  const auto& c = corners.Corner[2];
  for (int first = 0; first < count; first += Step)
  {
    for (int i = first; i < first + Step; ++i)
    {
      const PairPlane plane = MakePairPlane(MakeAxis(a[0][i], b[0][i], c[0][i], o[0]),
        MakeAxis(a[1][i], b[1][i], c[1][i], o[1]), MakeAxis(a[2][i], b[2][i], c[2][i], o[2]));
      planes.High[0][i] = plane.X.High;
      planes.High[1][i] = plane.Y.High;
      planes.High[2][i] = plane.Z.High;
      planes.High[3][i] = plane.Offset.High;
      planes.Low[0][i] = plane.X.Low;
      planes.Low[1][i] = plane.Y.Low;
      planes.Low[2][i] = plane.Z.Low;
      planes.Low[3][i] = plane.Offset.Low;
    }
  }
}

// Returns the product normal.direction, and the sum of the rounding errors of its products and sums
// (Ogita, Rump and Oishi, "Accurate sum and dot product", 2005).
[[gnu::always_inline]] inline Pair GetSlope(const Pair* normal, const double (&direction)[3])
{
  const Pair first = Multiply(normal[0].High, direction[0]);
  double slope = first.High;
  double error = first.Low + normal[0].Low * direction[0];
  for (int axis = 1; axis < 3; ++axis)
  {
    const Pair product = Multiply(normal[axis].High, direction[axis]);
    const Pair sum = lms3dTwoSum(slope, product.High);
    slope = sum.High;
    error += sum.Low + (product.Low + normal[axis].Low * direction[axis]);
  }
  return { slope, error };
}

// Returns the quotient, corrected by the remainder of the division.
[[gnu::always_inline]] inline double Divide(const Pair& x, const Pair& y)
{
  const double quotient = x.High / y.High;
  const Pair back = Multiply(quotient, y.High);
  const double remainder = ((x.High - back.High) - back.Low) + (x.Low - quotient * y.Low);
  return quotient + remainder / y.High;
}

// Returns offset / normal.direction, with one rounding.
[[gnu::always_inline]] inline double Intersect(
  const Pair* normal, const Pair& offset, const double (&direction)[3])
{
  // At grazing incidence the error is not small compared with the slope.
  const Pair slope = GetSlope(normal, direction);
  return Divide(offset, lms3dTwoSum(slope.High, slope.Low));
}

// The same for beam i of some.
[[gnu::always_inline]] inline double Intersect(
  const Pair* normal, const Pair& offset, const double (&directions)[3][Size], int i)
{
  const double direction[3] = { directions[0][i], directions[1][i], directions[2][i] };
  return Intersect(normal, offset, direction);
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

void IntersectDoubleDoublePlanes(
  const lms3dPacketPlanes& planes, const lms3dBeamPacket& packet, double* __restrict ranges)
{
  for (int i = 0; i < Size; ++i)
  {
    const Pair normal[3] = { { planes.High[0][i], planes.Low[0][i] },
      { planes.High[1][i], planes.Low[1][i] }, { planes.High[2][i], planes.Low[2][i] } };
    ranges[i] = Intersect(normal, { planes.High[3][i], planes.Low[3][i] }, packet.Direction, i);
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

// `ranges` must not overlap the packet, so that the compiler can vectorize the loops.
void StoreRangesOfBeams(const double* __restrict ranges, std::uint32_t beams, double maximumRange,
  lms3dBeamPacket& packet)
{
  Mask isHit;
  for (int i = 0; i < Size; ++i)
  {
    isHit.Set(i, (ranges[i] > 0.0) & (ranges[i] <= maximumRange));
    packet.Range[i] = (beams >> i) & 1u ? ranges[i] : packet.Range[i];
  }
  const std::uint32_t lost = beams & ~isHit.GetBits();
  if (lost == 0)
  {
    return;
  }
  for (int i = 0; i < Size; ++i)
  {
    packet.Range[i] = (lost >> i) & 1u ? lms3dBeamPacket::NoRange : packet.Range[i];
    packet.Triangle[i] = (lost >> i) & 1u ? lms3dBeamPacket::NoTriangle : packet.Triangle[i];
  }
}

std::uint32_t StoreRanges(
  const double* ranges, std::int32_t triangle, double maximumRange, lms3dBeamPacket& packet)
{
  Mask isMeasured;
  for (int i = 0; i < Size; ++i)
  {
    isMeasured.Set(i, packet.Triangle[i] == triangle);
  }
  const std::uint32_t beams = isMeasured.GetBits();
  StoreRangesOfBeams(ranges, beams, maximumRange, packet);
  return beams;
}

std::uint32_t RefineRanges(const lms3dDoubleDoublePlane& plane, std::int32_t triangle,
  double maximumRange, lms3dBeamPacket& packet)
{
  alignas(64) double ranges[Size];
  IntersectDoubleDoublePlane(plane, packet, ranges);
  return StoreRanges(ranges, triangle, maximumRange, packet);
}
} // namespace

#endif
