// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeCandidates.h"

#include "Casting/lms3dBoxedTriangles.h"
#include "Casting/lms3dEmbreeFreeRays.h"
#include "Casting/lms3dEmbreeRays.h"
#include "Casting/lms3dEmbreeTree.h"
#include "Casting/lms3dExactFreeTest.h"
#include "Casting/lms3dOutlyingTriangles.h"
#include "Casting/lms3dPacketBeams.h"

#include <limits>
#include <type_traits>
#include <vector>

namespace
{
/// A cast of beams that start at points of their own.
struct FreeCast
{
  const lms3dExactFreeTest* Test;
  const lms3dEmbreeFreeRays* Rays;
  lms3dFreePacket* Packet;
};

/// What Embree passes to the callback of a candidate.
struct Query
{
  /// The first member, so that Embree's pointer to the context is a pointer to the query.
  lms3dEmbreeContext Context;
  const lms3dExactView* View;
  const lms3dEmbreeRays* Rays;

  /// Null if all beams have one origin. Otherwise only this and the context are used.
  const FreeCast* Free = nullptr;

  lms3dPacketSearch Search;
};
static_assert(std::is_standard_layout_v<Query>, "a query starts with its context");

// Embree calls back with the whole packet, with a part that suits its instruction set, or with one
// ray. The id of a ray is the number of its beam.
lms3dRayRange GetRays(const RTCIntersectFunctionNArguments* args)
{
  RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
  RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, args->N);
  return { static_cast<int>(RTCRayN_id(rays, args->N, 0)), static_cast<int>(args->N),
    &RTCRayN_tfar(rays, args->N, 0), &RTCHitN_geomID(hits, args->N, 0) };
}

std::uint32_t GetBeams(const lms3dRayRange& rays)
{
  return ((1u << rays.Count) - 1u) << rays.First;
}
} // namespace

struct lms3dEmbreeCandidates::Internals
{
  explicit Internals(const lms3dTriangleMesh& mesh)
    : Mesh(mesh)
    , Outliers(lms3dFindOutlyingTriangles(mesh))
    , Tree(mesh, this->Outliers)
    , Boxes(mesh, this->Tree.GetNormalization(), this->Outliers)
  {
  }

  void Build(const lms3dProgress& progress)
  {
    const lms3dEmbreeHandle<RTCGeometry> geometry = this->Tree.NewGeometry(RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(
      geometry.get(), static_cast<unsigned int>(this->Boxes.GetCount()));
    rtcSetGeometryUserData(geometry.get(), this);
    rtcSetGeometryBoundsFunction(geometry.get(), &Internals::GetBox, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), &Internals::TestCandidate);
    // For boxes the fast builder gives trees that are as fast to traverse, in a third of the
    // memory.
    this->Tree.Build(geometry.get(), RTC_BUILD_QUALITY_LOW, progress);
  }

  static void GetBox(const RTCBoundsFunctionArguments* args)
  {
    const Internals* self = static_cast<const Internals*>(args->geometryUserPtr);
    const lms3dNormalizedBox box = self->Boxes.GetBox(args->primID);
    *args->bounds_o = { box.Low[0], box.Low[1], box.Low[2], 0.0f, box.High[0], box.High[1],
      box.High[2], 0.0f };
  }

  static void TestCandidate(const RTCIntersectFunctionNArguments* args)
  {
    const Internals* self = static_cast<const Internals*>(args->geometryUserPtr);
    Query* query = reinterpret_cast<Query*>(args->context);
    if (query->Free)
    {
      return self->TestFreeCandidate(args, *query->Free);
    }
    lms3dPacketSearch& search = query->Search;
    const lms3dRayRange rays = GetRays(args);
    const std::uint32_t beams = search.Packet->Active & GetBeams(rays);
    const std::uint32_t changed = self->TestBox(args->primID,
      [&](std::uint32_t triangle) { return query->View->Test(triangle, beams, search); });
    if (changed != 0)
    {
      query->Rays->Clip(search.Hits, changed, args->geomID, rays);
    }
  }

  void TestFreeCandidate(const RTCIntersectFunctionNArguments* args, const FreeCast& cast) const
  {
    const lms3dRayRange rays = GetRays(args);
    const std::uint32_t beams = cast.Packet->Active & GetBeams(rays);
    const std::uint32_t changed = this->TestBox(args->primID,
      [&](std::uint32_t triangle) { return cast.Test->Test(triangle, beams, *cast.Packet); });
    if (changed != 0)
    {
      cast.Rays->Clip(*cast.Packet, changed, args->geomID, rays);
    }
  }

  void Cast(Query& query, lms3dEmbreeRays& rays, lms3dBeamPacket& packet) const
  {
    const lms3dExactView& view = *query.View;
    view.Begin(packet, query.Search);
    const std::uint32_t known = this->TestOutliers(
      [&](std::uint32_t triangle) { return view.Test(triangle, packet.Active, query.Search); });
    const std::uint32_t active = rays.Prepare(packet);
    if (active != 0)
    {
      if (known != 0)
      {
        rays.Clip(query.Search.Hits, known);
      }
      rays.Intersect(active, query.Context);
    }
  }

  // Returns the beams that hit a triangle of a box. `test` tests one triangle.
  template <typename Test>
  std::uint32_t TestBox(std::uint32_t box, const Test& test) const
  {
    const lms3dBoxedTriangles::Range triangles = this->Boxes.Get(box);
    const std::uint32_t changed = test(triangles.First);
    return triangles.Count == 1 ? changed : changed | test(triangles.First + 1);
  }

  // Returns the beams that hit an outlier. `test` tests one triangle.
  template <typename Test>
  std::uint32_t TestOutliers(const Test& test) const
  {
    std::uint32_t changed = 0;
    for (std::uint32_t triangle : this->Outliers)
    {
      changed |= test(triangle);
    }
    return changed;
  }

  const lms3dTriangleMesh& Mesh;

  /// Each packet is tested against all outliers. The tree holds the others.
  const std::vector<std::uint32_t> Outliers;
  lms3dEmbreeTree Tree;
  const lms3dBoxedTriangles Boxes;
};

lms3dEmbreeCandidates::lms3dEmbreeCandidates(
  const lms3dTriangleMesh& mesh, const lms3dProgress& progress)
  : Internal(new Internals(mesh))
{
  this->Internal->Build(progress);
}

lms3dEmbreeCandidates::~lms3dEmbreeCandidates() = default;

const lms3dNormalization& lms3dEmbreeCandidates::GetNormalization() const
{
  return this->Internal->Tree.GetNormalization();
}

bool lms3dEmbreeCandidates::HasOutliers() const
{
  return !this->Internal->Outliers.empty();
}

double lms3dEmbreeCandidates::GetUnit() const
{
  return this->Internal->Tree.GetNormalization().GetDiagonal();
}

bool lms3dEmbreeCandidates::IsInBoundingSphere(const double point[3]) const
{
  return this->Internal->Tree.GetNormalization().GetCone(point).Minimum < 0.0;
}

lms3dCone lms3dEmbreeCandidates::GetCone(const double origin[3]) const
{
  lms3dCone cone = this->Internal->Tree.GetNormalization().GetCone(origin);
  if (!this->Internal->Outliers.empty())
  {
    cone.Minimum = -std::numeric_limits<double>::infinity();
  }
  return cone;
}

void lms3dEmbreeCandidates::Cast(
  const lms3dExactView& view, lms3dBeamPacket* packets, const lms3dPacketMask& which) const
{
  if (which.none())
  {
    return;
  }
  lms3dEmbreeRays rays(this->Internal->Tree, view.GetOrigin(), packets[0]);
  Query query;
  query.View = &view;
  query.Rays = &rays;
  query.Search.Kept = view.GetKept();
  for (std::size_t i = 0; i < which.size(); ++i)
  {
    if (which[i])
    {
      this->Internal->Cast(query, rays, packets[i]);
    }
  }
}

void lms3dEmbreeCandidates::CastFree(double maximumRange, lms3dFreePacket* packets, int count) const
{
  const lms3dExactFreeTest test(this->Internal->Mesh, maximumRange);
  lms3dEmbreeFreeRays rays(this->Internal->Tree, maximumRange);
  FreeCast cast = { &test, &rays, nullptr };
  Query query;
  query.Free = &cast;
  for (int i = 0; i < count; ++i)
  {
    lms3dFreePacket& packet = packets[i];
    cast.Packet = &packet;
    lms3dSetTriangle(lms3dBeamPacket::NoTriangle, packet);
    const std::uint32_t known = this->Internal->TestOutliers(
      [&](std::uint32_t triangle) { return test.Test(triangle, packet.Active, packet); });
    const std::uint32_t active = rays.Prepare(packet);
    if (active != 0)
    {
      rays.Clip(packet, known);
      rays.Intersect(active, query.Context);
    }
  }
}
