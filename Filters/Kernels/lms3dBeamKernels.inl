// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where beams go: directions, starts, ends.
 */
#ifndef lms3dBeamKernels_inl
#define lms3dBeamKernels_inl

#include "Kernels/lms3dPacketMask.inl"
#include "Kernels/lms3dPairArithmetic.inl"

namespace
{
// Embree loses packets in which a direction component is a tiny negative number: its reciprocal is
// taken as positive while the packet was sorted by the sign.
constexpr double SmallestComponent = 1e-15;

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

// From far away the digits of the start that count are those that double would round.
std::uint32_t SetStarts(const lms3dStart& start, const double* directions, float* starts)
{
  const Pair fromCenter = Subtract(start.Origin, start.Center);
  Mask near;
  for (int i = 0; i < Size; ++i)
  {
    const Pair seen = Add(fromCenter, Multiply(start.HeadStart, directions[i]));
    const double position = seen.High / start.Unit;
    const bool isNear = Magnitude(position) <= start.Farthest;
    starts[i] = static_cast<float>(isNear ? position : 0.0);
    near.Set(i, isNear);
  }
  return near.GetBits();
}

void Shorten(const lms3dBeamPacket& packet, std::uint32_t changed, double headStart, double unit,
  unsigned int geometry, const lms3dRayRun& run)
{
  const double* range = packet.Range + run.First;
  const std::uint32_t bits = changed >> run.First;
  for (int i = 0; i < run.Count; ++i)
  {
    const bool isChanged = (bits >> i) & 1u;
    const double reach =
      ((range[i] - headStart) * lms3dReachMargin + range[i] * lms3dRangeRounding) / unit;
    run.Reach[i] = isChanged ? static_cast<float>(Greatest(0.0, reach)) : run.Reach[i];
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

std::uint32_t FindHits(const lms3dBeamPacket& packet)
{
  Mask hits;
  for (int i = 0; i < Size; ++i)
  {
    hits.Set(i, packet.Triangle[i] != lms3dBeamPacket::NoTriangle);
  }
  return hits.GetBits();
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

#endif
