// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeRays.h"

#include "Casting/lms3dBitMask.h"

#include <algorithm>

namespace
{
static_assert(lms3dBeamPacket::Size == 16, "packets are cast by rtcIntersect16");

// In diagonals of the scene from its centre. A ray that can hit starts within two and a half; one that
// points away from a far scene starts even farther away than the sensor, where single precision, and
// Embree's assertions, end.
constexpr double MaximumOriginDistance = 10.0;

// How far beyond the maximum range Embree still searches: the margin covers the single precision of
// tfar, the rounding that of the difference between range and ray offset. Both are relative.
constexpr double TFarMargin = 1.0 + 1e-6;
constexpr double RangeRounding = 1e-15;
} // namespace

lms3dEmbreeRays::lms3dEmbreeRays(
  const lms3dEmbreeTree& tree, const lms3dRayOrigin& origin, const lms3dBeamPacket& packet)
  : Tree(tree)
  , Origin(origin)
  , Cone(tree.GetNormalization().GetCone(origin.Position))
  , RayOffset(tree.GetNormalization().GetRayOffset(origin.Position))
  , NarrowRayOffset(static_cast<float>(tree.GetNormalization().NormalizeLength(this->RayOffset)))
  , TFar(this->GetTFar(origin.MaximumRange))
{
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    this->RayHit.ray.tnear[beam] = 0.0f;
    this->RayHit.ray.time[beam] = 0.0f;
    this->RayHit.ray.mask[beam] = ~0u;
    this->RayHit.ray.id[beam] = static_cast<unsigned int>(beam);
    this->RayHit.ray.flags[beam] = 0;
    this->RayHit.hit.instID[0][beam] = RTC_INVALID_GEOMETRY_ID;
  }
  this->ShiftOrigins(packet);
}

float lms3dEmbreeRays::GetTFar(double range) const
{
  const double distance = (range - this->RayOffset) * TFarMargin + range * RangeRounding;
  return std::max(
    0.0f, static_cast<float>(this->Tree.GetNormalization().NormalizeLength(distance)));
}

void lms3dEmbreeRays::ShiftOrigins(const lms3dBeamPacket& packet)
{
  const lms3dNormalization& normalization = this->Tree.GetNormalization();
  RTCRay16& rays = this->RayHit.ray;
  float* const origins[3] = { rays.org_x, rays.org_y, rays.org_z };
  this->Near = ~0u;
  for (int axis = 0; axis < 3; ++axis)
  {
    const lms3dShiftedOrigin shifted = { this->Origin.Position[axis], this->RayOffset,
      normalization.GetCenter(axis), normalization.GetDiagonal(), MaximumOriginDistance };
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
  const float(&direction)[3][lms3dBeamPacket::Size] = packet.NarrowDirection;
  std::copy_n(direction[0], lms3dBeamPacket::Size, this->RayHit.ray.dir_x);
  std::copy_n(direction[1], lms3dBeamPacket::Size, this->RayHit.ray.dir_y);
  std::copy_n(direction[2], lms3dBeamPacket::Size, this->RayHit.ray.dir_z);
  std::fill_n(this->RayHit.ray.tfar, lms3dBeamPacket::Size, this->TFar);
  std::fill_n(this->RayHit.hit.geomID, lms3dBeamPacket::Size, RTC_INVALID_GEOMETRY_ID);
  return active & this->Near;
}

void lms3dEmbreeRays::Clip(const lms3dNarrowHits& hits, std::uint32_t beams)
{
  this->Clip(hits, beams, RTC_INVALID_GEOMETRY_ID,
    { 0, lms3dBeamPacket::Size, this->RayHit.ray.tfar, this->RayHit.hit.geomID });
}

void lms3dEmbreeRays::Clip(const lms3dNarrowHits& hits, std::uint32_t beams, unsigned int geometry,
  const lms3dRayRange& rays) const
{
  this->Kernels.ClipRays(hits, beams, this->NarrowRayOffset, geometry, rays);
}

void lms3dEmbreeRays::Intersect(std::uint32_t beams, lms3dEmbreeContext& context)
{
  alignas(64) int valid[lms3dBeamPacket::Size];
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    valid[beam] = lms3dHasBit(beams, beam) ? -1 : 0;
  }
#if LMS3D_EMBREE_MAJOR >= 4
  rtcInitRayQueryContext(&context);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  arguments.context = &context;
  rtcIntersect16(valid, this->Tree.GetScene(), &this->RayHit, &arguments);
#else
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid, this->Tree.GetScene(), &context, &this->RayHit);
#endif
}

void lms3dEmbreeRays::StoreTriangles(lms3dBeamPacket& packet) const
{
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    packet.Triangle[beam] = this->RayHit.hit.geomID[beam] == RTC_INVALID_GEOMETRY_ID
      ? lms3dBeamPacket::NoTriangle
      : static_cast<std::int32_t>(this->RayHit.hit.primID[beam]);
  }
}
