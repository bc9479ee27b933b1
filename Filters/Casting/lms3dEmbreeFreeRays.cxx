// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeFreeRays.h"

#include "Casting/lms3dBitMask.h"
#include "Casting/lms3dPacketBeams.h"

#include <algorithm>

namespace
{
lms3dSceneFrame MakeFrame(const lms3dNormalization& normalization)
{
  return { { normalization.GetCenter(0), normalization.GetCenter(1), normalization.GetCenter(2) },
    normalization.GetDiagonal() };
}
} // namespace

lms3dEmbreeFreeRays::lms3dEmbreeFreeRays(const lms3dEmbreeTree& tree, double maximumRange)
  : Packet(tree)
  , Frame(MakeFrame(tree.GetNormalization()))
  , MaximumRange(maximumRange)
  , TFar(this->Packet.GetTFar(maximumRange, 0.0))
{
  this->ClearOffsets();
}

void lms3dEmbreeFreeRays::ClearOffsets()
{
  std::fill_n(this->RayOffsets, lms3dBeamPacket::Size, 0.0);
  std::fill_n(this->NarrowRayOffsets, lms3dBeamPacket::Size, 0.0f);
  this->HasOffsets = false;
}

std::uint32_t lms3dEmbreeFreeRays::Prepare(lms3dFreePacket& packet)
{
  RTCRay16& rays = this->Packet.RayHit.ray;
  float* const starts[3] = { rays.org_x, rays.org_y, rays.org_z };
  const lms3dFreeStarts located = this->Kernels.Free.LocateStarts(this->Frame, packet, starts);
  std::uint32_t active = packet.Active & ~located.PassingBy;
  if (active == 0)
  {
    return 0;
  }
  std::fill_n(rays.tfar, lms3dBeamPacket::Size, this->TFar);
  if (this->HasOffsets)
  {
    this->ClearOffsets();
  }
  const std::uint32_t outside = active & ~located.Inside;
  if (outside != 0)
  {
    active &= located.Inside | this->OffsetStarts(packet, outside, starts);
  }
  this->Kernels.Free.NarrowDirections(packet);
  this->Packet.SetDirections(packet);
  return active;
}

// Returns the beams in `beams` that lead towards the scene and start near enough to it.
std::uint32_t lms3dEmbreeFreeRays::OffsetStarts(
  const lms3dFreePacket& packet, std::uint32_t beams, float* const* starts)
{
  std::uint32_t towards = 0;
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    if (lms3dHasBit(beams, beam) && this->OffsetStart(packet, beam))
    {
      towards |= 1u << beam;
    }
  }
  return towards &
    this->Kernels.Free.ShiftStarts(
      this->Frame, this->RayOffsets, lms3dEmbreeRayPacket::MaximumOriginDistance, packet, starts);
}

// Returns false if the beam passes by the sphere around the scene.
bool lms3dEmbreeFreeRays::OffsetStart(const lms3dFreePacket& packet, int beam)
{
  const lms3dNormalization& normalization = this->Packet.GetNormalization();
  const lms3dVector origin = lms3dGetOrigin(packet, beam);
  const lms3dCone cone = normalization.GetCone(origin.data());
  const lms3dVector axis = { cone.Axis[0], cone.Axis[1], cone.Axis[2] };
  if (!(lms3dDot(lms3dGetDirection(packet, beam), axis) >= cone.Minimum))
  {
    return false;
  }
  const double offset = normalization.GetRayOffset(origin.data());
  if (offset > 0.0)
  {
    this->HasOffsets = true;
    this->RayOffsets[beam] = offset;
    this->NarrowRayOffsets[beam] = static_cast<float>(normalization.NormalizeLength(offset));
    this->Packet.RayHit.ray.tfar[beam] = this->Packet.GetTFar(this->MaximumRange, offset);
  }
  return true;
}

void lms3dEmbreeFreeRays::Clip(const lms3dFreePacket& packet, std::uint32_t beams)
{
  if (beams != 0)
  {
    this->Clip(packet, beams, RTC_INVALID_GEOMETRY_ID,
      { 0, lms3dBeamPacket::Size, this->Packet.RayHit.ray.tfar, this->Packet.RayHit.hit.geomID });
  }
}

void lms3dEmbreeFreeRays::Clip(const lms3dFreePacket& packet, std::uint32_t beams,
  unsigned int geometry, const lms3dRayRange& rays) const
{
  this->Kernels.Free.ClipRays(
    packet, beams, this->Frame.Unit, this->NarrowRayOffsets, geometry, rays);
}
