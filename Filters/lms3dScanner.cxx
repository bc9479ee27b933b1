// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dScanner.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <thread>

namespace
{
// A packet is nearly square in angle where it matters, at the horizon, so that its beams meet the
// same boxes.
constexpr int TileTurns = 4;
constexpr int TileBeams = 4;
static_assert(TileTurns * TileBeams == lms3dBeamPacket::Size, "a tile is a packet");

class Scan
{
public:
  Scan(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry, const lms3dPose& pose,
    const lms3dRangeLimits& limits, double* ranges, std::int32_t* triangles)
    : Caster(caster)
    , Directions(geometry, pose)
    , Origin(pose.Position)
    , Limits(limits)
    , Turns(geometry.GetNumberOfTurns())
    , Beams(geometry.GetNumberOfBeams())
    , Ranges(ranges)
    , Triangles(triangles)
  {
  }

  void CastRow(int firstTurn) const
  {
    lms3dBeamPacket packet;
    for (int firstBeam = 0; firstBeam < this->Beams; firstBeam += TileBeams)
    {
      this->Aim(firstTurn, firstBeam, packet);
      this->Caster.Cast(this->Origin.data(), this->Limits.Maximum, packet);
      this->Store(firstTurn, firstBeam, packet);
    }
  }

private:
  // Beams beyond the grid's end repeat the last one, so that the packet stays coherent.
  void Aim(int firstTurn, int firstBeam, lms3dBeamPacket& packet) const
  {
    packet.Active = 0;
    for (int i = 0; i < lms3dBeamPacket::Size; ++i)
    {
      const int turn = firstTurn + i / TileBeams;
      const int beam = firstBeam + i % TileBeams;
      const std::array<double, 3> direction = this->Directions.GetDirection(
        std::min(turn, this->Turns - 1), std::min(beam, this->Beams - 1));
      for (int axis = 0; axis < 3; ++axis)
      {
        packet.Direction[axis][i] = direction[axis];
      }
      packet.Active |= static_cast<std::uint32_t>(turn < this->Turns && beam < this->Beams) << i;
    }
  }

  void Store(int firstTurn, int firstBeam, const lms3dBeamPacket& packet) const
  {
    for (int i = 0; i < lms3dBeamPacket::Size; ++i)
    {
      if (!(packet.Active & (1u << i)))
      {
        continue;
      }
      const std::size_t slot = static_cast<std::size_t>(firstTurn + i / TileBeams) * this->Beams +
        firstBeam + i % TileBeams;
      const bool isReturn = packet.Triangle[i] != lms3dBeamPacket::NoTriangle &&
        packet.Range[i] >= this->Limits.Minimum;
      this->Ranges[slot] = isReturn ? packet.Range[i] : std::numeric_limits<double>::quiet_NaN();
      this->Triangles[slot] = isReturn ? packet.Triangle[i] : lms3dBeamPacket::NoTriangle;
    }
  }

  const lms3dRayCaster& Caster;
  const lms3dScanGeometry::Directions Directions;
  const std::array<double, 3> Origin;
  const lms3dRangeLimits Limits;
  const int Turns;
  const int Beams;
  double* Ranges;
  std::int32_t* Triangles;
};
} // namespace

bool lms3dScan(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry,
  const lms3dPose& pose, const lms3dRangeLimits& limits, const lms3dProgress& progress,
  double* ranges, std::int32_t* triangles)
{
  const Scan scan(caster, geometry, pose, limits, ranges, triangles);
  const int rows = (geometry.GetNumberOfTurns() + TileTurns - 1) / TileTurns;
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<int> rowsDone{ 0 };
  std::atomic<bool> stopped{ false };

  tbb::parallel_for(tbb::blocked_range<int>(0, rows),
    [&](const tbb::blocked_range<int>& range)
    {
      for (int row = range.begin(); row < range.end() && !stopped; ++row)
      {
        scan.CastRow(row * TileTurns);
        ++rowsDone;
        if (std::this_thread::get_id() == caller && !progress(double(rowsDone) / rows))
        {
          stopped = true;
        }
      }
    });
  return !stopped;
}
