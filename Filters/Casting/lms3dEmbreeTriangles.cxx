// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeTriangles.h"

#include "Casting/lms3dEmbreeFreeRays.h"
#include "Casting/lms3dEmbreeRays.h"
#include "Casting/lms3dEmbreeTree.h"
#include "Casting/lms3dPacketBeams.h"

#include <cstddef>

namespace
{
// Embree gets its own vertices and shares the indices.
lms3dEmbreeHandle<RTCGeometry> MakeGeometry(
  const lms3dTriangleMesh& mesh, const lms3dTriangleIndices& indices, const lms3dEmbreeTree& tree)
{
  lms3dEmbreeHandle<RTCGeometry> geometry = tree.NewGeometry(RTC_GEOMETRY_TYPE_TRIANGLE);
  float* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry.get(),
    RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.Points.size()));
  rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
    indices.data(), 0, 3 * sizeof(std::uint32_t), indices.size());
  tree.ThrowOnError();
  for (const std::array<double, 3>& point : mesh.Points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      *vertex++ =
        static_cast<float>(tree.GetNormalization().NormalizeCoordinate(point.data(), axis));
    }
  }
  return geometry;
}

template <typename Rays, typename Packet>
void FindTriangles(Rays& rays, Packet* packets, int count)
{
  lms3dEmbreeContext context;
  for (int i = 0; i < count; ++i)
  {
    Packet& packet = packets[i];
    lms3dSetTriangle(lms3dBeamPacket::NoTriangle, packet);
    const std::uint32_t active = rays.Prepare(packet);
    if (active != 0)
    {
      rays.Intersect(active, context);
      rays.StoreTriangles(packet);
    }
  }
}
} // namespace

lms3dEmbreeTriangles::lms3dEmbreeTriangles(
  const lms3dTriangleMesh& mesh, const lms3dTriangleIndices& indices, const lms3dProgress& progress)
  : Tree(new lms3dEmbreeTree(mesh))
{
  this->Tree->Build(
    MakeGeometry(mesh, indices, *this->Tree).get(), RTC_BUILD_QUALITY_MEDIUM, progress);
}

lms3dEmbreeTriangles::~lms3dEmbreeTriangles() = default;

void lms3dEmbreeTriangles::Cast(
  const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const
{
  lms3dEmbreeRays rays(*this->Tree, origin, packets[0]);
  FindTriangles(rays, packets, count);
}

void lms3dEmbreeTriangles::CastFree(double maximumRange, lms3dFreePacket* packets, int count) const
{
  lms3dEmbreeFreeRays rays(*this->Tree, maximumRange);
  FindTriangles(rays, packets, count);
}
