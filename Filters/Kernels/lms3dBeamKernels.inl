// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Kernels on rays: directions, origins, ends, and the points of returns.
 */
#ifndef lms3dBeamKernels_inl
#define lms3dBeamKernels_inl

#include "Kernels/lms3dPacketMask.inl"
#include "Kernels/lms3dPairArithmetic.inl"

#include <cstddef>
#include <cstdint>

namespace
{
// Embree loses coherent packets with a tiny negative direction component: it sorts the packet by
// the component's sign, but replaces reciprocals of components below 1e-18 by a positive number.
constexpr double MinimumComponent = 1e-15;

// Rounds a component of a direction to single precision.
float Narrow(double component)
{
  return static_cast<float>(Magnitude(component) < MinimumComponent ? 0.0 : component);
}

void GenerateDirections(
  const lms3dElevations& elevations, const lms3dFanAxes& axes, lms3dBeamPacket& packet)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < Size; ++i)
    {
      const double component =
        elevations.Cosine[i] * axes.Horizontal[axis][i] + elevations.Sine[i] * axes.Up[axis];
      packet.Direction[axis][i] = component;
      packet.NarrowDirection[axis][i] = Narrow(component);
    }
  }
}

std::uint32_t FindInCone(const lms3dCone& cone, const lms3dBeamPacket& packet)
{
  Mask within;
  for (int i = 0; i < Size; ++i)
  {
    within.Set(i, Dot(packet.Direction, i, cone.Axis) >= cone.Minimum);
  }
  return within.GetBits();
}

// Returns one coordinate of where a ray starts. Far from the scene, the origin and the ray offset
// nearly cancel; twice the digits of a double keep the difference.
[[gnu::always_inline]] inline double ShiftOrigin(const lms3dShiftedOrigin& origin, double direction)
{
  const Pair fromCenter = lms3dTwoDifference(origin.Origin, origin.Center);
  return Add(fromCenter, Multiply(origin.RayOffset, direction)).High / origin.Unit;
}

std::uint32_t ShiftOrigins(
  const lms3dShiftedOrigin& origin, const double* directions, float* origins)
{
  Mask near;
  for (int i = 0; i < Size; ++i)
  {
    const double position = ShiftOrigin(origin, directions[i]);
    const bool isNear = Magnitude(position) <= origin.MaximumDistance;
    origins[i] = static_cast<float>(isNear ? position : 0.0);
    near.Set(i, isNear);
  }
  return near.GetBits();
}

// Ends the rays of changed beams. Beams without a ray may have any values.
void EndRays(const lms3dNarrowHits& hits, std::uint32_t changed, float rayOffset,
  unsigned int geometry, float (&tfar)[Size], unsigned int (&geometries)[Size])
{
  alignas(64) float end[Size];
  Mask isShorter;
  for (int i = 0; i < Size; ++i)
  {
    const float tfarOfHit = 1.0f / (hits.InverseRange[i] - hits.Error[i]) - rayOffset;
    // False if an extreme scale makes the end no number.
    isShorter.Set(i, tfarOfHit < tfar[i]);
    end[i] = Maximum(0.0f, tfarOfHit);
  }
  const std::uint32_t shorter = changed & isShorter.GetBits();
  for (int i = 0; i < Size; ++i)
  {
    tfar[i] = (shorter >> i) & 1u ? end[i] : tfar[i];
    geometries[i] = (changed >> i) & 1u ? geometry : geometries[i];
  }
}

// Vector instructions need arrays of a fixed length that overlap nothing else, so the rays are
// copied.
[[gnu::always_inline]] inline void ClipPart(const lms3dNarrowHits& hits, std::uint32_t changed,
  float rayOffset, unsigned int geometry, const lms3dRayRange& rays, std::size_t count)
{
  alignas(64) float tfar[Size];
  alignas(64) unsigned int geometries[Size];
  __builtin_memcpy(tfar + rays.First, rays.TFar, count * sizeof(float));
  __builtin_memcpy(geometries + rays.First, rays.Geometry, count * sizeof(unsigned int));
  EndRays(hits, changed, rayOffset, geometry, tfar, geometries);
  __builtin_memcpy(rays.TFar, tfar + rays.First, count * sizeof(float));
  __builtin_memcpy(rays.Geometry, geometries + rays.First, count * sizeof(unsigned int));
}

// The error bound of a hit is larger than all rounding here, and than what Embree loses by the
// single precision of tfar. So no hit hides another triangle at the same range.
void ClipRays(const lms3dNarrowHits& hits, std::uint32_t changed, float rayOffset,
  unsigned int geometry, const lms3dRayRange& rays)
{
  // Embree's own lengths have copies without a call.
  switch (rays.Count)
  {
    case 16:
      return ClipPart(hits, changed, rayOffset, geometry, rays, 16);
    case 8:
      return ClipPart(hits, changed, rayOffset, geometry, rays, 8);
    case 4:
      return ClipPart(hits, changed, rayOffset, geometry, rays, 4);
    default:
      return ClipPart(
        hits, changed, rayOffset, geometry, rays, static_cast<std::size_t>(rays.Count));
  }
}

void LocateSome(const lms3dReturnsOfTurn& returns, int begin, int end, double* points)
{
  const double fan[3] = { returns.FanAxis[0], returns.FanAxis[1], returns.FanAxis[2] };
  const double up[3] = { returns.Up[0], returns.Up[1], returns.Up[2] };
  const double position[3] = { returns.Position[0], returns.Position[1], returns.Position[2] };
  for (int i = begin; i < end; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double direction = returns.Cosines[i] * fan[axis] + returns.Sines[i] * up[axis];
      points[3 * i + axis] = position[axis] + returns.Ranges[i] * direction;
    }
  }
}

// Starts the loop over vectors at a cache line: vectors that lie in one line are stored faster.
void Locate(const lms3dReturnsOfTurn& returns, double* points)
{
  int first = 0;
  while (first < returns.Count && reinterpret_cast<std::uintptr_t>(points + 3 * first) % 64 != 0)
  {
    ++first;
  }
  LocateSome(returns, 0, first, points);
  LocateSome(returns, first, returns.Count, points);
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

void ApplyMinimumRange(double minimumRange, lms3dBeamPacket& packet)
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

#endif
