// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Kernels that find the beams inside a triangle and keep the nearest hits.
 *
 * With corners a, b, c in the sensor frame, a beam along d passes inside if the three edge
 * functions d.(b x c), d.(c x a), d.(a x b) have the same sign. Their rounding errors are bounded;
 * where a sign is not certain, the caller decides with exact arithmetic.
 */
#ifndef lms3dInsideKernels_inl
#define lms3dInsideKernels_inl

#include "Kernels/lms3dPacketMask.inl"

namespace
{
// Rounding of an edge function relative to |p| |q| in the 1-norm: the differences (1 unit each),
// the cross product (2) and the dot product (3) stay below 9 units of 1.1e-16 or 6e-8.
constexpr double DoubleEdgeError = 2e-15;
constexpr float FloatEdgeError = 2e-6f;

// The absolute error of products that underflow.
constexpr double DoubleUnderflow = 1e-300;
constexpr float FloatUnderflow = 1e-36f;

// Relative to the lengths of its two factors. If the normal (a cross product of edges), or its dot
// product with a direction or corner, is smaller, double keeps fewer than 13 digits of the range.
constexpr double WellConditioned = 1e-3;

// A relative error larger than that of a range with 13 digits.
constexpr double LimitMargin = 1e-12;

template <typename Real>
struct Edge
{
  Real Normal[3];
  Real Error;
};

// Swapping p and q changes the sign of the edge function and no other bit. So two triangles that
// share an edge always agree on which side of it a beam passes, and no beam slips between them.
template <typename Real>
Edge<Real> MakeEdge(const Real* p, const Real* q, Real error)
{
  return { { p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0] },
    error };
}

double SumOfMagnitudes(const double* p)
{
  return Magnitude(p[0]) + Magnitude(p[1]) + Magnitude(p[2]);
}

/// Bounds of the three edge functions: the smallest and the largest of the lower bounds (value
/// minus error), and of the upper bounds (value plus error).
template <typename Real>
struct Limits
{
  Real MinimumLow;
  Real MaximumLow;
  Real MinimumHigh;
  Real MaximumHigh;
};

template <typename Real>
[[gnu::always_inline]] inline Limits<Real> FindLimits(
  const Edge<Real>* edges, const Real (&direction)[3][Size], int i)
{
  Real low[3], high[3];
  for (int e = 0; e < 3; ++e)
  {
    const Real value = Dot(direction, i, edges[e].Normal);
    low[e] = value - edges[e].Error;
    high[e] = value + edges[e].Error;
  }
  return { Minimum(Minimum(low[0], low[1]), low[2]), Maximum(Maximum(low[0], low[1]), low[2]),
    Minimum(Minimum(high[0], high[1]), high[2]), Maximum(Maximum(high[0], high[1]), high[2]) };
}

template <typename Real>
bool IsHit(const Limits<Real>& limits)
{
  return (limits.MinimumLow > Real(0)) | (limits.MaximumHigh < Real(0));
}

template <typename Real>
bool IsMiss(const Limits<Real>& limits)
{
  return (limits.MaximumLow > Real(0)) & (limits.MinimumHigh < Real(0));
}

// Returns true if single precision proves that all beams in `beams` pass outside. This rejects most
// candidates at half the cost. One error bound serves all three edges: the 1-norms of both corners
// of an edge are at most 3 times the largest component of all corners.
bool AllMiss(
  const lms3dSensorFrameTriangle& triangle, std::uint32_t beams, const lms3dBeamPacket& packet)
{
  float corner[3][3];
  float largest = 0.0f;
  for (int i = 0; i < 3; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      corner[i][axis] = static_cast<float>(triangle.Corner[i][axis]);
      largest = Maximum(largest, corner[i][axis] < 0 ? -corner[i][axis] : corner[i][axis]);
    }
  }
  const float error = 3.0f * 3.0f * FloatEdgeError * largest * largest + FloatUnderflow;
  const Edge<float> edges[3] = { MakeEdge(corner[1], corner[2], error),
    MakeEdge(corner[2], corner[0], error), MakeEdge(corner[0], corner[1], error) };
  Mask missed;
  for (int i = 0; i < Size; ++i)
  {
    missed.Set(i, IsMiss(FindLimits(edges, packet.NarrowDirection, i)));
  }
  return (beams & ~missed.GetBits()) == 0;
}

// Computes the edges opposite to corner 0, 1 and 2.
[[gnu::always_inline]] inline void MakeEdges(
  const lms3dSensorFrameTriangle& triangle, Edge<double>* edges)
{
  const double(&corner)[3][3] = triangle.Corner;
  const double a = SumOfMagnitudes(corner[0]);
  const double b = SumOfMagnitudes(corner[1]);
  const double c = SumOfMagnitudes(corner[2]);
  edges[0] = MakeEdge(corner[1], corner[2], DoubleEdgeError * b * c + DoubleUnderflow);
  edges[1] = MakeEdge(corner[2], corner[0], DoubleEdgeError * c * a + DoubleUnderflow);
  edges[2] = MakeEdge(corner[0], corner[1], DoubleEdgeError * a * b + DoubleUnderflow);
}

lms3dHitMasks Classify(
  const lms3dSensorFrameTriangle& triangle, std::uint32_t beams, const lms3dBeamPacket& packet)
{
  if (AllMiss(triangle, beams, packet))
  {
    return { 0, 0 };
  }
  Edge<double> edges[3];
  MakeEdges(triangle, edges);
  Mask hits;
  Mask uncertain;
  for (int i = 0; i < Size; ++i)
  {
    const Limits<double> limits = FindLimits(edges, packet.Direction, i);
    hits.Set(i, IsHit(limits));
    uncertain.Set(i, !(IsHit(limits) | IsMiss(limits)));
  }
  return { hits.GetBits() & beams, uncertain.GetBits() & beams };
}

[[gnu::always_inline]] inline lms3dDoublePlane MakePlane(const lms3dSensorFrameTriangle& triangle)
{
  const double(&a)[3] = triangle.Corner[0];
  double p[3], q[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    p[axis] = triangle.Corner[1][axis] - a[axis];
    q[axis] = triangle.Corner[2][axis] - a[axis];
  }
  const Edge<double> plane = MakeEdge(p, q, 0.0);
  const double offset = plane.Normal[0] * a[0] + plane.Normal[1] * a[1] + plane.Normal[2] * a[2];
  const double minimumSlope = WellConditioned * SumOfMagnitudes(p) * SumOfMagnitudes(q);
  return { { plane.Normal[0], plane.Normal[1], plane.Normal[2] }, offset, minimumSlope,
    Magnitude(offset) > minimumSlope * SumOfMagnitudes(a) };
}

lms3dDoublePlane MakeDoublePlane(const lms3dSensorFrameTriangle& triangle)
{
  return MakePlane(triangle);
}

/// RefineRanges computes the final range with more digits. Within its error of the maximum range,
/// those digits already decide whether the hit counts.
struct RangeLimits
{
  explicit RangeLimits(double maximumRange)
    : Certain(maximumRange * (1.0 - LimitMargin))
    , Possible(maximumRange * (1.0 + LimitMargin))
  {
  }

  double Certain;
  double Possible;
};

// Returns whether beam i has a nearer hit at a range.
[[gnu::always_inline]] inline bool IsNearer(double range, std::int32_t triangle,
  const RangeLimits& limits, const lms3dBeamPacket& packet, int i)
{
  const bool isTie = (range == packet.Range[i]) & (triangle < packet.Triangle[i]);
  return (range > 0.0) & (range <= limits.Certain) & ((range < packet.Range[i]) | isTie);
}

// Returns whether a range needs more digits, in a plane that is well conditioned.
[[gnu::always_inline]] inline bool IsBad(
  double range, double slope, const lms3dDoublePlane& plane, const RangeLimits& limits)
{
  const bool isAtLimit = (range > limits.Certain) & (range <= limits.Possible);
  return isAtLimit | !(Magnitude(slope) > plane.MinimumSlope);
}

[[gnu::always_inline]] inline void StoreNearest(
  const double* ranges, std::int32_t triangle, std::uint32_t changed, lms3dBeamPacket& packet)
{
  for (int i = 0; i < Size; ++i)
  {
    const bool isChanged = (changed >> i) & 1u;
    packet.Range[i] = isChanged ? ranges[i] : packet.Range[i];
    packet.Triangle[i] = isChanged ? triangle : packet.Triangle[i];
  }
}

std::uint32_t UpdateNearest(const lms3dSensorFrameTriangle& corners, std::int32_t triangle,
  std::uint32_t hits, double maximumRange, lms3dBeamPacket& packet, std::uint32_t& uncertain)
{
  const lms3dDoublePlane plane = MakeDoublePlane(corners);
  if (!plane.IsWellConditioned)
  {
    uncertain |= hits;
    return 0;
  }

  const RangeLimits limits(maximumRange);
  Mask bad;
  Mask nearer;
  alignas(64) double ranges[Size];
  for (int i = 0; i < Size; ++i)
  {
    const double slope = Dot(packet.Direction, i, plane.Normal);
    const double range = plane.Offset / slope;
    ranges[i] = range;
    nearer.Set(i, IsNearer(range, triangle, limits, packet, i));
    bad.Set(i, IsBad(range, slope, plane, limits));
  }
  uncertain |= hits & bad.GetBits();
  const std::uint32_t changed = hits & nearer.GetBits() & ~bad.GetBits();
  StoreNearest(ranges, triangle, changed, packet);
  return changed;
}
} // namespace

#endif
