// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeRays.h"

#include <algorithm>

lms3dEmbreeRays::lms3dEmbreeRays(
  const lms3dEmbreeTree& tree, const lms3dRayOrigin& origin, const lms3dBeamPacket& packet)
  : Packet(tree)
  , Origin(origin)
  , Cone(tree.GetNormalization().GetCone(origin.Position))
  , RayOffset(tree.GetNormalization().GetRayOffset(origin.Position))
  , NarrowRayOffset(static_cast<float>(tree.GetNormalization().NormalizeLength(this->RayOffset)))
  , TFar(this->Packet.GetTFar(origin.MaximumRange, this->RayOffset))
{
  this->ShiftOrigins(packet);
}

void lms3dEmbreeRays::ShiftOrigins(const lms3dBeamPacket& packet)
{
  const lms3dNormalization& normalization = this->Packet.GetNormalization();
  RTCRay16& rays = this->Packet.RayHit.ray;
  float* const origins[3] = { rays.org_x, rays.org_y, rays.org_z };
  this->Near = ~0u;
  for (int axis = 0; axis < 3; ++axis)
  {
    const lms3dShiftedOrigin shifted = { this->Origin.Position[axis], this->RayOffset,
      normalization.GetCenter(axis), normalization.GetDiagonal(),
      lms3dEmbreeRayPacket::MaximumOriginDistance };
    this->Near &= this->Kernels.ShiftOrigins(shifted, packet.Direction[axis], origins[axis]);
  }
}

std::uint32_t lms3dEmbreeRays::Prepare(const lms3dBeamPacket& packet)
{
  const std::uint32_t active = packet.Active & this->Kernels.FindInCone(this->Cone, packet);
  if (active == 0)
  {
    return 0;
  }
  if (this->RayOffset > 0.0)
  {
    this->ShiftOrigins(packet);
  }
  this->Packet.SetDirections(packet);
  std::fill_n(this->Packet.RayHit.ray.tfar, lms3dBeamPacket::Size, this->TFar);
  return active & this->Near;
}

void lms3dEmbreeRays::Clip(const lms3dNarrowHits& hits, std::uint32_t beams)
{
  this->Clip(hits, beams, RTC_INVALID_GEOMETRY_ID,
    { 0, lms3dBeamPacket::Size, this->Packet.RayHit.ray.tfar, this->Packet.RayHit.hit.geomID });
}

void lms3dEmbreeRays::Clip(const lms3dNarrowHits& hits, std::uint32_t beams, unsigned int geometry,
  const lms3dRayRange& rays) const
{
  this->Kernels.ClipRays(hits, beams, this->NarrowRayOffset, geometry, rays);
}
