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
// A packet is nearly square in angle where it matters, at the horizon, so that its beams meet the
// same boxes.
constexpr int TileSide = 4;
static_assert(TileSide * TileSide == lms3dBeamPacket::Size, "a tile is a packet");

int CountTiles(int beamsOrTurns)
{
  return (beamsOrTurns - 1) / TileSide + 1;
}

/// Beam TileSide * i + j of a packet belongs to the tile's turn i and elevation j. Turns and beams
/// beyond the grid's end repeat the last one, so that the packet stays coherent.
class Scan
{
public:
  Scan(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry,
    const lms3dBeamDirections& directions, const lms3dPose& pose, const lms3dRangeLimits& limits,
    double* ranges, std::int32_t* triangles, const lms3dChoices* choices)
    : Caster(caster)
    , Directions(directions)
    , Kernels(lms3dGetPacketKernels())
    , Elevations(MakeElevations(geometry))
    , Viewpoint{ { pose.Position[0], pose.Position[1], pose.Position[2] }, limits.Maximum }
    , MinimumRange(limits.Minimum)
    , Turns(geometry.GetNumberOfTurns())
    , Beams(geometry.GetNumberOfBeams())
    , Ranges(ranges)
    , Triangles(triangles)
    , Choices(choices)
  {
  }

  void CastRow(int firstTurn) const
  {
    const lms3dFanAxes axes = this->MakeAxes(firstTurn);
    const int turns = std::min(TileSide, this->Turns - firstTurn);
    const std::size_t tiles = this->Elevations.size();
    // Not a vector, which would write zeros first.
    const std::unique_ptr<lms3dBeamPacket[]> packets(new lms3dBeamPacket[tiles]);
    for (std::size_t i = 0; i < tiles; ++i)
    {
      this->Kernels.Aim(this->Elevations[i], axes, packets[i]);
      packets[i].Active = GetActive(turns, this->CountBeams(i));
    }
    this->Caster.Choose(this->Viewpoint, packets.get(), static_cast<int>(tiles));
    for (std::size_t i = 0; this->Choices && i < tiles; ++i)
    {
      this->Store(firstTurn, turns, i, packets[i], this->Choices->Ranges, this->Choices->Triangles);
    }
    this->Caster.Measure(this->Viewpoint, packets.get(), static_cast<int>(tiles));
    for (std::size_t i = 0; i < tiles; ++i)
    {
      this->Kernels.Finish(this->MinimumRange, packets[i]);
      this->Store(firstTurn, turns, i, packets[i], this->Ranges, this->Triangles);
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
    double* ranges, std::int32_t* triangles) const
  {
    const int beams = this->CountBeams(tile);
    std::size_t slot = static_cast<std::size_t>(firstTurn) * this->Beams + tile * TileSide;
    for (int turn = 0; turn < turns; ++turn, slot += this->Beams)
    {
      const double* range = packet.Range + TileSide * turn;
      const std::int32_t* triangle = packet.Triangle + TileSide * turn;
      // A number that the compiler knows saves the call of a general copy.
      if (beams == TileSide)
      {
        std::copy_n(range, TileSide, ranges + slot);
        std::copy_n(triangle, TileSide, triangles + slot);
      }
      else
      {
        std::copy_n(range, beams, ranges + slot);
        std::copy_n(triangle, beams, triangles + slot);
      }
    }
  }

  const lms3dRayCaster& Caster;
  const lms3dBeamDirections& Directions;
  const lms3dPacketKernels& Kernels;
  const std::vector<lms3dElevations> Elevations;
  const lms3dViewpoint Viewpoint;
  const double MinimumRange;
  const int Turns;
  const int Beams;
  double* Ranges;
  std::int32_t* Triangles;
  const lms3dChoices* Choices;
};
} // namespace

bool lms3dScan(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry,
  const lms3dBeamDirections& directions, const lms3dPose& pose, const lms3dRangeLimits& limits,
  const lms3dProgress& progress, double* ranges, std::int32_t* triangles,
  const lms3dChoices* choices)
{
  const Scan scan(caster, geometry, directions, pose, limits, ranges, triangles, choices);
  const int rows = CountTiles(geometry.GetNumberOfTurns());
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
