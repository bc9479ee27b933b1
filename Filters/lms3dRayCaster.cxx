// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dRayCaster.h"

#include "lms3dNormalization.h"

#if LMS3D_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace
{
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

// Embree loses packets in which a direction component is a tiny negative number: its reciprocal is
// taken as positive while the packet was sorted by the sign.
constexpr double SmallestComponent = 1e-15;

// ParaView deletes filters that a script left behind after Embree's static objects are gone (Python's
// sys.exit does), and Embree then aborts. What is released so late is left to the system.
bool ProcessEnds = false;
const struct EndOfProcess
{
  ~EndOfProcess() { ProcessEnds = true; }
} NoticeEndOfProcess;

struct Release
{
  void operator()(RTCDevice device) const
  {
    if (!ProcessEnds)
    {
      rtcReleaseDevice(device);
    }
  }
  void operator()(RTCScene scene) const
  {
    if (!ProcessEnds)
    {
      rtcReleaseScene(scene);
    }
  }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release>;
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release>;

void ThrowOnError(RTCDevice device)
{
  const RTCError error = rtcGetDeviceError(device);
  if (error != RTC_ERROR_NONE)
  {
    throw std::runtime_error("Embree failed with its error " + std::to_string(error) +
      (error == RTC_ERROR_OUT_OF_MEMORY ? " (out of memory)" : ""));
  }
}

float FlushTiny(double component)
{
  return std::abs(component) < SmallestComponent ? 0.0f : static_cast<float>(component);
}

/// What both casters share: the scene in Embree, and the casting of one packet.
class EmbreeCaster : public lms3dRayCaster
{
protected:
  explicit EmbreeCaster(lms3dTriangleMesh mesh)
    : lms3dRayCaster(std::move(mesh))
    , Unit(this->GetMesh())
    , EmbreeDevice(rtcNewDevice(nullptr))
  {
    ThrowOnError(this->EmbreeDevice.get());
    this->EmbreeScene.reset(rtcNewScene(this->EmbreeDevice.get()));
  }

  void Build(RTCGeometry geometry)
  {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->EmbreeScene.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(this->EmbreeScene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(this->EmbreeScene.get());
    ThrowOnError(this->EmbreeDevice.get());
  }

  /// Returns false where the scene is out of reach, so that nothing was cast.
  bool Trace(const double origin[3], double maximumRange, const lms3dBeamPacket& packet,
    QueryContext& context, RTCRayHit16& rayhit) const
  {
    const double headStart = this->Unit.GetHeadStart(origin);
    if (headStart >= maximumRange)
    {
      return false;
    }
    const double reach = this->Unit.GetDistance(maximumRange - headStart);
    alignas(64) int valid[lms3dBeamPacket::Size];
    for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
    {
      valid[beam] = packet.Active & (1u << beam) ? -1 : 0;
      this->SetRay(rayhit, beam, origin, headStart, packet);
      // A hit just at the maximum must not be lost to rounding; the range itself decides later.
      rayhit.ray.tfar[beam] = static_cast<float>(reach) * 1.0001f;
    }
    this->Intersect(valid, context, rayhit);
    return true;
  }

  RTCDevice GetDevice() const { return this->EmbreeDevice.get(); }

  const lms3dNormalization Unit;

private:
  void SetRay(RTCRayHit16& rayhit, int beam, const double origin[3], double headStart,
    const lms3dBeamPacket& packet) const
  {
    double start[3];
    for (int i = 0; i < 3; ++i)
    {
      start[i] = origin[i] + headStart * packet.Direction[i][beam];
    }
    rayhit.ray.org_x[beam] = static_cast<float>(this->Unit.GetCoordinate(start, 0));
    rayhit.ray.org_y[beam] = static_cast<float>(this->Unit.GetCoordinate(start, 1));
    rayhit.ray.org_z[beam] = static_cast<float>(this->Unit.GetCoordinate(start, 2));
    rayhit.ray.dir_x[beam] = FlushTiny(packet.Direction[0][beam]);
    rayhit.ray.dir_y[beam] = FlushTiny(packet.Direction[1][beam]);
    rayhit.ray.dir_z[beam] = FlushTiny(packet.Direction[2][beam]);
    rayhit.ray.tnear[beam] = 0.0f;
    rayhit.ray.time[beam] = 0.0f;
    rayhit.ray.mask[beam] = ~0u;
    rayhit.ray.id[beam] = beam;
    rayhit.ray.flags[beam] = 0;
    rayhit.hit.geomID[beam] = RTC_INVALID_GEOMETRY_ID;
    rayhit.hit.instID[0][beam] = RTC_INVALID_GEOMETRY_ID;
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

  Device EmbreeDevice;
  Scene EmbreeScene;
};

/// Embree only finds candidates; the exact test decides in the callback.
class ExactCaster : public EmbreeCaster
{
public:
  explicit ExactCaster(lms3dTriangleMesh mesh)
    : EmbreeCaster(std::move(mesh))
  {
    RTCGeometry geometry = rtcNewGeometry(this->GetDevice(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(
      geometry, static_cast<unsigned int>(this->GetMesh().GetNumberOfTriangles()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, &ExactCaster::GetBox, nullptr);
    rtcSetGeometryIntersectFunction(geometry, &ExactCaster::IntersectTriangle);
    this->Build(geometry);
  }

  void Cast(const double origin[3], double maximumRange, lms3dBeamPacket& packet) const override
  {
    packet.Range.fill(lms3dBeamPacket::NoRange);
    packet.Triangle.fill(lms3dBeamPacket::NoTriangle);
    Query query;
    query.Origin = origin;
    query.MaximumRange = maximumRange;
    query.HeadStart = this->Unit.GetHeadStart(origin);
    query.Packet = &packet;
    RTCRayHit16 rayhit;
    this->Trace(origin, maximumRange, packet, query.Context, rayhit);
  }

private:
  struct Query
  {
    // First, so that Embree's pointer to it is a pointer to the query.
    QueryContext Context;
    const double* Origin;
    double MaximumRange;
    double HeadStart;
    lms3dBeamPacket* Packet;
  };
  static_assert(std::is_standard_layout_v<Query>, "a query starts with its context");

  lms3dCorners GetCorners(unsigned int triangle) const
  {
    const lms3dTriangleMesh& mesh = this->GetMesh();
    return { mesh.GetCorner(triangle, 0), mesh.GetCorner(triangle, 1),
      mesh.GetCorner(triangle, 2) };
  }

  static void GetBox(const RTCBoundsFunctionArguments* args)
  {
    const ExactCaster* self = static_cast<const ExactCaster*>(args->geometryUserPtr);
    float low[3], high[3];
    for (int i = 0; i < 3; ++i)
    {
      double minimum = self->Unit.GetCoordinate(self->GetMesh().GetCorner(args->primID, 0), i);
      double maximum = minimum;
      for (int corner = 1; corner < 3; ++corner)
      {
        const double x =
          self->Unit.GetCoordinate(self->GetMesh().GetCorner(args->primID, corner), i);
        minimum = std::min(minimum, x);
        maximum = std::max(maximum, x);
      }
      low[i] = static_cast<float>(minimum) - BoxMargin;
      high[i] = static_cast<float>(maximum) + BoxMargin;
    }
    *args->bounds_o = { low[0], low[1], low[2], 0.0f, high[0], high[1], high[2], 0.0f };
  }

  // Embree may call with fewer rays than the packet has, so a ray's id tells which beam it is.
  static void IntersectTriangle(const RTCIntersectFunctionNArguments* args)
  {
    const ExactCaster* self = static_cast<const ExactCaster*>(args->geometryUserPtr);
    const Query* query = reinterpret_cast<const Query*>(args->context);
    const std::uint32_t changed = lms3dIntersectTriangle(self->GetCorners(args->primID),
      static_cast<std::int32_t>(args->primID), query->Origin, query->MaximumRange, *query->Packet);
    if (changed == 0)
    {
      return;
    }
    RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
    RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, args->N);
    for (unsigned int i = 0; i < args->N; ++i)
    {
      const unsigned int beam = RTCRayN_id(rays, args->N, i);
      if (args->valid[i] == 0 || !(changed & (1u << beam)))
      {
        continue;
      }
      const double range = query->Packet->Range[beam] - query->HeadStart;
      RTCRayN_tfar(rays, args->N, i) =
        std::max(0.0f, static_cast<float>(self->Unit.GetDistance(range)) * (1.0f + 1e-6f));
      RTCHitN_geomID(hits, args->N, i) = args->geomID;
      RTCHitN_primID(hits, args->N, i) = args->primID;
    }
  }
};

/// Embree's single-precision triangles decide; the range is that of the triangle's plane in double.
class FastCaster : public EmbreeCaster
{
public:
  explicit FastCaster(lms3dTriangleMesh mesh)
    : EmbreeCaster(std::move(mesh))
  {
    RTCGeometry geometry = rtcNewGeometry(this->GetDevice(), RTC_GEOMETRY_TYPE_TRIANGLE);
    this->FillVertices(geometry);
    this->FillTriangles(geometry);
    this->Build(geometry);
  }

  void Cast(const double origin[3], double maximumRange, lms3dBeamPacket& packet) const override
  {
    packet.Range.fill(lms3dBeamPacket::NoRange);
    packet.Triangle.fill(lms3dBeamPacket::NoTriangle);
    QueryContext context;
    RTCRayHit16 rayhit;
    if (!this->Trace(origin, maximumRange, packet, context, rayhit))
    {
      return;
    }
    for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
    {
      if ((packet.Active & (1u << beam)) && rayhit.hit.geomID[beam] != RTC_INVALID_GEOMETRY_ID)
      {
        this->Refine(origin, maximumRange, rayhit.hit.primID[beam], beam, packet);
      }
    }
  }

private:
  void FillVertices(RTCGeometry geometry) const
  {
    const lms3dTriangleMesh& mesh = this->GetMesh();
    float* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
      RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.Points.size()));
    ThrowOnError(this->GetDevice());
    for (const std::array<double, 3>& point : mesh.Points)
    {
      for (int i = 0; i < 3; ++i)
      {
        *vertex++ = static_cast<float>(this->Unit.GetCoordinate(point.data(), i));
      }
    }
  }

  void FillTriangles(RTCGeometry geometry) const
  {
    const lms3dTriangleMesh& mesh = this->GetMesh();
    unsigned int* corner =
      static_cast<unsigned int*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
        RTC_FORMAT_UINT3, 3 * sizeof(unsigned int), mesh.GetNumberOfTriangles()));
    ThrowOnError(this->GetDevice());
    for (const std::array<std::uint32_t, 3>& triangle : mesh.Triangles)
    {
      corner = std::copy(triangle.begin(), triangle.end(), corner);
    }
  }

  void Refine(const double origin[3], double maximumRange, unsigned int triangle, int beam,
    lms3dBeamPacket& packet) const
  {
    const lms3dTriangleMesh& mesh = this->GetMesh();
    const double direction[3] = { packet.Direction[0][beam], packet.Direction[1][beam],
      packet.Direction[2][beam] };
    const double range = lms3dPlaneRange(
      { mesh.GetCorner(triangle, 0), mesh.GetCorner(triangle, 1), mesh.GetCorner(triangle, 2) },
      origin, direction);
    if (range > 0.0 && range <= maximumRange)
    {
      packet.Range[beam] = range;
      packet.Triangle[beam] = static_cast<std::int32_t>(triangle);
    }
  }
};
} // namespace

std::unique_ptr<lms3dRayCaster> lms3dRayCaster::New(Method method, lms3dTriangleMesh mesh)
{
  switch (method)
  {
    case Method::Fast:
      return std::make_unique<FastCaster>(std::move(mesh));
    default:
      return std::make_unique<ExactCaster>(std::move(mesh));
  }
}
