// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Kernels that decide in single precision where its error bounds allow.
 *
 * lms3dNarrowTriangle.h derives the bounds.
 */
#ifndef lms3dNarrowKernels_inl
#define lms3dNarrowKernels_inl

#include "Kernels/lms3dInsideKernels.inl"
#include "Kernels/lms3dPacketMask.inl"

namespace
{
// The least product of a plane and a corner, relative to the 1-norms of the corner and of two edges
// of the triangle.
constexpr double NarrowConditioned = 1e-6;

// Below this number, in cubic metres, products have underflowed.
constexpr double MinimumOffset = 1e-280;

// Lengths whose products neither underflow nor overflow.
constexpr double MinimumLength = 1e-100;
constexpr double MaximumLength = 1e100;

// The same for a plane in single precision.
constexpr float MinimumPlane = 1e-20f;
constexpr float MaximumPlane = 1e20f;

// Hits that are nearer keep this value, which no triangle in single precision reaches.
constexpr double MaximumInverse = 1e30;

// The least 1-norm of an edge's vector b x c, relative to the 1-norms of b and c.
constexpr double NarrowEdge = 1e-6;

// The arithmetic of one triangle stands in variables, not in arrays: compilers turn loops over
// three axes into vector instructions whose operands have to be gathered first, which is slower.
struct Point
{
  double X;
  double Y;
  double Z;
};

[[gnu::always_inline]] inline Point Subtract(const Point& p, const Point& q)
{
  return { p.X - q.X, p.Y - q.Y, p.Z - q.Z };
}

[[gnu::always_inline]] inline Point Cross(const Point& p, const Point& q)
{
  return { p.Y * q.Z - p.Z * q.Y, p.Z * q.X - p.X * q.Z, p.X * q.Y - p.Y * q.X };
}

[[gnu::always_inline]] inline double Dot(const Point& p, const Point& q)
{
  return p.X * q.X + p.Y * q.Y + p.Z * q.Z;
}

// The 1-norm.
[[gnu::always_inline]] inline double GetLength(const Point& p)
{
  return __builtin_fabs(p.X) + __builtin_fabs(p.Y) + __builtin_fabs(p.Z);
}

[[gnu::always_inline]] inline void Narrow(const Point& p, double scale, float (&narrow)[3])
{
  narrow[0] = static_cast<float>(p.X * scale);
  narrow[1] = static_cast<float>(p.Y * scale);
  narrow[2] = static_cast<float>(p.Z * scale);
}

/// The corners of a triangle relative to the sensor, and their 1-norms.
struct NarrowCorners
{
  Point A, B, C;
  double LengthOfA, LengthOfB, LengthOfC;
};

[[gnu::always_inline]] inline NarrowCorners GetNarrowCorners(
  const Point& a, const Point& b, const Point& c)
{
  return { a, b, c, GetLength(a), GetLength(b), GetLength(c) };
}

// Sets an edge, the cross product of two corners, scaled to the 1-norm 1. Returns whether single
// precision can represent it.
[[gnu::always_inline]] inline bool SetNarrowEdge(
  const Point& p, const Point& q, double lengths, double sign, float (&edge)[3])
{
  const Point normal = Cross(p, q);
  const double size = GetLength(normal);
  Narrow(normal, sign / size, edge);
  return size > NarrowEdge * lengths;
}

[[gnu::always_inline]] inline bool SetNarrowEdges(
  const NarrowCorners& corners, double sign, lms3dNarrowTriangle& narrow)
{
  const double a = corners.LengthOfA;
  const double b = corners.LengthOfB;
  const double c = corners.LengthOfC;
  bool isGood = (a > MinimumLength) & (b > MinimumLength) & (c > MinimumLength) &
    (a < MaximumLength) & (b < MaximumLength) & (c < MaximumLength);
  isGood &= SetNarrowEdge(corners.B, corners.C, b * c, sign, narrow.Edge[0]);
  isGood &= SetNarrowEdge(corners.C, corners.A, c * a, sign, narrow.Edge[1]);
  isGood &= SetNarrowEdge(corners.A, corners.B, a * b, sign, narrow.Edge[2]);
  return isGood;
}

// Sets the plane and its error.
[[gnu::always_inline]] inline double SetNarrowPlane(
  const NarrowCorners& corners, double unit, lms3dNarrowTriangle& narrow)
{
  const Point p = Subtract(corners.B, corners.A);
  const Point q = Subtract(corners.C, corners.A);
  const Point normal = Cross(p, q);
  const double offset = Dot(normal, corners.A);
  const double size = __builtin_fabs(offset);
  Narrow(normal, unit / offset, narrow.Plane);
  const float sum = __builtin_fabsf(narrow.Plane[0]) + __builtin_fabsf(narrow.Plane[1]) +
    __builtin_fabsf(narrow.Plane[2]);
  const bool isGood = (size > NarrowConditioned * GetLength(p) * GetLength(q) * corners.LengthOfA) &
    (size > MinimumOffset) & (sum > MinimumPlane) & (sum < MaximumPlane);
  narrow.PlaneError = isGood ? lms3dNarrowError * sum : -1.0f;
  return offset;
}

lms3dNarrowTriangle MakeNarrowTriangle(const lms3dSensorFrameTriangle& triangle, double unit)
{
  const double(&a)[3] = triangle.Corner[0];
  const double(&b)[3] = triangle.Corner[1];
  const double(&c)[3] = triangle.Corner[2];
  const NarrowCorners corners =
    GetNarrowCorners({ a[0], a[1], a[2] }, { b[0], b[1], b[2] }, { c[0], c[1], c[2] });
  lms3dNarrowTriangle narrow;
  const double sign = SetNarrowPlane(corners, unit, narrow) > 0.0 ? 1.0 : -1.0;
  narrow.PlaneError = SetNarrowEdges(corners, sign, narrow) ? narrow.PlaneError : -1.0f;
  return narrow;
}

// Keeps the hits of `beams` that are nearer. `isInside` has the beams that certainly pass inside.
[[gnu::always_inline]] inline lms3dNarrowMasks KeepNearer(const lms3dNarrowTriangle& triangle,
  std::int32_t number, std::uint32_t beams, const Mask& isInside, lms3dBeamPacket& packet,
  lms3dNarrowHits& hits)
{
  const float error = triangle.PlaneError;
  Mask nearer;
  Mask farther;
  alignas(64) float inverse[Size];
  for (int i = 0; i < Size; ++i)
  {
    inverse[i] = Dot(packet.NarrowDirection, i, triangle.Plane);
    const float margin = hits.Error[i] + error;
    nearer.Set(i, inverse[i] > hits.InverseRange[i] + margin);
    farther.Set(i, inverse[i] < hits.InverseRange[i] - margin);
  }
  const std::uint32_t changed = beams & isInside.GetBits() & nearer.GetBits();
  const std::uint32_t uncertain = beams & ~changed & ~farther.GetBits();
  if (changed == 0)
  {
    return { 0, uncertain };
  }
  for (int i = 0; i < Size; ++i)
  {
    const bool isChanged = (changed >> i) & 1u;
    hits.InverseRange[i] = isChanged ? inverse[i] : hits.InverseRange[i];
    hits.Error[i] = isChanged ? error : hits.Error[i];
    packet.Triangle[i] = isChanged ? number : packet.Triangle[i];
  }
  return { changed, uncertain };
}

lms3dNarrowMasks UpdateNarrow(const lms3dNarrowTriangle& triangle, std::int32_t number,
  std::uint32_t beams, lms3dBeamPacket& packet, lms3dNarrowHits& hits)
{
  const float(&direction)[3][Size] = packet.NarrowDirection;
  Mask isInside;
  Mask mayHit;
  for (int i = 0; i < Size; ++i)
  {
    const float a = Dot(direction, i, triangle.Edge[0]);
    const float b = Dot(direction, i, triangle.Edge[1]);
    const float c = Dot(direction, i, triangle.Edge[2]);
    const float minimum = Minimum(Minimum(a, b), c);
    isInside.Set(i, minimum > lms3dNarrowError);
    mayHit.Set(i, minimum > -lms3dNarrowError);
  }
  beams &= mayHit.GetBits();
  return beams == 0 ? lms3dNarrowMasks{ 0, 0 }
                    : KeepNearer(triangle, number, beams, isInside, packet, hits);
}

// Without the side of the triangle on which the sensor stands, which only the plane gives: products
// of one sign mean inside, or in the opposite direction, where the plane gives no range above 0.
lms3dNarrowMasks UpdateFromCorners(const lms3dCornerPoints& points, std::int32_t number,
  std::uint32_t beams, lms3dBeamPacket& packet, lms3dNarrowHits& hits)
{
  const double* const a = points.Corner[0];
  const double* const b = points.Corner[1];
  const double* const c = points.Corner[2];
  const double* const o = points.Origin;
  const NarrowCorners corners = GetNarrowCorners({ a[0] - o[0], a[1] - o[1], a[2] - o[2] },
    { b[0] - o[0], b[1] - o[1], b[2] - o[2] }, { c[0] - o[0], c[1] - o[1], c[2] - o[2] });
  lms3dNarrowTriangle narrow;
  if (!SetNarrowEdges(corners, 1.0, narrow))
  {
    return { 0, beams };
  }
  const float(&direction)[3][Size] = packet.NarrowDirection;
  Mask isInside;
  Mask mayHit;
  for (int i = 0; i < Size; ++i)
  {
    const float x = Dot(direction, i, narrow.Edge[0]);
    const float y = Dot(direction, i, narrow.Edge[1]);
    const float z = Dot(direction, i, narrow.Edge[2]);
    const float minimum = Minimum(Minimum(x, y), z);
    const float maximum = Maximum(Maximum(x, y), z);
    isInside.Set(i, (minimum > lms3dNarrowError) | (maximum < -lms3dNarrowError));
    mayHit.Set(i, (minimum > -lms3dNarrowError) | (maximum < lms3dNarrowError));
  }
  beams &= mayHit.GetBits();
  if (beams == 0)
  {
    return { 0, 0 };
  }
  SetNarrowPlane(corners, points.Unit, narrow);
  return narrow.PlaneError < 0.0f ? lms3dNarrowMasks{ 0, beams }
                                  : KeepNearer(narrow, number, beams, isInside, packet, hits);
}

void NarrowRanges(
  const lms3dBeamPacket& packet, std::uint32_t changed, double unit, lms3dNarrowHits& hits)
{
  for (int i = 0; i < Size; ++i)
  {
    const bool isChanged = (changed >> i) & 1u;
    const float inverse = static_cast<float>(Minimum(unit / packet.Range[i], MaximumInverse));
    hits.InverseRange[i] = isChanged ? inverse : hits.InverseRange[i];
    hits.Error[i] = isChanged ? lms3dNarrowError * inverse : hits.Error[i];
  }
}
} // namespace

#endif
