// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Kernels for beams that start at points of their own.
 */
#ifndef lms3dFreeKernels_inl
#define lms3dFreeKernels_inl

#include "Kernels/lms3dBeamKernels.inl"
#include "Kernels/lms3dInsideKernels.inl"
#include "Kernels/lms3dRangeKernels.inl"

namespace
{
// A beam that passes by this sphere with these margins is outside of the scene's cone
// (lms3dNormalization::GetCone), too. The margins exceed the margins of the cone and all rounding.
constexpr double OuterRadius = 0.5 * (1.0 + 1e-3);
constexpr double OuterRounding = 4e-15;
constexpr double OuterMargin = 1e-8;

/// Three corners in world coordinates, as a copy that no pointer can change.
struct WorldTriangle
{
  explicit WorldTriangle(const double* const* corners)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Corner[corner][axis] = corners[corner][axis];
      }
    }
  }

  [[gnu::always_inline]] lms3dSensorFrameTriangle GetInSensorFrame(
    const lms3dFreePacket& packet, int i) const
  {
    lms3dSensorFrameTriangle triangle;
    for (int corner = 0; corner < 3; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        triangle.Corner[corner][axis] = this->Corner[corner][axis] - packet.Origin[axis][i];
      }
    }
    return triangle;
  }

  double Corner[3][3];
};

void NarrowDirections(lms3dBeamPacket& packet)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < Size; ++i)
    {
      packet.NarrowDirection[axis][i] = Narrow(packet.Direction[axis][i]);
    }
  }
}

// A beam passes by a sphere of the radius r around the centre if its start p is outside and it
// leads away, or if its nearest point to the centre is outside: (p.d)^2 < p^2 - r^2. If the unit is
// so small that its inverse overflows, no beam is certain.
lms3dFreeStarts LocateStarts(
  const lms3dSceneFrame& frame, const lms3dFreePacket& packet, float* const* starts)
{
  const double center[3] = { frame.Center[0], frame.Center[1], frame.Center[2] };
  const double scale = 1.0 / frame.Unit;
  float* const x[3] = { starts[0], starts[1], starts[2] };
  Mask inside;
  Mask passingBy;
  for (int i = 0; i < Size; ++i)
  {
    double square = 0.0;
    double along = 0.0;
    double size = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double position = (packet.Origin[axis][i] - center[axis]) * scale;
      x[axis][i] = static_cast<float>(position);
      square += position * position;
      along += position * packet.Direction[axis][i];
      size += Magnitude(packet.Origin[axis][i]) + Magnitude(center[axis]);
    }
    const double radius = OuterRadius + OuterRounding * (size * scale);
    const double outside = square - radius * radius;
    inside.Set(i, square <= 0.25);
    const bool isBeside = (along > 0.0) | (along * along < outside * (1.0 - OuterMargin));
    passingBy.Set(i, (outside > 0.0) & isBeside);
  }
  return { inside.GetBits(), passingBy.GetBits() };
}

std::uint32_t ShiftStarts(const lms3dSceneFrame& frame, const double* rayOffsets,
  double maximumDistance, const lms3dFreePacket& packet, float* const* starts)
{
  std::uint32_t near = ~0u;
  for (int axis = 0; axis < 3; ++axis)
  {
    Mask isNear;
    for (int i = 0; i < Size; ++i)
    {
      const double position = ShiftOrigin(
        { packet.Origin[axis][i], rayOffsets[i], frame.Center[axis], frame.Unit, maximumDistance },
        packet.Direction[axis][i]);
      const bool isWithin = Magnitude(position) <= maximumDistance;
      starts[axis][i] = static_cast<float>(isWithin ? position : 0.0);
      isNear.Set(i, isWithin);
    }
    near &= isNear.GetBits();
  }
  return near;
}

// Ends a ray at `tfar` if that is nearer, and sets its geometry.
[[gnu::always_inline]] inline void EndRay(
  bool isChanged, float tfar, unsigned int geometry, const lms3dRayRange& rays, int i)
{
  // False if an extreme scale makes tfar no number.
  const bool isShorter = isChanged & (tfar < rays.TFar[i]);
  rays.TFar[i] = isShorter ? Maximum(0.0f, tfar) : rays.TFar[i];
  rays.Geometry[i] = isChanged ? geometry : rays.Geometry[i];
}

// The margin is that of the other ClipRays, and exceeds all rounding here as it does there.
void ClipFreeRays(const lms3dFreePacket& packet, std::uint32_t changed, double unit,
  const float* rayOffsets, unsigned int geometry, const lms3dRayRange& rays)
{
  const double scale = (1.0 + static_cast<double>(lms3dNarrowError)) / unit;
  const double* ranges = packet.Range + rays.First;
  const float* offsets = rayOffsets + rays.First;
  const std::uint32_t bits = changed >> rays.First;
  for (int i = 0; i < rays.Count; ++i)
  {
    const bool isChanged = (bits >> i) & 1u;
    const float tfar = static_cast<float>(ranges[i] * scale) - offsets[i];
    EndRay(isChanged, tfar, geometry, rays, i);
  }
}

lms3dFreeMasks UpdateFree(const double* const* corners, std::int32_t triangle, std::uint32_t beams,
  double maximumRange, lms3dFreePacket& packet)
{
  const WorldTriangle world(corners);
  Mask hits;
  Mask uncertain;
  for (int i = 0; i < Size; ++i)
  {
    const lms3dSensorFrameTriangle inSensorFrame = world.GetInSensorFrame(packet, i);
    Edge<double> edges[3];
    MakeEdges(inSensorFrame, edges);
    const Limits<double> limits = FindLimits(edges, packet.Direction, i);
    hits.Set(i, IsHit(limits));
    uncertain.Set(i, !(IsHit(limits) | IsMiss(limits)));
  }
  const std::uint32_t hit = hits.GetBits() & beams;
  const std::uint32_t needInsideTest = uncertain.GetBits() & beams;
  if (hit == 0)
  {
    return { 0, needInsideTest, needInsideTest };
  }

  const RangeLimits limits(maximumRange);
  Mask bad;
  Mask nearer;
  alignas(64) double ranges[Size];
  for (int i = 0; i < Size; ++i)
  {
    const lms3dDoublePlane plane = MakePlane(world.GetInSensorFrame(packet, i));
    const double slope = Dot(packet.Direction, i, plane.Normal);
    const double range = plane.Offset / slope;
    ranges[i] = range;
    nearer.Set(i, IsNearer(range, triangle, limits, packet, i));
    bad.Set(i, IsBad(range, slope, plane, limits) | !plane.IsWellConditioned);
  }
  const std::uint32_t changed = hit & nearer.GetBits() & ~bad.GetBits();
  StoreNearest(ranges, triangle, changed, packet);
  return { changed, needInsideTest | (hit & bad.GetBits()), needInsideTest };
}

std::uint32_t IntersectFreePlane(
  const lms3dFreePlane& plane, const lms3dFreePacket& packet, double* ranges)
{
  const lms3dFreePlane local = plane;
  const double firstLength = local.EdgeLengths[0];
  const double secondLength = local.EdgeLengths[1];
  alignas(64) double measured[Size];
  Mask near;
  for (int i = 0; i < Size; ++i)
  {
    Pair offset = { 0.0, 0.0 };
    double distance = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Pair toCorner = lms3dTwoDifference(local.Corner[axis], packet.Origin[axis][i]);
      offset = Add(offset, Multiply(local.Normal[axis], toCorner));
      distance += Magnitude(toCorner.High);
    }
    const double size = Maximum(Maximum(distance, firstLength), secondLength);
    near.Set(i, Magnitude(offset.High) <= lms3dNearPlane * size * firstLength * secondLength);
    measured[i] = Intersect(local.Normal, offset, packet.Direction, i);
  }
  for (int i = 0; i < Size; ++i)
  {
    ranges[i] = measured[i];
  }
  return near.GetBits();
}

std::uint32_t IntersectFreeDoublePlane(
  const double* const* corners, const lms3dFreePacket& packet, double* ranges)
{
  const WorldTriangle world(corners);
  Mask good;
  alignas(64) double measured[Size];
  for (int i = 0; i < Size; ++i)
  {
    const lms3dDoublePlane plane = MakePlane(world.GetInSensorFrame(packet, i));
    measured[i] = plane.Offset / Dot(packet.Direction, i, plane.Normal);
    good.Set(i, plane.IsWellConditioned);
  }
  for (int i = 0; i < Size; ++i)
  {
    ranges[i] = measured[i];
  }
  return good.GetBits();
}
} // namespace

#endif
