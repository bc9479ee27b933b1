// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RawEmbreeScan.h"

#include "Casting/lms3dEmbreeConfiguration.h"
#include "CoherentCaster.h"
#include "EmbreeHandles.h"
#include "Geometry/lms3dAngle.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace
{
constexpr int Beams = 361;
constexpr int Turns = 360;
constexpr int PacketSize = 16;
constexpr int TileSide = 4;
constexpr int Rows = Turns / TileSide;
constexpr int TilesPerRow = (Beams + TileSide - 1) / TileSide;

/// A number for each ray of a packet.
struct alignas(64) Lanes
{
  float Value[PacketSize];
};

// Coherent packets are lost where a component of a direction is a tiny negative number.
float Flush(double x)
{
  return std::abs(x) < 1e-15 ? 0.0f : static_cast<float>(x);
}

float GetSine(double degrees)
{
  return Flush(std::sin(degrees * lms3dPi / 180.0));
}

/// Sines and cosines of the elevations of each tile in a row, and of the platform angles of each
/// row. For the upright sensor x is cos(alpha) cos(beta), y is -cos(alpha) sin(beta), z is
/// sin(alpha).
struct Tables
{
  Tables()
  {
    for (int i = 0; i < PacketSize; ++i)
    {
      for (int tile = 0; tile < TilesPerRow; ++tile)
      {
        const double alpha = -90.0 + 0.5 * std::min(tile * TileSide + i % TileSide, Beams - 1);
        this->AlphaSine[tile].Value[i] = GetSine(alpha);
        this->AlphaCosine[tile].Value[i] = GetSine(90.0 - std::abs(alpha));
      }
      for (int row = 0; row < Rows; ++row)
      {
        const int turn = row * TileSide + i / TileSide;
        const double beta = turn;
        this->FanX[row].Value[i] = GetSine(90.0 - beta);
        this->FanY[row].Value[i] = -GetSine(beta) + 0.0f;
      }
    }
  }

  std::array<Lanes, TilesPerRow> AlphaSine;
  std::array<Lanes, TilesPerRow> AlphaCosine;
  std::array<Lanes, Rows> FanX;
  std::array<Lanes, Rows> FanY;
};

RTCRayHit16 MakePacket(const float origin[3])
{
  RTCRayHit16 packet;
  for (unsigned int i = 0; i < PacketSize; ++i)
  {
    packet.ray.org_x[i] = origin[0];
    packet.ray.org_y[i] = origin[1];
    packet.ray.org_z[i] = origin[2];
    packet.ray.tnear[i] = 0.0f;
    packet.ray.time[i] = 0.0f;
    packet.ray.mask[i] = ~0u;
    packet.ray.id[i] = i;
    packet.ray.flags[i] = 0;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  return packet;
}

void FillVertices(vtkPolyData* surface, const double centre[3], float* vertex)
{
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double point[3];
    surface->GetPoint(i, point);
    vertex = std::transform(point, point + 3, centre, vertex,
      [](double x, double origin) { return static_cast<float>(x - origin); });
  }
}

void FillCorners(vtkPolyData* surface, unsigned int* corner)
{
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(surface->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* points;
    it->GetCurrentCell(count, points);
    corner = std::transform(
      points, points + 3, corner, [](vtkIdType point) { return static_cast<unsigned int>(point); });
  }
}
} // namespace

struct RawEmbreeScan::Internals
{
  // Kept, since making one takes some microseconds.
  tbb::task_arena& GetArena(int threads)
  {
    return this->Arenas.try_emplace(threads, threads).first->second;
  }

  void CastRow(int row, int* hits) const
  {
    alignas(64) int valid[PacketSize];
    std::fill_n(valid, PacketSize, -1);
    RTCRayHit16 packet = MakePacket(this->Origin);
    CoherentCaster caster(this->Scene.get());
    const float* fanX = this->Beam.FanX[row].Value;
    const float* fanY = this->Beam.FanY[row].Value;
    for (int tile = 0; tile < TilesPerRow; ++tile)
    {
      const float* cosine = this->Beam.AlphaCosine[tile].Value;
      const float* sine = this->Beam.AlphaSine[tile].Value;
      for (int i = 0; i < PacketSize; ++i)
      {
        packet.ray.dir_x[i] = cosine[i] * fanX[i];
        packet.ray.dir_y[i] = cosine[i] * fanY[i];
        packet.ray.dir_z[i] = sine[i];
        packet.ray.tfar[i] = this->MaximumRange;
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      }
      if (tile == TilesPerRow - 1)
      {
        for (int i = 0; i < PacketSize; ++i)
        {
          valid[i] = tile * TileSide + i % TileSide < Beams ? -1 : 0;
        }
      }
      caster.Intersect(valid, packet);
      for (int i = 0; hits && i < PacketSize; ++i)
      {
        *hits += valid[i] && packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
      }
    }
  }

  Tables Beam;
  EmbreeDevice Device{ rtcNewDevice(lms3dGetEmbreeConfiguration()) };
  EmbreeScene Scene{ rtcNewScene(this->Device.get()) };
  std::map<int, tbb::task_arena> Arenas;
  float Origin[3];
  float MaximumRange;
};

RawEmbreeScan::RawEmbreeScan(
  vtkPolyData* surface, const double sensor[3], double maximumRange, int threads)
  : Internal(new Internals)
{
  double centre[3];
  surface->GetCenter(centre);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Internal->Origin[axis] = static_cast<float>(sensor[axis] - centre[axis]);
  }
  this->Internal->MaximumRange = static_cast<float>(maximumRange);

  RTCGeometry geometry = rtcNewGeometry(this->Internal->Device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  FillVertices(surface, centre,
    static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
      RTC_FORMAT_FLOAT3, 3 * sizeof(float), surface->GetNumberOfPoints())));
  FillCorners(surface,
    static_cast<unsigned int*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
      RTC_FORMAT_UINT3, 3 * sizeof(unsigned int), surface->GetNumberOfPolys())));
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(this->Internal->Scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcSetSceneFlags(this->Internal->Scene.get(), RTC_SCENE_FLAG_ROBUST);
  tbb::task_arena arena(threads);
  arena.execute([&] { rtcCommitScene(this->Internal->Scene.get()); });
}

RawEmbreeScan::~RawEmbreeScan() = default;

void RawEmbreeScan::Cast(int threads) const
{
  this->Internal->GetArena(threads).execute(
    [&]
    {
      tbb::parallel_for(tbb::blocked_range<int>(0, Rows),
        [&](const tbb::blocked_range<int>& range)
        {
          for (int row = range.begin(); row < range.end(); ++row)
          {
            this->Internal->CastRow(row, nullptr);
          }
        });
    });
}

int RawEmbreeScan::CountHits() const
{
  int hits = 0;
  for (int row = 0; row < Rows; ++row)
  {
    this->Internal->CastRow(row, &hits);
  }
  return hits;
}
