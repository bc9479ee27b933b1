// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Whether beams pass inside a triangle, and which is the nearest.
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

// What products lose that are too small to be normal numbers.
constexpr double DoubleUnderflow = 1e-300;
constexpr float FloatUnderflow = 1e-36f;

// Where the plane's normal is shorter than this share of its edges' product, or nearly at right
// angles to what it is multiplied with, double keeps fewer than 13 digits of the range.
constexpr double WellConditioned = 1e-3;

// A share of the range, more than is wrong with 13 digits of it.
constexpr double LimitMargin = 1e-12;

template <typename Real>
struct Edge
{
  Real Normal[3];
  Real Error;
};

// Swapping p and q changes nothing but the sign of the edge function, to the last bit.
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

/// The edge functions less, and plus, their errors: the smallest and the largest of the three.
template <typename Real>
struct Limits
{
  Real LeastLow;
  Real GreatestLow;
  Real LeastHigh;
  Real GreatestHigh;
};

template <typename Real>
Limits<Real> FindLimits(const Edge<Real>* edges, const Real (&direction)[3][Size], int i)
{
  Real low[3], high[3];
  for (int e = 0; e < 3; ++e)
  {
    const Real value = direction[0][i] * edges[e].Normal[0] + direction[1][i] * edges[e].Normal[1] +
      direction[2][i] * edges[e].Normal[2];
    low[e] = value - edges[e].Error;
    high[e] = value + edges[e].Error;
  }
  return { Least(Least(low[0], low[1]), low[2]), Greatest(Greatest(low[0], low[1]), low[2]),
    Least(Least(high[0], high[1]), high[2]), Greatest(Greatest(high[0], high[1]), high[2]) };
}

// Whether single precision tells that all active beams pass outside: it rejects most candidates, at
// half the cost. One error bound, that of the farthest corner, does for all three edges.
bool AllMiss(const lms3dSeenTriangle& triangle, const lms3dBeamPacket& packet)
{
  float corner[3][3];
  float farthest = 0.0f;
  for (int i = 0; i < 3; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      corner[i][axis] = static_cast<float>(triangle.Corner[i][axis]);
      farthest = Greatest(farthest, corner[i][axis] < 0 ? -corner[i][axis] : corner[i][axis]);
    }
  }
  const float error = 9.0f * FloatEdgeError * farthest * farthest + FloatUnderflow;
  const Edge<float> edges[3] = { MakeEdge(corner[1], corner[2], error),
    MakeEdge(corner[2], corner[0], error), MakeEdge(corner[0], corner[1], error) };
  Mask missed;
  for (int i = 0; i < Size; ++i)
  {
    const Limits<float> limits = FindLimits(edges, packet.NarrowDirection, i);
    missed.Set(i, (limits.GreatestLow > 0.0f) & (limits.LeastHigh < 0.0f));
  }
  return (packet.Active & ~missed.GetBits()) == 0;
}

lms3dVerdicts Classify(const lms3dSeenTriangle& triangle, const lms3dBeamPacket& packet)
{
  if (AllMiss(triangle, packet))
  {
    return { 0, 0 };
  }
  const double(&corner)[3][3] = triangle.Corner;
  const double a = SumOfMagnitudes(corner[0]);
  const double b = SumOfMagnitudes(corner[1]);
  const double c = SumOfMagnitudes(corner[2]);
  const Edge<double> edges[3] = { MakeEdge(corner[1], corner[2],
                                    DoubleEdgeError * b * c + DoubleUnderflow),
    MakeEdge(corner[2], corner[0], DoubleEdgeError * c * a + DoubleUnderflow),
    MakeEdge(corner[0], corner[1], DoubleEdgeError * a * b + DoubleUnderflow) };
  Mask hits;
  Mask doubts;
  for (int i = 0; i < Size; ++i)
  {
    const Limits<double> limits = FindLimits(edges, packet.Direction, i);
    const bool isHit = (limits.LeastLow > 0.0) | (limits.GreatestHigh < 0.0);
    const bool isMiss = (limits.GreatestLow > 0.0) & (limits.LeastHigh < 0.0);
    hits.Set(i, isHit);
    doubts.Set(i, !(isHit | isMiss));
  }
  return { hits.GetBits(), doubts.GetBits() };
}

lms3dRoughPlane SeeRoughly(const lms3dSeenTriangle& seen)
{
  const double(&a)[3] = seen.Corner[0];
  double p[3], q[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    p[axis] = seen.Corner[1][axis] - a[axis];
    q[axis] = seen.Corner[2][axis] - a[axis];
  }
  const Edge<double> plane = MakeEdge(p, q, 0.0);
  const double offset = plane.Normal[0] * a[0] + plane.Normal[1] * a[1] + plane.Normal[2] * a[2];
  const double smallestSlope = WellConditioned * SumOfMagnitudes(p) * SumOfMagnitudes(q);
  return { { plane.Normal[0], plane.Normal[1], plane.Normal[2] }, offset, smallestSlope,
    Magnitude(offset) > smallestSlope * SumOfMagnitudes(a) };
}

std::uint32_t TakeHits(const lms3dSeenTriangle& seen, std::int32_t triangle, std::uint32_t beams,
  double maximumRange, lms3dBeamPacket& packet, std::uint32_t& unsure)
{
  const lms3dRoughPlane plane = SeeRoughly(seen);
  if (!plane.IsGood)
  {
    unsure |= beams;
    return 0;
  }

  // The range that counts is measured later, with more digits; at the limit they are needed now.
  const double surely = maximumRange * (1.0 - LimitMargin);
  const double farthest = maximumRange * (1.0 + LimitMargin);
  Mask bad;
  Mask nearer;
  alignas(64) double ranges[Size];
  for (int i = 0; i < Size; ++i)
  {
    const double slope = packet.Direction[0][i] * plane.Normal[0] +
      packet.Direction[1][i] * plane.Normal[1] + packet.Direction[2][i] * plane.Normal[2];
    const double range = plane.Offset / slope;
    ranges[i] = range;
    const bool isTie = (range == packet.Range[i]) & (triangle < packet.Triangle[i]);
    nearer.Set(i, (range > 0.0) & (range <= surely) & ((range < packet.Range[i]) | isTie));
    const bool isAtLimit = (range > surely) & (range <= farthest);
    bad.Set(i, isAtLimit | !(Magnitude(slope) > plane.SmallestSlope));
  }
  unsure |= beams & bad.GetBits();
  const std::uint32_t changed = beams & nearer.GetBits() & ~bad.GetBits();
  for (int i = 0; i < Size; ++i)
  {
    const bool isChanged = (changed >> i) & 1u;
    packet.Range[i] = isChanged ? ranges[i] : packet.Range[i];
    packet.Triangle[i] = isChanged ? triangle : packet.Triangle[i];
  }
  return changed;
}
} // namespace

#endif
