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
#include "Kernels/lms3dNarrowTriangle.inl"
#include "Kernels/lms3dPacketMask.inl"

namespace
{
// Hits that are nearer keep this value, which no triangle in single precision reaches.
constexpr double MaximumInverse = 1e30;

// The sizes of edges, square metres, that single precision holds without scaling.
constexpr double MinimumEdge = 1e-20;
constexpr double MaximumEdge = 1e20;

// Returns sum + x y, rounded once by an instruction set with fused multiply-add, and else twice.
// The bounds of the errors hold for both. So one set may be unsure where another is sure, but they
// never contradict.
[[gnu::always_inline]] inline float AddProduct(float sum, float x, float y)
{
#ifdef __FMA__
  return __builtin_fmaf(x, y, sum);
#else
  return sum + x * y;
#endif
}

// Returns the product of vector i of sixteen with one other vector.
[[gnu::always_inline]] inline float NarrowDot(const float (&x)[3][Size], int i, const float* y)
{
  return AddProduct(AddProduct(x[0][i] * y[0], x[1][i], y[1]), x[2][i], y[2]);
}

// Returns the product of a direction with an edge or the plane.
[[gnu::always_inline]] inline float NarrowDot(
  const float (&x)[3][Size], int i, const lms3dNarrowTriangle& triangle, int vector)
{
  const float y[3] = { triangle.Vectors[0][vector], triangle.Vectors[1][vector],
    triangle.Vectors[2][vector] };
  return NarrowDot(x, i, y);
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
    inverse[i] = NarrowDot(packet.NarrowDirection, i, triangle, lms3dNarrowTriangle::Plane);
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
    const float a = NarrowDot(direction, i, triangle, 0);
    const float b = NarrowDot(direction, i, triangle, 1);
    const float c = NarrowDot(direction, i, triangle, 2);
    const float minimum = Minimum(Minimum(a, b), c);
    isInside.Set(i, minimum > lms3dNarrowError);
    mayHit.Set(i, minimum > -lms3dNarrowError);
  }
  beams &= mayHit.GetBits();
  return beams == 0 ? lms3dNarrowMasks{ 0, 0 }
                    : KeepNearer(triangle, number, beams, isInside, packet, hits);
}

// Finds the beams that pass inside edges which are not scaled, whose 1-norms are `sizes`. Products
// of one sign mean inside, or in the opposite direction.
[[gnu::always_inline]] inline void CompareWithUnscaledEdges(const lms3dBeamPacket& packet,
  const lms3dNarrowTriangle& edges, const Four& sizes, Mask& isInside, Mask& mayHit)
{
  const FourFloats error = __builtin_convertvector(sizes * lms3dNarrowError, FourFloats);
  const float(&direction)[3][Size] = packet.NarrowDirection;
  for (int i = 0; i < Size; ++i)
  {
    const float x = NarrowDot(direction, i, edges, 0);
    const float y = NarrowDot(direction, i, edges, 1);
    const float z = NarrowDot(direction, i, edges, 2);
    isInside.Set(i,
      ((x > error[0]) & (y > error[1]) & (z > error[2])) |
        ((x < -error[0]) & (y < -error[1]) & (z < -error[2])));
    mayHit.Set(i,
      ((x > -error[0]) & (y > -error[1]) & (z > -error[2])) |
        ((x < error[0]) & (y < error[1]) & (z < error[2])));
  }
}

// Edges are not scaled, since a beam that passes outside would wait for the division. The side of
// the triangle on which the sensor stands is left open: the plane gives it. In the opposite
// direction it gives no range above 0.
lms3dNarrowMasks UpdateFromCorners(const lms3dCornerPoints& points, std::int32_t number,
  std::uint32_t beams, lms3dBeamPacket& packet, lms3dNarrowHits& hits)
{
  const double* const o = points.Origin;
  const WideTriangle wide = MakeWideTriangle({ GetCoordinates(points.Corner, 0) - o[0],
    GetCoordinates(points.Corner, 1) - o[1], GetCoordinates(points.Corner, 2) - o[2] });
  const bool areInRange = AreAll((wide.Sizes > MinimumEdge) & (wide.Sizes < MaximumEdge));
  if (!(wide.AreEdgesGood & areInRange))
  {
    return { 0, beams };
  }
  lms3dNarrowTriangle narrow;
  Narrow(wide.Normals, narrow);
  Mask isInside;
  Mask mayHit;
  CompareWithUnscaledEdges(packet, narrow, wide.Sizes, isInside, mayHit);
  beams &= mayHit.GetBits();
  if (beams == 0)
  {
    return { 0, 0 };
  }
  Narrow(Scale(wide.Normals, Four{} + points.Unit / wide.Sizes[3]), narrow);
  SetPlaneError(wide.IsPlaneGood, narrow);
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
