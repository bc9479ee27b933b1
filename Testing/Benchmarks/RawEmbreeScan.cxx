// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RawEmbreeScan.h"

#if LMS3D_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace
{
constexpr int Beams = 361;
constexpr int Turns = 360;
constexpr int PacketSize = 16;
constexpr int TileSide = 4;

// Coherent packets are lost where a component of a direction is a tiny negative number.
float Component(double x)
{
  return std::abs(x) < 1e-15 ? 0.0f : static_cast<float>(x);
}

void SetRay(RTCRayHit16& packet, int i, int turn, int beam)
{
  const double alpha = vtkMath::RadiansFromDegrees(-90.0 + 0.5 * std::min(beam, Beams - 1));
  const double beta = vtkMath::RadiansFromDegrees(double(turn));
  packet.ray.org_x[i] = packet.ray.org_y[i] = packet.ray.org_z[i] = 0.0f;
  packet.ray.dir_x[i] = Component(std::cos(alpha) * std::cos(beta));
  packet.ray.dir_y[i] = Component(-std::cos(alpha) * std::sin(beta));
  packet.ray.dir_z[i] = Component(std::sin(alpha));
  packet.ray.tnear[i] = 0.0f;
  packet.ray.tfar[i] = 80.0f;
  packet.ray.time[i] = 0.0f;
  packet.ray.mask[i] = ~0u;
  packet.ray.id[i] = i;
  packet.ray.flags[i] = 0;
  packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
}

struct Tile
{
  RTCRayHit16 Packet;
  alignas(64) int Valid[PacketSize];
};

std::vector<Tile> MakeTiles()
{
  std::vector<Tile> tiles;
  for (int turn = 0; turn < Turns; turn += TileSide)
  {
    for (int beam = 0; beam < Beams; beam += TileSide)
    {
      Tile tile;
      for (int i = 0; i < PacketSize; ++i)
      {
        SetRay(tile.Packet, i, turn + i / TileSide, beam + i % TileSide);
        tile.Valid[i] = beam + i % TileSide < Beams ? -1 : 0;
      }
      tiles.push_back(tile);
    }
  }
  return tiles;
}

int CastTile(RTCScene scene, const Tile& tile)
{
  RTCRayHit16 packet = tile.Packet;
#if LMS3D_EMBREE_MAJOR >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect16(tile.Valid, scene, &packet, &arguments);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(tile.Valid, scene, &context, &packet);
#endif
  int hits = 0;
  for (int i = 0; i < PacketSize; ++i)
  {
    hits += tile.Valid[i] && packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
  }
  return hits;
}
} // namespace

struct RawEmbreeScan::Internals
{
  RTCDevice Device = rtcNewDevice(nullptr);
  RTCScene Scene = rtcNewScene(this->Device);
  std::vector<Tile> Tiles = MakeTiles();

  Internals() = default;
  Internals(const Internals&) = delete;
  Internals& operator=(const Internals&) = delete;
  ~Internals()
  {
    rtcReleaseScene(this->Scene);
    rtcReleaseDevice(this->Device);
  }
};

RawEmbreeScan::RawEmbreeScan(vtkPolyData* surface, const double sensor[3])
  : Internal(new Internals)
{
  RTCGeometry geometry = rtcNewGeometry(this->Internal->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
  float* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
    RTC_FORMAT_FLOAT3, 3 * sizeof(float), surface->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* point = surface->GetPoint(i);
    vertex = std::transform(point, point + 3, sensor, vertex,
      [](double x, double origin) { return static_cast<float>(x - origin); });
  }
  unsigned int* corner =
    static_cast<unsigned int*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
      RTC_FORMAT_UINT3, 3 * sizeof(unsigned int), surface->GetNumberOfPolys()));
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    surface->GetPolys()->GetCellAtId(i, corners);
    corner = std::copy(corners->begin(), corners->end(), corner);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(this->Internal->Scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcSetSceneFlags(this->Internal->Scene, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(this->Internal->Scene);
}

RawEmbreeScan::~RawEmbreeScan() = default;

int RawEmbreeScan::Cast(int threads)
{
  tbb::task_arena arena(threads);
  const std::vector<Tile>& tiles = this->Internal->Tiles;
  return arena.execute(
    [&]
    {
      return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, tiles.size(), 128), 0,
        [&](const tbb::blocked_range<std::size_t>& range, int hits)
        {
          for (std::size_t i = range.begin(); i < range.end(); ++i)
          {
            hits += CastTile(this->Internal->Scene, tiles[i]);
          }
          return hits;
        },
        std::plus<int>());
    });
}
