// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dScanner.h"

#include "Kernels/lms3dPacketKernels.h"
#include "Pipeline/lms3dProgressReporter.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace
{
// A square tile of beams and turns is nearly square in angle at the horizon, so that its beams traverse
// the same boxes of the tree.
constexpr int TileSide = 4;
static_assert(TileSide * TileSide == lms3dBeamPacket::Size, "a tile is a packet");

int CountTiles(int beamsOrTurns)
{
  return (beamsOrTurns - 1) / TileSide + 1;
}

/// Beam TileSide * i + j of a packet belongs to turn i and elevation j of a tile. Beyond the end of the
/// grid a packet repeats the last turn or beam, inactive, so that it stays coherent.
class Scan
{
public:
  explicit Scan(const lms3dScanRequest& request)
    : Request(request)
    , Directions(request.Geometry, request.Pose)
    , Kernels(lms3dGetPacketKernels())
    , Elevations(MakeElevations(request.Geometry))
    , Origin{ { request.Pose.Position[0], request.Pose.Position[1], request.Pose.Position[2] },
      request.Limits.Maximum }
    , Turns(request.Geometry.GetNumberOfTurns())
    , Beams(request.Geometry.GetNumberOfBeams())
  {
  }

  void CastRow(int firstTurn) const
  {
    const lms3dFanAxes axes = this->MakeAxes(firstTurn);
    const int turns = std::min(TileSide, this->Turns - firstTurn);
    const std::size_t tiles = this->Elevations.size();
    // A vector would write zeros first.
    const std::unique_ptr<lms3dBeamPacket[]> packets(new lms3dBeamPacket[tiles]);
    for (std::size_t i = 0; i < tiles; ++i)
    {
      this->Kernels.GenerateDirections(this->Elevations[i], axes, packets[i]);
      packets[i].Active = GetActive(turns, this->CountBeams(i));
    }
    const int count = static_cast<int>(tiles);
    this->Request.Caster.FindNearest(this->Origin, packets.get(), count);
    for (std::size_t i = 0; this->Request.NearestHits.Ranges && i < tiles; ++i)
    {
      this->Store(firstTurn, turns, i, packets[i], this->Request.NearestHits);
    }
    this->Request.Caster.RefineRanges(this->Origin, packets.get(), count);
    for (std::size_t i = 0; i < tiles; ++i)
    {
      this->Kernels.ApplyMinimumRange(this->Request.Limits.Minimum, packets[i]);
      this->Store(firstTurn, turns, i, packets[i], this->Request.Returns);
    }
  }

private:
  static std::vector<lms3dElevations> MakeElevations(const lms3dScanGeometry& geometry)
  {
    const int beams = geometry.GetNumberOfBeams();
    std::vector<lms3dElevations> elevations(CountTiles(beams));
    for (std::size_t tile = 0; tile < elevations.size(); ++tile)
    {
      for (int i = 0; i < lms3dBeamPacket::Size; ++i)
      {
        const int beam = std::min(static_cast<int>(tile) * TileSide + i % TileSide, beams - 1);
        elevations[tile].Cosine[i] = geometry.GetAlphaCosine(beam);
        elevations[tile].Sine[i] = geometry.GetAlphaSine(beam);
      }
    }
    return elevations;
  }

  lms3dFanAxes MakeAxes(int firstTurn) const
  {
    lms3dFanAxes axes;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < lms3dBeamPacket::Size; ++i)
      {
        const int turn = std::min(firstTurn + i / TileSide, this->Turns - 1);
        axes.Horizontal[axis][i] = this->Directions.GetFanAxis(turn)[axis];
      }
      axes.Up[axis] = this->Directions.GetUp()[axis];
    }
    return axes;
  }

  int CountBeams(std::size_t tile) const
  {
    return std::min(TileSide, this->Beams - static_cast<int>(tile) * TileSide);
  }

  static std::uint32_t GetActive(int turns, int beams)
  {
    std::uint32_t active = 0;
    for (int turn = 0; turn < turns; ++turn)
    {
      active |= ((1u << beams) - 1u) << (TileSide * turn);
    }
    return active;
  }

  void Store(int firstTurn, int turns, std::size_t tile, const lms3dBeamPacket& packet,
    const lms3dBeamHits& hits) const
  {
    const int beams = this->CountBeams(tile);
    std::size_t slot = static_cast<std::size_t>(firstTurn) * this->Beams + tile * TileSide;
    for (int turn = 0; turn < turns; ++turn, slot += this->Beams)
    {
      const double* range = packet.Range + TileSide * turn;
      const std::int32_t* triangle = packet.Triangle + TileSide * turn;
      // With a constant count, the compiler does not call a general copy.
      if (beams == TileSide)
      {
        std::copy_n(range, TileSide, hits.Ranges + slot);
        std::copy_n(triangle, TileSide, hits.Triangles + slot);
      }
      else
      {
        std::copy_n(range, beams, hits.Ranges + slot);
        std::copy_n(triangle, beams, hits.Triangles + slot);
      }
    }
  }

  const lms3dScanRequest& Request;
  const lms3dBeamDirections Directions;
  const lms3dPacketKernels& Kernels;
  const std::vector<lms3dElevations> Elevations;
  const lms3dRayOrigin Origin;
  const int Turns;
  const int Beams;
};
} // namespace

bool lms3dScan(const lms3dScanRequest& request, const lms3dProgress& progress)
{
  const Scan scan(request);
  const int rows = CountTiles(request.Geometry.GetNumberOfTurns());
  std::atomic<int> rowsDone{ 0 };
  lms3dProgressReporter reporter(progress);

  tbb::parallel_for(tbb::blocked_range<int>(0, rows),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int row = range.begin(); row < range.end() && !reporter.IsStopped(); ++row)
      {
        scan.CastRow(row * TileSide);
        reporter.Report(static_cast<double>(++rowsDone) / rows);
      }
    });
  return !reporter.IsStopped();
}
