// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dRayScanner.h"

#include "Casting/lms3dPacketBeams.h"
#include "Kernels/lms3dPacketKernels.h"
#include "Pipeline/lms3dProgressReporter.h"
#include "Scan/lms3dPacketFrames.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>

namespace
{
constexpr int Side = lms3dPacketGrid::Side;

// Packets side by side that are cast together. Few enough for the cache.
constexpr int MaximumPackets = 16;

/// Rays that all start at the sensor's position.
class SharedOrigin
{
public:
  using Packet = lms3dBeamPacket;

  explicit SharedOrigin(const lms3dRayScanRequest& request)
    : Request(request)
    , Origin(MakeOrigin(request))
    , GridCaster(request.Caster.NewGridCaster(this->Origin,
        { request.Turns * static_cast<int>(request.Fans.size()),
          request.Beams.GetGeometry().GetNumberOfBeams() }))
  {
  }

  static void SetOrigins(const lms3dRayFan&, int, const lms3dPacketFrames&, Packet&) {}

  void FindNearest(int firstTurn, int firstBeam, Packet* packets, int count) const
  {
    for (int i = 0; i < count; ++i)
    {
      lms3dGetPacketKernels().Free.NarrowDirections(packets[i]);
    }
    this->GridCaster->FindNearest({ firstTurn, firstBeam, 1, count }, packets);
    if (this->Request.NearestHits.Ranges)
    {
      this->Request.Caster.ComputeRanges(this->Origin, packets, count);
    }
  }

  void RefineRanges(Packet* packets, int count) const
  {
    this->Request.Caster.RefineRanges(this->Origin, packets, count);
  }

private:
  static lms3dRayOrigin MakeOrigin(const lms3dRayScanRequest& request)
  {
    const lms3dVector& position = request.Beams.GetPosition();
    return { { position[0], position[1], position[2] }, request.Limits.Maximum };
  }

  const lms3dRayScanRequest& Request;
  const lms3dRayOrigin Origin;
  const std::unique_ptr<const lms3dGridCaster> GridCaster;
};

/// Rays that start anywhere.
class OwnOrigins
{
public:
  using Packet = lms3dFreePacket;

  explicit OwnOrigins(const lms3dRayScanRequest& request)
    : Request(request)
  {
  }

  static void SetOrigins(
    const lms3dRayFan& fan, int firstBeam, const lms3dPacketFrames& frames, Packet& packet)
  {
    frames.SetOrigins(fan.Origins, firstBeam, packet);
    lms3dSetTriangle(lms3dBeamPacket::NoTriangle, packet);
  }

  void FindNearest(int, int, Packet* packets, int count) const
  {
    this->Request.Caster.FindNearestFree(this->Request.Limits.Maximum, packets, count);
  }

  void RefineRanges(Packet* packets, int count) const
  {
    if (this->Request.HasAllDigits)
    {
      this->Request.Caster.RefineRangesFree(packets, count);
    }
  }

private:
  const lms3dRayScanRequest& Request;
};

/// Divides the grid into rows of packets, each cast with one ray after the other.
template <typename Origins>
class RayScan
{
public:
  explicit RayScan(const lms3dRayScanRequest& request)
    : Request(request)
    , Start(request)
    , Grid{ request.Turns, request.Beams.GetGeometry().GetNumberOfBeams() }
    , EndTurn(request.FirstTurn + request.Turns)
    , Columns((lms3dBeamGrid::CountPackets(this->Grid.Beams) - 1) / MaximumPackets + 1)
  {
  }

  int CountRows() const { return lms3dBeamGrid::CountPackets(this->Grid.Turns) * this->Columns; }

  void Cast(int row) const
  {
    const int firstTurn = row / this->Columns * Side;
    const int firstBeam = row % this->Columns * MaximumPackets * Side;
    const int count =
      std::min(MaximumPackets, lms3dBeamGrid::CountPackets(this->Grid.Beams - firstBeam));
    // The turns of a resting sensor have one frame for all beams.
    lms3dPacketFrames frames[MaximumPackets];
    const int different = this->Request.Beams.IsMoving() ? count : 1;
    for (int i = 0; i < different; ++i)
    {
      frames[i].Fill(this->Request.Beams, this->Request.FirstTurn + firstTurn, this->EndTurn,
        firstBeam + i * Side);
    }
    for (std::size_t ray = 0; ray < this->Request.Fans.size(); ++ray)
    {
      this->CastRays(ray, firstTurn, firstBeam, frames, count);
    }
  }

private:
  using Packet = typename Origins::Packet;

  void CastRays(
    std::size_t ray, int firstTurn, int firstBeam, const lms3dPacketFrames* frames, int count) const
  {
    const lms3dRayFan& fan = this->Request.Fans[ray];
    Packet packets[MaximumPackets];
    for (int i = 0; i < count; ++i)
    {
      const int beam = firstBeam + i * Side;
      const lms3dPacketFrames& ofPacket = frames[this->Request.Beams.IsMoving() ? i : 0];
      ofPacket.SetDirections(fan.Directions, beam, packets[i]);
      this->Start.SetOrigins(fan, beam, ofPacket, packets[i]);
      packets[i].Active = this->Grid.GetActive(firstTurn, beam);
    }
    this->Start.FindNearest(firstTurn, firstBeam, packets, count);
    this->Store(ray, firstTurn, firstBeam, packets, count, this->Request.NearestHits);
    this->Start.RefineRanges(packets, count);
    for (int i = 0; i < count; ++i)
    {
      this->Kernels.ApplyMinimumRange(this->Request.Limits.Minimum, packets[i]);
    }
    this->Store(ray, firstTurn, firstBeam, packets, count, this->Request.Returns);
  }

  void Store(std::size_t ray, int firstTurn, int firstBeam, const Packet* packets, int count,
    const lms3dBeamHits& hits) const
  {
    if (!hits.Ranges)
    {
      return;
    }
    const std::size_t first = ray * this->Grid.Turns * this->Grid.Beams;
    for (int i = 0; i < count; ++i)
    {
      this->Grid.Store(firstTurn, firstBeam + i * Side, packets[i],
        { hits.Ranges + first, hits.Triangles + first });
    }
  }

  const lms3dPacketKernels& Kernels = lms3dGetPacketKernels();
  const lms3dRayScanRequest& Request;
  const Origins Start;
  const lms3dPacketGrid Grid;
  const int EndTurn;
  const int Columns;
};

template <typename Origins>
bool Run(const lms3dRayScanRequest& request, const lms3dProgress& progress)
{
  const RayScan<Origins> scan(request);
  const int rows = scan.CountRows();
  std::atomic<int> done{ 0 };
  lms3dProgressReporter reporter(progress);
  tbb::parallel_for(tbb::blocked_range<int>(0, rows),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int row = range.begin(); row < range.end() && !reporter.IsStopped(); ++row)
      {
        scan.Cast(row);
        reporter.Report(static_cast<double>(++done) / rows);
      }
    });
  return !reporter.IsStopped();
}

bool HaveSharedOrigin(const lms3dRayScanRequest& request)
{
  const auto isZero = [](const lms3dVector& v) { return v == lms3dVector{ 0.0, 0.0, 0.0 }; };
  return !request.Beams.IsMoving() &&
    std::all_of(request.Fans.begin(), request.Fans.end(),
      [&isZero](const lms3dRayFan& fan)
      { return std::all_of(fan.Origins.begin(), fan.Origins.end(), isZero); });
}
} // namespace

bool lms3dScanRays(const lms3dRayScanRequest& request, const lms3dProgress& progress)
{
  return HaveSharedOrigin(request) ? Run<SharedOrigin>(request, progress)
                                   : Run<OwnOrigins>(request, progress);
}
