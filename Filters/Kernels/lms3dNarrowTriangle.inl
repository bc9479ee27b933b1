// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Makes triangles in single precision. Double precision computes their edges and plane.
 *
 * lms3dNarrowTriangle.h derives the bounds.
 */
#ifndef lms3dNarrowTriangle_inl
#define lms3dNarrowTriangle_inl

#include "Kernels/lms3dPacketKernels.h"

#include <cstdint>

// How vectors are returned depends on the instruction set, but all functions here are inlined into
// those that call them, to the end of each kernel source.
#pragma GCC diagnostic ignored "-Wpsabi"

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

// The least 1-norm of an edge's vector b x c, relative to the 1-norms of b and c.
constexpr double NarrowEdge = 1e-6;

// Four numbers for one instruction: one for each edge of a triangle, and one for its plane.
// Compilers would compute them one by one.
using Four [[gnu::vector_size(32)]] = double;
using FourBits [[gnu::vector_size(32)]] = std::int64_t;
using FourFloats [[gnu::vector_size(16)]] = float;

[[gnu::always_inline]] inline Four GetMagnitude(const Four& x)
{
  const FourBits allButSign = FourBits{} + INT64_MAX;
  return reinterpret_cast<Four>(reinterpret_cast<FourBits>(x) & allButSign);
}

/// Four vectors.
struct FourVectors
{
  Four X;
  Four Y;
  Four Z;
};

[[gnu::always_inline]] inline FourVectors Subtract(const FourVectors& p, const FourVectors& q)
{
  return { p.X - q.X, p.Y - q.Y, p.Z - q.Z };
}

[[gnu::always_inline]] inline FourVectors Cross(const FourVectors& p, const FourVectors& q)
{
  return { p.Y * q.Z - p.Z * q.Y, p.Z * q.X - p.X * q.Z, p.X * q.Y - p.Y * q.X };
}

// The 1-norms.
[[gnu::always_inline]] inline Four GetLengths(const FourVectors& p)
{
  return GetMagnitude(p.X) + GetMagnitude(p.Y) + GetMagnitude(p.Z);
}

[[gnu::always_inline]] inline FourVectors Scale(const FourVectors& p, const Four& factors)
{
  return { p.X * factors, p.Y * factors, p.Z * factors };
}

// Returns whether three edges all satisfy a condition.
[[gnu::always_inline]] inline bool AreAll(const FourBits& edges)
{
  return (edges[0] & edges[1] & edges[2]) != 0;
}

/// The edges and the plane of a triangle before they are scaled and rounded.
struct WideTriangle
{
  /// b x c, c x a, a x b and (b - a) x (c - a).
  FourVectors Normals;

  /// The 1-norms of the edges, and the product of the plane with a corner.
  Four Sizes;

  /// Whether single precision can represent them.
  bool AreEdgesGood;
  bool IsPlaneGood;
};

// `corners` has b, c, a and again b.
[[gnu::always_inline]] inline WideTriangle MakeWideTriangle(const FourVectors& corners)
{
  const Four zero = {};
  const FourVectors next = { __builtin_shufflevector(corners.X, zero, 1, 2, 0, 1),
    __builtin_shufflevector(corners.Y, zero, 1, 2, 0, 1),
    __builtin_shufflevector(corners.Z, zero, 1, 2, 0, 1) };
  const FourVectors a = { __builtin_shufflevector(corners.X, zero, 4, 4, 4, 2),
    __builtin_shufflevector(corners.Y, zero, 4, 4, 4, 2),
    __builtin_shufflevector(corners.Z, zero, 4, 4, 4, 2) };
  const FourVectors p = Subtract(corners, a);
  const FourVectors q = Subtract(next, a);
  const Four lengths = GetLengths(p);
  const Four products = lengths * GetLengths(q);
  WideTriangle wide;
  wide.Normals = Cross(p, q);
  const Four sizes = GetLengths(wide.Normals);
  const Four offsets = wide.Normals.X * a.X + wide.Normals.Y * a.Y + wide.Normals.Z * a.Z;
  const double offset = __builtin_fabs(offsets[3]);
  wide.Sizes = __builtin_shufflevector(sizes, offsets, 0, 1, 2, 7);
  wide.AreEdgesGood =
    AreAll((sizes > NarrowEdge * products) & (lengths > MinimumLength) & (lengths < MaximumLength));
  wide.IsPlaneGood =
    (offset > NarrowConditioned * products[3] * lengths[2]) & (offset > MinimumOffset);
  return wide;
}

// Sets all but the error. One copy for each coordinate, so that no load waits for several stores.
[[gnu::always_inline]] inline void Narrow(const FourVectors& vectors, lms3dNarrowTriangle& narrow)
{
  const FourFloats x = __builtin_convertvector(vectors.X, FourFloats);
  const FourFloats y = __builtin_convertvector(vectors.Y, FourFloats);
  const FourFloats z = __builtin_convertvector(vectors.Z, FourFloats);
  __builtin_memcpy(narrow.Vectors[0], &x, sizeof(x));
  __builtin_memcpy(narrow.Vectors[1], &y, sizeof(y));
  __builtin_memcpy(narrow.Vectors[2], &z, sizeof(z));
}

[[gnu::always_inline]] inline void SetPlaneError(bool isGood, lms3dNarrowTriangle& narrow)
{
  constexpr int Plane = lms3dNarrowTriangle::Plane;
  const float sum = __builtin_fabsf(narrow.Vectors[0][Plane]) +
    __builtin_fabsf(narrow.Vectors[1][Plane]) + __builtin_fabsf(narrow.Vectors[2][Plane]);
  isGood &= (sum > MinimumPlane) & (sum < MaximumPlane);
  narrow.PlaneError = isGood ? lms3dNarrowError * sum : -1.0f;
}

// Returns one coordinate of b, c, a and again b.
[[gnu::always_inline]] inline Four GetCoordinates(const double* const* corners, int axis)
{
  const double* const b = corners[1];
  return Four{ b[axis], corners[2][axis], corners[0][axis], b[axis] };
}

lms3dNarrowTriangle MakeNarrowTriangle(const lms3dSensorFrameTriangle& triangle, double unit)
{
  const double* const corners[3] = { triangle.Corner[0], triangle.Corner[1], triangle.Corner[2] };
  const WideTriangle wide = MakeWideTriangle(
    { GetCoordinates(corners, 0), GetCoordinates(corners, 1), GetCoordinates(corners, 2) });
  const double sign = wide.Sizes[3] > 0.0 ? 1.0 : -1.0;
  lms3dNarrowTriangle narrow;
  Narrow(Scale(wide.Normals, Four{ sign, sign, sign, unit } / wide.Sizes), narrow);
  SetPlaneError(wide.AreEdgesGood & wide.IsPlaneGood, narrow);
  return narrow;
}
} // namespace

#endif
