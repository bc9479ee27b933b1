// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StabilityRivals.h"

#include "Casting/lms3dEmbreeConfiguration.h"
#include "CoherentCaster.h"
#include "EmbreeHandles.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

namespace
{
constexpr float Infinity = std::numeric_limits<float>::infinity();

enum class Precision
{
  PLAIN,
  ROBUST
};

class RawScene
{
public:
  RawScene(const lms3dTriangleMesh& mesh, Precision precision)
  {
    RTCGeometry geometry = rtcNewGeometry(this->Device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
      RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.Points.size()));
    for (const Vector& point : mesh.Points)
    {
      vertex = std::transform(
        point.begin(), point.end(), vertex, [](double x) { return static_cast<float>(x); });
    }
    auto* corner = static_cast<unsigned int*>(rtcSetNewGeometryBuffer(geometry,
      RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned int), mesh.Triangles.size()));
    for (const std::array<std::uint32_t, 3>& triangle : mesh.Triangles)
    {
      corner = std::copy(triangle.begin(), triangle.end(), corner);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(this->Get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcSetSceneFlags(
      this->Get(), precision == Precision::ROBUST ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcCommitScene(this->Get());
  }

  RTCScene Get() const { return this->Scene.get(); }

private:
  EmbreeDevice Device{ rtcNewDevice(lms3dGetEmbreeConfiguration()) };
  EmbreeScene Scene{ rtcNewScene(this->Device.get()) };
};

double GetRange(unsigned int geometry, float range)
{
  return geometry == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<double>::infinity()
                                             : static_cast<double>(range);
}

double CastRay(RTCScene scene, const Vector& sensor, const Vector& direction)
{
  RTCRayHit hit = {};
  hit.ray.org_x = static_cast<float>(sensor[0]);
  hit.ray.org_y = static_cast<float>(sensor[1]);
  hit.ray.org_z = static_cast<float>(sensor[2]);
  hit.ray.dir_x = static_cast<float>(direction[0]);
  hit.ray.dir_y = static_cast<float>(direction[1]);
  hit.ray.dir_z = static_cast<float>(direction[2]);
  hit.ray.tfar = Infinity;
  hit.ray.mask = ~0u;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if LMS3D_EMBREE_MAJOR >= 4
  rtcIntersect1(scene, &hit);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &hit);
#endif
  return GetRange(hit.hit.geomID, hit.ray.tfar);
}

std::vector<double> CastRays(RTCScene scene, const std::vector<StabilityShot>& shots)
{
  std::vector<double> ranges;
  ranges.reserve(shots.size() * lms3dBeamPacket::Size);
  for (const StabilityShot& shot : shots)
  {
    for (const Vector& direction : shot.Directions)
    {
      ranges.push_back(CastRay(scene, shot.Sensor, direction));
    }
  }
  return ranges;
}

RTCRayHit16 MakePacket(const StabilityShot& shot)
{
  RTCRayHit16 packet = {};
  for (unsigned int i = 0; i < lms3dBeamPacket::Size; ++i)
  {
    packet.ray.org_x[i] = static_cast<float>(shot.Sensor[0]);
    packet.ray.org_y[i] = static_cast<float>(shot.Sensor[1]);
    packet.ray.org_z[i] = static_cast<float>(shot.Sensor[2]);
    packet.ray.dir_x[i] = static_cast<float>(shot.Directions[i][0]);
    packet.ray.dir_y[i] = static_cast<float>(shot.Directions[i][1]);
    packet.ray.dir_z[i] = static_cast<float>(shot.Directions[i][2]);
    packet.ray.tfar[i] = Infinity;
    packet.ray.mask[i] = ~0u;
    packet.ray.id[i] = i;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  return packet;
}

std::vector<double> CastPackets(RTCScene scene, const std::vector<StabilityShot>& shots)
{
  CoherentCaster caster(scene);
  alignas(64) int valid[lms3dBeamPacket::Size];
  std::fill(std::begin(valid), std::end(valid), -1);
  std::vector<double> ranges;
  ranges.reserve(shots.size() * lms3dBeamPacket::Size);
  for (const StabilityShot& shot : shots)
  {
    RTCRayHit16 packet = MakePacket(shot);
    caster.Intersect(valid, packet);
    for (int i = 0; i < lms3dBeamPacket::Size; ++i)
    {
      ranges.push_back(GetRange(packet.hit.geomID[i], packet.ray.tfar[i]));
    }
  }
  return ranges;
}

using Cast = std::vector<double> (*)(RTCScene scene, const std::vector<StabilityShot>& shots);

StabilityMethod MakeMethod(const std::string& name, Precision precision, Cast cast)
{
  return { name,
    [precision, cast](const lms3dTriangleMesh& mesh) -> StabilityCaster
    {
      const auto scene = std::make_shared<const RawScene>(mesh, precision);
      return [scene, cast](const std::vector<StabilityShot>& shots)
      { return cast(scene->Get(), shots); };
    } };
}
} // namespace

std::vector<StabilityMethod> GetEmbreeMethods()
{
  return { MakeMethod("Embree rays", Precision::PLAIN, CastRays),
    MakeMethod("Embree robust rays", Precision::ROBUST, CastRays),
    MakeMethod("Embree robust packets", Precision::ROBUST, CastPackets) };
}
