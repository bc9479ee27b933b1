// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dWideBeams.h"

#include "Casting/lms3dRayCaster.h"
#include "Scan/lms3dEchoes.h"
#include "Scan/lms3dRayScanner.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace
{
// 24 MB, or 64 MB with several processes. Enough for the room with 16 rays for each beam.
constexpr std::int64_t MaximumRaysOfBlock = std::int64_t(1) << 21;

// Covers the rounding of a range along the axis.
constexpr double RangeMargin = 1.0 + 1e-12;

int CountTurnsPerBlock(const lms3dScanGeometry& geometry, std::size_t rays)
{
  const std::int64_t raysOfTurn =
    static_cast<std::int64_t>(geometry.GetNumberOfBeams()) * static_cast<std::int64_t>(rays);
  const std::int64_t packets =
    std::max<std::int64_t>(1, MaximumRaysOfBlock / raysOfTurn / lms3dPacketGrid::Side);
  return static_cast<int>(
    std::min<std::int64_t>(packets * lms3dPacketGrid::Side, geometry.GetNumberOfTurns()));
}
} // namespace

lms3dWideBeams::lms3dWideBeams(
  const lms3dMovingBeams& beams, const lms3dFootprint& footprint, const lms3dRangeLimits& limits)
  : Beams(beams)
  , Footprint(footprint)
  , Limits(limits)
{
  double smallestCosine = 1.0;
  for (const lms3dDiscPoint& point : lms3dGetDiscPoints(footprint.Samples))
  {
    this->Fans.emplace_back(beams.GetGeometry(), beams.GetFan(), footprint, point);
    smallestCosine = std::min(smallestCosine, this->Fans.back().Cosine);
  }
  this->MaximumRayRange = limits.Maximum / smallestCosine * RangeMargin;
  this->TurnsPerBlock = CountTurnsPerBlock(beams.GetGeometry(), this->Fans.size());
}

int lms3dWideBeams::GetNumberOfBlocks() const
{
  return (this->Beams.GetGeometry().GetNumberOfTurns() - 1) / this->TurnsPerBlock + 1;
}

int lms3dWideBeams::CountTurns(int block) const
{
  return std::min(
    this->TurnsPerBlock, this->Beams.GetGeometry().GetNumberOfTurns() - this->GetFirstTurn(block));
}

bool lms3dWideBeams::Cast(
  int block, const lms3dRayCaster* caster, bool isPart, const lms3dProgress& progress)
{
  const int turns = this->CountTurns(block);
  const std::size_t rays = static_cast<std::size_t>(turns) *
    this->Beams.GetGeometry().GetNumberOfBeams() * this->Fans.size();
  this->Ranges.resize(rays);
  this->Triangles.resize(rays);
  lms3dBeamHits nearest = { nullptr, nullptr };
  if (isPart)
  {
    this->Part.Allocate(rays);
    nearest = this->Part.GetNearest();
  }
  if (!caster)
  {
    std::fill(this->Ranges.begin(), this->Ranges.end(), NAN);
    return true;
  }
  return lms3dScanRays(
    { *caster, this->Beams, this->Fans, { 0.0, this->MaximumRayRange }, this->GetFirstTurn(block),
      turns, { this->Ranges.data(), this->Triangles.data() }, nearest, false },
    progress);
}

void lms3dWideBeams::ReduceToNearest(
  const lms3dProcesses& processes, const lms3dRayCaster* caster, std::int64_t firstCell)
{
  this->Part.ReduceToNearest(
    processes, caster, firstCell, this->Ranges.data(), this->Triangles.data());
}

double lms3dWideBeams::ToRangeOnAxis(double range, std::size_t ray) const
{
  const double onAxis = range * this->Fans[ray].Cosine;
  return onAxis <= this->Limits.Maximum * RangeMargin ? std::min(onAxis, this->Limits.Maximum)
                                                      : NAN;
}

void lms3dWideBeams::Mix(int block, const lms3dMixedBeams& mixed) const
{
  const int beams = this->Beams.GetGeometry().GetNumberOfBeams();
  const std::size_t stride = static_cast<std::size_t>(this->CountTurns(block)) * beams;
  const std::size_t firstSlot = static_cast<std::size_t>(this->GetFirstTurn(block)) * beams;
  tbb::parallel_for(0, this->CountTurns(block),
    [&](int turn)
    {
      lms3dEchoes echoes(this->Footprint.PulseLength);
      std::vector<double> ranges(this->Fans.size());
      for (int beam = 0; beam < beams; ++beam)
      {
        const std::size_t first = static_cast<std::size_t>(turn) * beams + beam;
        for (std::size_t ray = 0; ray < ranges.size(); ++ray)
        {
          ranges[ray] = this->ToRangeOnAxis(this->Ranges[first + ray * stride], ray);
        }
        const lms3dEcho echo = echoes.FindReported(ranges);
        const bool isReturn = echo.Range >= this->Limits.Minimum;
        const std::size_t source = first + std::max(0, echo.Ray) * stride;
        const std::size_t slot = firstSlot + first;
        mixed.Returns.Ranges[slot] = isReturn ? echo.Range : NAN;
        mixed.Returns.Triangles[slot] =
          isReturn ? this->Triangles[source] : lms3dBeamPacket::NoTriangle;
        if (mixed.Cells)
        {
          mixed.Cells[slot] = this->Part.Cells[source];
          mixed.OwnTriangles[slot] =
            isReturn ? this->Part.Triangles[source] : lms3dBeamPacket::NoTriangle;
        }
      }
    });
}
