// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeRayPacket.h"

#include "Casting/lms3dBitMask.h"

#include <algorithm>
#include <limits>

namespace
{
static_assert(lms3dBeamPacket::Size == 16, "packets are cast by rtcIntersect16");

// How far beyond the maximum range Embree still searches: the margin covers the single precision of
// tfar, the rounding that of the difference between range and ray offset. Both are relative.
constexpr double TFarMargin = 1.0 + 1e-6;
constexpr double RangeRounding = 1e-15;
} // namespace

lms3dEmbreeRayPacket::lms3dEmbreeRayPacket(const lms3dEmbreeTree& tree)
  : Tree(tree)
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
}

void lms3dEmbreeRayPacket::SetDirections(const lms3dBeamPacket& packet)
{
  const float(&direction)[3][lms3dBeamPacket::Size] = packet.NarrowDirection;
  std::copy_n(direction[0], lms3dBeamPacket::Size, this->RayHit.ray.dir_x);
  std::copy_n(direction[1], lms3dBeamPacket::Size, this->RayHit.ray.dir_y);
  std::copy_n(direction[2], lms3dBeamPacket::Size, this->RayHit.ray.dir_z);
  std::fill_n(this->RayHit.hit.geomID, lms3dBeamPacket::Size, RTC_INVALID_GEOMETRY_ID);
}

float lms3dEmbreeRayPacket::GetTFar(double range, double rayOffset) const
{
  const double distance = (range - rayOffset) * TFarMargin + range * RangeRounding;
  return std::max(0.0f, static_cast<float>(this->GetNormalization().NormalizeLength(distance)));
}

void lms3dEmbreeRayPacket::Intersect(std::uint32_t beams, lms3dEmbreeContext& context)
{
  // With instructions for fewer than 16 rays, Embree 3 ignores `valid`. But it never casts a ray
  // that ends before it starts.
  alignas(64) int valid[lms3dBeamPacket::Size];
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    const bool isCast = lms3dHasBit(beams, beam);
    float& end = this->RayHit.ray.tfar[beam];
    valid[beam] = isCast ? -1 : 0;
    end = isCast ? end : -std::numeric_limits<float>::infinity();
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

void lms3dEmbreeRayPacket::StoreTriangles(lms3dBeamPacket& packet) const
{
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    packet.Triangle[beam] = this->RayHit.hit.geomID[beam] == RTC_INVALID_GEOMETRY_ID
      ? lms3dBeamPacket::NoTriangle
      : static_cast<std::int32_t>(this->RayHit.hit.primID[beam]);
  }
}
