// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The packet kernels; included once by the source of each instruction set.
 *
 * Plain loops over arrays, which compilers turn into vector instructions. Nothing here may be an
 * inline function that other sources share: the linker would keep one of them, perhaps the one that
 * the processor cannot run.
 */
#ifndef lms3dPacketKernels_inl
#define lms3dPacketKernels_inl

#include "lms3dPacketKernels.h"

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace
{
constexpr int Size = lms3dBeamPacket::Size;

// Embree loses packets in which a direction component is a tiny negative number: its reciprocal is
// taken as positive while the packet was sorted by the sign.
constexpr double SmallestComponent = 1e-15;

// Rounding of an edge function relative to |p| |q| in the 1-norm: the differences (1 unit each),
// the cross product (2) and the dot product (3) stay below 9 units of 1.1e-16 or 6e-8.
constexpr double DoubleEdgeError = 2e-15;
constexpr float FloatEdgeError = 2e-6f;

// Where the plane's normal is shorter than this share of its edges' product, or nearly at right
// angles to what it is multiplied with, double keeps fewer than 13 digits of the range.
constexpr double WellConditioned = 1e-3;

double Magnitude(double x)
{
  return x < 0.0 ? -x : x;
}

// A condition for each beam: all bits set, or none.
struct Mask
{
  void Set(int beam, bool condition) { this->Beams[beam] = condition ? -1 : 0; }

  // Bit i for beam i. Of a plain loop compilers make a tree of shifts.
  std::uint32_t GetBits() const
  {
#if defined(__AVX512DQ__)
    return _mm512_movepi32_mask(_mm512_load_si512(this->Beams));
#elif defined(__SSE2__)
    std::uint32_t bits = 0;
    for (int i = 0; i < Size; i += 4)
    {
      const __m128i* four = reinterpret_cast<const __m128i*>(this->Beams + i);
      bits |= static_cast<std::uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(_mm_load_si128(four)))) << i;
    }
    return bits;
#else
    std::uint32_t bits = 0;
    for (int i = 0; i < Size; ++i)
    {
      bits |= this->Beams[i] ? 1u << i : 0u;
    }
    return bits;
#endif
  }

  alignas(64) std::int32_t Beams[Size];
};

void Aim(const lms3dElevations& elevations, const lms3dFanAxes& axes, lms3dBeamPacket& packet)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < Size; ++i)
    {
      const double component =
        elevations.Cosine[i] * axes.Horizontal[axis][i] + elevations.Sine[i] * axes.Up[axis];
      packet.Direction[axis][i] = component;
      packet.NarrowDirection[axis][i] =
        static_cast<float>(Magnitude(component) < SmallestComponent ? 0.0 : component);
    }
  }
}

std::uint32_t FindWithin(const lms3dCone& cone, const lms3dBeamPacket& packet)
{
  Mask within;
  for (int i = 0; i < Size; ++i)
  {
    within.Set(i,
      packet.Direction[0][i] * cone.Axis[0] + packet.Direction[1][i] * cone.Axis[1] +
          packet.Direction[2][i] * cone.Axis[2] >=
        cone.Least);
  }
  return within.GetBits();
}

std::uint32_t SetStarts(const lms3dStart& start, const double* directions, float* starts)
{
  Mask near;
  for (int i = 0; i < Size; ++i)
  {
    const double position =
      (start.Origin + start.HeadStart * directions[i] - start.Center) / start.Unit;
    const bool isNear = Magnitude(position) <= start.Farthest;
    starts[i] = static_cast<float>(isNear ? position : 0.0);
    near.Set(i, isNear);
  }
  return near.GetBits();
}

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
Real Least(Real x, Real y)
{
  return x < y ? x : y;
}

template <typename Real>
Real Greatest(Real x, Real y)
{
  return x > y ? x : y;
}

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
  const float error = 9.0f * FloatEdgeError * farthest * farthest;
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
  const Edge<double> edges[3] = { MakeEdge(corner[1], corner[2], DoubleEdgeError * b * c),
    MakeEdge(corner[2], corner[0], DoubleEdgeError * c * a),
    MakeEdge(corner[0], corner[1], DoubleEdgeError * a * b) };
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

std::uint32_t TakeHits(const lms3dSeenTriangle& seen, std::int32_t triangle, std::uint32_t beams,
  double maximumRange, lms3dBeamPacket& packet, std::uint32_t& unsure)
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
  if (!(Magnitude(offset) > smallestSlope * SumOfMagnitudes(a)))
  {
    unsure |= beams;
    return 0;
  }

  // The range that counts is measured later, with more digits.
  const double farthest = maximumRange * (1.0 + 1e-12);
  Mask bad;
  Mask nearer;
  alignas(64) double ranges[Size];
  for (int i = 0; i < Size; ++i)
  {
    const double slope = packet.Direction[0][i] * plane.Normal[0] +
      packet.Direction[1][i] * plane.Normal[1] + packet.Direction[2][i] * plane.Normal[2];
    const double range = offset / slope;
    ranges[i] = range;
    const bool isTie = (range == packet.Range[i]) & (triangle < packet.Triangle[i]);
    nearer.Set(i, (range > 0.0) & (range <= farthest) & ((range < packet.Range[i]) | isTie));
    bad.Set(i, !(Magnitude(slope) > smallestSlope));
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

// --- Arithmetic with twice the digits (Dekker 1971, Knuth): pairs whose sum is the number
// ----------

using Pair = lms3dDoubleDouble;

Pair Add(double x, double y)
{
  const double sum = x + y;
  const double part = sum - x;
  return { sum, (x - (sum - part)) + (y - part) };
}

Pair Subtract(double x, double y)
{
  return Add(x, -y);
}

// Both ways give the exact product.
Pair Multiply(double x, double y)
{
  const double product = x * y;
#ifdef __FMA__
  return { product, __builtin_fma(x, y, -product) };
#else
  const double scaledX = 134217729.0 * x;
  const double scaledY = 134217729.0 * y;
  const double upperX = scaledX - (scaledX - x);
  const double upperY = scaledY - (scaledY - y);
  const double lowerX = x - upperX;
  const double lowerY = y - upperY;
  return { product,
    ((upperX * upperY - product) + upperX * lowerY + lowerX * upperY) + lowerX * lowerY };
#endif
}

Pair Add(const Pair& x, const Pair& y)
{
  const Pair high = Add(x.High, y.High);
  const Pair low = Add(x.Low, y.Low);
  const Pair sum = Add(high.High, high.Low + low.High);
  return Add(sum.High, sum.Low + low.Low);
}

Pair Multiply(const Pair& x, const Pair& y)
{
  const Pair product = Multiply(x.High, y.High);
  return Add(product.High, product.Low + (x.High * y.Low + x.Low * y.High));
}

Pair Negate(const Pair& x)
{
  return { -x.High, -x.Low };
}

lms3dSeenPlane See(const double* const* corners, const double* origin)
{
  Pair p[3], q[3], a[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    p[axis] = Subtract(corners[1][axis], corners[0][axis]);
    q[axis] = Subtract(corners[2][axis], corners[0][axis]);
    a[axis] = Subtract(corners[0][axis], origin[axis]);
  }
  lms3dSeenPlane plane;
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

void Measure(const lms3dSeenPlane& plane, const lms3dBeamPacket& packet, double* ranges)
{
  alignas(64) double measured[Size];
  for (int i = 0; i < Size; ++i)
  {
    // The slope Normal.direction, each product and each sum with its rounding error.
    double slope = 0.0;
    double error = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double direction = packet.Direction[axis][i];
      const Pair product = Multiply(plane.Normal[axis].High, direction);
      const Pair sum = Add(slope, product.High);
      slope = sum.High;
      error += sum.Low + (product.Low + plane.Normal[axis].Low * direction);
    }
    // At a grazing angle the error is no longer small beside the slope.
    const Pair whole = Add(slope, error);
    // The quotient, and its correction by what remains.
    const double quotient = plane.Offset.High / whole.High;
    const Pair back = Multiply(quotient, whole.High);
    const double remainder =
      ((plane.Offset.High - back.High) - back.Low) + (plane.Offset.Low - quotient * whole.Low);
    measured[i] = quotient + remainder / whole.High;
  }
  for (int i = 0; i < Size; ++i)
  {
    ranges[i] = measured[i];
  }
}

void MeasureRoughly(const lms3dRoughPlane& plane, const lms3dBeamPacket& packet, double* ranges)
{
  for (int i = 0; i < Size; ++i)
  {
    ranges[i] = plane.Offset /
      (packet.Direction[0][i] * plane.Normal[0] + packet.Direction[1][i] * plane.Normal[1] +
        packet.Direction[2][i] * plane.Normal[2]);
  }
}

std::uint32_t FindHits(const lms3dBeamPacket& packet)
{
  Mask hits;
  for (int i = 0; i < Size; ++i)
  {
    hits.Set(i, packet.Triangle[i] != lms3dBeamPacket::NoTriangle);
  }
  return hits.GetBits();
}

std::uint32_t KeepRanges(
  const double* ranges, std::int32_t triangle, double maximumRange, lms3dBeamPacket& packet)
{
  Mask measured;
  Mask lost;
  for (int i = 0; i < Size; ++i)
  {
    const bool isMeasured = packet.Triangle[i] == triangle;
    const bool isHit = (ranges[i] > 0.0) & (ranges[i] <= maximumRange);
    packet.Range[i] = isMeasured ? (isHit ? ranges[i] : lms3dBeamPacket::NoRange) : packet.Range[i];
    measured.Set(i, isMeasured);
    lost.Set(i, isMeasured & !isHit);
  }
  for (int i = 0; i < Size; ++i)
  {
    packet.Triangle[i] |= lost.Beams[i];
  }
  return measured.GetBits();
}

// A hit that was just found must not hide one at the same range.
constexpr double RangeMargin = 1.0 + 1e-6;

void Shorten(const lms3dBeamPacket& packet, std::uint32_t changed, double headStart, double unit,
  unsigned int geometry, const lms3dRayRun& run)
{
  const double* range = packet.Range + run.First;
  const std::uint32_t bits = changed >> run.First;
  for (int i = 0; i < run.Count; ++i)
  {
    const bool isChanged = (bits >> i) & 1u;
    const float reach =
      static_cast<float>(Greatest(0.0, (range[i] - headStart) / unit * RangeMargin));
    run.Reach[i] = isChanged ? reach : run.Reach[i];
    run.Geometry[i] = isChanged ? geometry : run.Geometry[i];
  }
}

void Locate(const lms3dReturnsOfTurn& returns, double* points)
{
  const double fan[3] = { returns.FanAxis[0], returns.FanAxis[1], returns.FanAxis[2] };
  const double up[3] = { returns.Up[0], returns.Up[1], returns.Up[2] };
  const double position[3] = { returns.Position[0], returns.Position[1], returns.Position[2] };
  for (int i = 0; i < returns.Count; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double direction = returns.Cosines[i] * fan[axis] + returns.Sines[i] * up[axis];
      points[3 * i + axis] = position[axis] + returns.Ranges[i] * direction;
    }
  }
}

void Finish(double minimumRange, lms3dBeamPacket& packet)
{
  for (int i = 0; i < Size; ++i)
  {
    const bool isReturn =
      (packet.Triangle[i] != lms3dBeamPacket::NoTriangle) & (packet.Range[i] >= minimumRange);
    packet.Range[i] = isReturn ? packet.Range[i] : __builtin_nan("");
    packet.Triangle[i] = isReturn ? packet.Triangle[i] : lms3dBeamPacket::NoTriangle;
  }
}
} // namespace

// In the order of lms3dPacketKernels.
#define LMS3D_PACKET_KERNELS                                                                       \
  Aim, FindWithin, SetStarts, Classify, TakeHits, Shorten, FindHits, See, Measure, MeasureRoughly, KeepRanges, Finish,    \
    Locate

#endif
