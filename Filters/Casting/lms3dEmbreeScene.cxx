// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dEmbreeScene.h"

#include "Casting/lms3dEmbreeBuild.h"
#include "Casting/lms3dEmbreeHandles.h"
#include "Casting/lms3dOutlyingTriangles.h"
#include "Kernels/lms3dPacketKernels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>

namespace
{
using Geometry = lms3dEmbreeHandle<RTCGeometry>;

#if LMS3D_EMBREE_MAJOR >= 4
using QueryContext = RTCRayQueryContext;
#else
using QueryContext = RTCIntersectContext;
#endif

static_assert(lms3dBeamPacket::Size == 16, "packets are cast by rtcIntersect16");

// The share of the scene's diagonal by which boxes are widened. It outweighs the rounding of single
// precision in vertices, origin, direction and traversal (together below 1e-6 of the diagonal as
// long as rays start within a few diagonals), so no box is passed by that truth would enter.
constexpr float BoxMargin = 4e-6f;

// Beams that can hit start within two and a half diagonals of the centre; others are not cast.
constexpr double FarthestStart = 10.0;

/// What the callback for candidates needs to know of the packet that is cast.
struct Query
{
  // First, so that Embree's pointer to it is a pointer to the query.
  QueryContext Context;
  const lms3dViewpoint* Viewpoint;
  double HeadStart;
  lms3dBeamPacket* Packet;
};
static_assert(std::is_standard_layout_v<Query>, "a query starts with its context");

// By how much a search goes beyond the nearest so far: the rounding of the point and of the scene in
// single precision, of which the first grows with the distance.
constexpr float SearchMargin = 4e-6f;
constexpr float SearchFactor = 1.0f + 1e-6f;

/// What the callback for the nearest triangle needs to know.
struct Search
{
  lms3dEmbreeScene::NearestTest* Test;
  const lms3dNormalization* Unit;

  float GetRadius(double distance) const
  {
    return static_cast<float>(this->Unit->GetDistance(distance)) * SearchFactor + SearchMargin;
  }
};

bool TestNearest(RTCPointQueryFunctionArguments* args)
{
  const Search* search = static_cast<const Search*>(args->userPtr);
  const float radius = search->GetRadius(search->Test->Test(args->primID));
  if (!(radius < args->query->radius))
  {
    return false;
  }
  args->query->radius = radius;
  return true;
}
} // namespace

struct lms3dEmbreeScene::Internals
{
  Internals(const lms3dTriangleMesh& mesh, const CandidateTest* test, const lms3dProgress& progress)
    : Mesh(mesh)
    , Test(test)
    , Outliers(test ? lms3dFindOutlyingTriangles(mesh) : std::vector<std::uint32_t>())
    , Others(FindOthers(mesh, this->Outliers))
    , Unit(mesh, this->Outliers)
    , EmbreeDevice(rtcNewDevice(nullptr))
  {
    lms3dThrowOnError(this->EmbreeDevice.get());
    this->EmbreeScene.reset(rtcNewScene(this->EmbreeDevice.get()));
    const Geometry geometry = test ? this->MakeBoxes() : this->MakeTriangles();
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(this->EmbreeScene.get(), geometry.get());
    rtcSetSceneFlags(this->EmbreeScene.get(), RTC_SCENE_FLAG_ROBUST);
    // For boxes the quick builder gives trees that are cast as quickly, in a third of the memory.
    rtcSetSceneBuildQuality(
      this->EmbreeScene.get(), test ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM);
    lms3dThrowOnError(this->EmbreeDevice.get());
    lms3dCommitScene(this->EmbreeDevice.get(), this->EmbreeScene.get(), progress);
  }

  Geometry MakeBoxes()
  {
    Geometry geometry(rtcNewGeometry(this->EmbreeDevice.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(geometry.get(),
      static_cast<unsigned int>(this->Mesh.GetNumberOfTriangles() - this->Outliers.size()));
    rtcSetGeometryUserData(geometry.get(), this);
    rtcSetGeometryBoundsFunction(geometry.get(), &Internals::GetBox, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), &Internals::TestCandidate);
    return geometry;
  }

  // The mesh's own indices serve Embree, too.
  Geometry MakeTriangles()
  {
    Geometry geometry(rtcNewGeometry(this->EmbreeDevice.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    float* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry.get(),
      RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), this->Mesh.Points.size()));
    rtcSetSharedGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
      this->Mesh.Triangles.data(), 0, 3 * sizeof(std::uint32_t), this->Mesh.Triangles.size());
    lms3dThrowOnError(this->EmbreeDevice.get());
    for (const std::array<double, 3>& point : this->Mesh.Points)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        *vertex++ = static_cast<float>(this->Unit.GetCoordinate(point.data(), axis));
      }
    }
    return geometry;
  }

  static void GetBox(const RTCBoundsFunctionArguments* args)
  {
    const Internals* self = static_cast<const Internals*>(args->geometryUserPtr);
    const std::uint32_t triangle = self->GetTriangle(args->primID);
    float low[3], high[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      double x[3];
      for (int corner = 0; corner < 3; ++corner)
      {
        x[corner] = self->Unit.GetCoordinate(self->Mesh.GetCorner(triangle, corner), axis);
      }
      low[axis] = static_cast<float>(std::min({ x[0], x[1], x[2] })) - BoxMargin;
      high[axis] = static_cast<float>(std::max({ x[0], x[1], x[2] })) + BoxMargin;
    }
    *args->bounds_o = { low[0], low[1], low[2], 0.0f, high[0], high[1], high[2], 0.0f };
  }

  static void TestCandidate(const RTCIntersectFunctionNArguments* args)
  {
    const Internals* self = static_cast<const Internals*>(args->geometryUserPtr);
    const Query* query = reinterpret_cast<const Query*>(args->context);
    const std::uint32_t changed =
      self->Test->Test(*query->Viewpoint, self->GetTriangle(args->primID), *query->Packet);
    if (changed != 0)
    {
      self->TellEmbree(*query, changed, args);
    }
  }

  // Of no outliers, no list is needed.
  static std::vector<std::uint32_t> FindOthers(
    const lms3dTriangleMesh& mesh, const std::vector<std::uint32_t>& outliers)
  {
    std::vector<std::uint32_t> others;
    if (!outliers.empty())
    {
      std::vector<std::uint32_t> all(mesh.GetNumberOfTriangles());
      std::iota(all.begin(), all.end(), 0u);
      std::set_difference(
        all.begin(), all.end(), outliers.begin(), outliers.end(), std::back_inserter(others));
    }
    return others;
  }

  std::uint32_t GetTriangle(std::uint32_t primitive) const
  {
    return this->Others.empty() ? primitive : this->Others[primitive];
  }

  // Embree calls with the whole packet, with a run of it that suits its instruction set, or with one
  // beam; a ray's id tells which beam it is.
  void TellEmbree(
    const Query& query, std::uint32_t changed, const RTCIntersectFunctionNArguments* args) const
  {
    RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
    RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, args->N);
    const lms3dRayRun run = { static_cast<int>(RTCRayN_id(rays, args->N, 0)),
      static_cast<int>(args->N), &RTCRayN_tfar(rays, args->N, 0),
      &RTCHitN_geomID(hits, args->N, 0) };
    this->Kernels.Shorten(
      *query.Packet, changed, query.HeadStart, this->Unit.GetDiagonal(), args->geomID, run);
  }

  // How far rays go for beams with a maximum range.
  float GetReach(double range, double headStart) const
  {
    const double reach = (range - headStart) * lms3dReachMargin + range * lms3dRangeRounding;
    return std::max(0.0f, static_cast<float>(this->Unit.GetDistance(reach)));
  }

  // Returns the beams that start within reach of the scene. One that points away from a far scene
  // starts even farther away, where single precision, and Embree's assertions, end.
  std::uint32_t SetStarts(const double origin[3], double headStart, const lms3dBeamPacket& packet,
    RTCRayHit16& rayhit) const
  {
    float* const starts[3] = { rayhit.ray.org_x, rayhit.ray.org_y, rayhit.ray.org_z };
    std::uint32_t near = ~0u;
    for (int axis = 0; axis < 3; ++axis)
    {
      const lms3dStart start = { origin[axis], headStart, this->Unit.GetCenter(axis),
        this->Unit.GetDiagonal(), FarthestStart };
      near &= this->Kernels.SetStarts(start, packet.Direction[axis], starts[axis]);
    }
    return near;
  }

  // What no packet changes.
  static void Initialize(RTCRayHit16& rayhit)
  {
    for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
    {
      rayhit.ray.tnear[beam] = 0.0f;
      rayhit.ray.time[beam] = 0.0f;
      rayhit.ray.mask[beam] = ~0u;
      rayhit.ray.id[beam] = static_cast<unsigned int>(beam);
      rayhit.ray.flags[beam] = 0;
      rayhit.hit.instID[0][beam] = RTC_INVALID_GEOMETRY_ID;
    }
  }

  std::uint32_t TestOutliers(const Query& query) const
  {
    std::uint32_t changed = 0;
    for (std::uint32_t triangle : this->Outliers)
    {
      changed |= this->Test->Test(*query.Viewpoint, triangle, *query.Packet);
    }
    return changed;
  }

  // Beams that are known to have hit something need not reach farther.
  void Intersect(
    std::uint32_t active, std::uint32_t known, float reach, Query& query, RTCRayHit16& rayhit) const
  {
    const float(&direction)[3][lms3dBeamPacket::Size] = query.Packet->NarrowDirection;
    std::copy_n(direction[0], lms3dBeamPacket::Size, rayhit.ray.dir_x);
    std::copy_n(direction[1], lms3dBeamPacket::Size, rayhit.ray.dir_y);
    std::copy_n(direction[2], lms3dBeamPacket::Size, rayhit.ray.dir_z);
    std::fill_n(rayhit.ray.tfar, lms3dBeamPacket::Size, reach);
    std::fill_n(rayhit.hit.geomID, lms3dBeamPacket::Size, RTC_INVALID_GEOMETRY_ID);
    if (known != 0)
    {
      this->Kernels.Shorten(*query.Packet, known, query.HeadStart, this->Unit.GetDiagonal(),
        RTC_INVALID_GEOMETRY_ID, { 0, lms3dBeamPacket::Size, rayhit.ray.tfar, rayhit.hit.geomID });
    }
    alignas(64) int valid[lms3dBeamPacket::Size];
    for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
    {
      const std::uint32_t bit = 1u << beam;
      valid[beam] = (active & bit) == bit ? -1 : 0;
    }
    this->Intersect(valid, query.Context, rayhit);
  }

  void Intersect(const int* valid, QueryContext& context, RTCRayHit16& rayhit) const
  {
#if LMS3D_EMBREE_MAJOR >= 4
    rtcInitRayQueryContext(&context);
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    arguments.context = &context;
    rtcIntersect16(valid, this->EmbreeScene.get(), &rayhit, &arguments);
#else
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid, this->EmbreeScene.get(), &context, &rayhit);
#endif
  }

  static void TakeTriangles(const RTCRayHit16& rayhit, lms3dBeamPacket& packet)
  {
    for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
    {
      packet.Triangle[beam] = rayhit.hit.geomID[beam] == RTC_INVALID_GEOMETRY_ID
        ? lms3dBeamPacket::NoTriangle
        : static_cast<std::int32_t>(rayhit.hit.primID[beam]);
    }
  }

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dTriangleMesh& Mesh;
  const CandidateTest* Test;
  /// Tested for each packet; Embree's tree is of the other triangles.
  const std::vector<std::uint32_t> Outliers;
  const std::vector<std::uint32_t> Others;
  const lms3dNormalization Unit;
  lms3dEmbreeHandle<RTCDevice> EmbreeDevice;
  lms3dEmbreeHandle<RTCScene> EmbreeScene;
};

lms3dEmbreeScene::lms3dEmbreeScene(const lms3dTriangleMesh& mesh, const lms3dProgress& progress)
  : Internal(new Internals(mesh, nullptr, progress))
{
}

lms3dEmbreeScene::lms3dEmbreeScene(
  const lms3dTriangleMesh& mesh, const CandidateTest& test, const lms3dProgress& progress)
  : Internal(new Internals(mesh, &test, progress))
{
}

lms3dEmbreeScene::~lms3dEmbreeScene() = default;

void lms3dEmbreeScene::Cast(
  const lms3dViewpoint& viewpoint, lms3dBeamPacket* packets, int count) const
{
  const Internals& self = *this->Internal;
  const lms3dCone cone = self.Unit.GetCone(viewpoint.Origin);
  const double headStart = self.Unit.GetHeadStart(viewpoint.Origin);
  const float reach = self.GetReach(viewpoint.MaximumRange, headStart);
  Query query;
  query.Viewpoint = &viewpoint;
  query.HeadStart = headStart;

  RTCRayHit16 rayhit;
  Internals::Initialize(rayhit);
  std::uint32_t near = self.SetStarts(viewpoint.Origin, headStart, packets[0], rayhit);
  for (int i = 0; i < count; ++i)
  {
    lms3dBeamPacket& packet = packets[i];
    std::fill_n(packet.Range, lms3dBeamPacket::Size, lms3dBeamPacket::NoRange);
    std::fill_n(packet.Triangle, lms3dBeamPacket::Size, lms3dBeamPacket::NoTriangle);
    query.Packet = &packet;
    const std::uint32_t known = self.TestOutliers(query);
    std::uint32_t active = packet.Active & self.Kernels.FindWithin(cone, packet);
    if (active == 0)
    {
      continue;
    }
    if (headStart > 0.0)
    {
      near = self.SetStarts(viewpoint.Origin, headStart, packet, rayhit);
    }
    active &= near;
    self.Intersect(active, known, reach, query, rayhit);
    if (!self.Test)
    {
      Internals::TakeTriangles(rayhit, packet);
    }
  }
}

void lms3dEmbreeScene::FindNearest(const double point[3], double reach, NearestTest& test) const
{
  const Internals& self = *this->Internal;
  Search search = { &test, &self.Unit };
  RTCPointQuery query;
  query.x = static_cast<float>(self.Unit.GetCoordinate(point, 0));
  query.y = static_cast<float>(self.Unit.GetCoordinate(point, 1));
  query.z = static_cast<float>(self.Unit.GetCoordinate(point, 2));
  query.time = 0.0f;
  query.radius = search.GetRadius(reach);
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(self.EmbreeScene.get(), &query, &context, &TestNearest, &search);
}
