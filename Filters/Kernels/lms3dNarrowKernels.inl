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
// The share of WellConditioned at which single precision gives up.
constexpr double NarrowConditioned = 1e-3;

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

bool IsWithin(double low, double x, double high)
{
  return (x > low) & (x < high);
}

lms3dNarrowTriangle MakeNarrowTriangle(const lms3dSensorFrameTriangle& triangle, double unit)
{
  const double(&corner)[3][3] = triangle.Corner;
  const double size[3] = { SumOfMagnitudes(corner[0]), SumOfMagnitudes(corner[1]),
    SumOfMagnitudes(corner[2]) };
  const lms3dDoublePlane plane = MakeDoublePlane(triangle);
  const double side = plane.Offset > 0.0 ? 1.0 : -1.0;
  lms3dNarrowTriangle narrow;
  const double offset = Magnitude(plane.Offset);
  bool isGood =
    (offset > NarrowConditioned * plane.MinimumSlope * size[0]) & (offset > MinimumOffset);
  for (int e = 0; e < 3; ++e)
  {
    const int next = (e + 1) % 3;
    const int last = (e + 2) % 3;
    const double scale = side / (size[next] * size[last]);
    const Edge<double> edge = MakeEdge(corner[next], corner[last], 0.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      narrow.Edge[e][axis] = static_cast<float>(edge.Normal[axis] * scale);
    }
    isGood &= IsWithin(MinimumLength, size[e], MaximumLength);
  }
  const double scale = unit / plane.Offset;
  float sum = 0.0f;
  for (int axis = 0; axis < 3; ++axis)
  {
    narrow.Plane[axis] = static_cast<float>(plane.Normal[axis] * scale);
    sum += narrow.Plane[axis] < 0.0f ? -narrow.Plane[axis] : narrow.Plane[axis];
  }
  isGood &= IsWithin(MinimumPlane, sum, MaximumPlane);
  narrow.PlaneError = isGood ? lms3dNarrowError * sum : -1.0f;
  return narrow;
}

lms3dNarrowMasks UpdateNarrow(const lms3dNarrowTriangle& triangle, std::int32_t number,
  std::uint32_t beams, lms3dBeamPacket& packet, lms3dNarrowHits& hits)
{
  const float(&direction)[3][Size] = packet.NarrowDirection;
  alignas(64) float inside[Size];
  Mask mayHit;
  for (int i = 0; i < Size; ++i)
  {
    const float a = Dot(direction, i, triangle.Edge[0]);
    const float b = Dot(direction, i, triangle.Edge[1]);
    const float c = Dot(direction, i, triangle.Edge[2]);
    inside[i] = Minimum(Minimum(a, b), c);
    mayHit.Set(i, inside[i] > -lms3dNarrowError);
  }
  beams &= mayHit.GetBits();
  if (beams == 0)
  {
    return { 0, 0 };
  }
  const float error = triangle.PlaneError;
  Mask nearer;
  Mask farther;
  alignas(64) float inverse[Size];
  for (int i = 0; i < Size; ++i)
  {
    inverse[i] = Dot(direction, i, triangle.Plane);
    const float margin = hits.Error[i] + error;
    nearer.Set(i, (inside[i] > lms3dNarrowError) & (inverse[i] > hits.InverseRange[i] + margin));
    farther.Set(i, inverse[i] < hits.InverseRange[i] - margin);
  }
  const std::uint32_t changed = beams & nearer.GetBits();
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
