// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dPassedBeams.h"

#include "Fusion/lms3dRasterRows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace
{
// The diagonal of a block from its centre, cells.
constexpr double HalfDiagonal = 45.26;
// Cells: what lies between beams that are farther apart, at grazing angles, is unknown.
constexpr double LargestDistance = 128.0;
// The share of the bound from which on a beam counts as passed; less than 1 because of rounding.
constexpr double PassedShare = 0.999;
constexpr double SmallestCosine = 1e-9;
// Cells: no block lies farther away.
constexpr double LargestCell = 2e9;
// More than the rounding of a quick look at a beam, as a share of the range, and metres. At smaller
// cosines the rounding may be larger.
constexpr double QuickShare = 1e-6;
constexpr double QuickCosine = 1e-5;
// Cells: how far around a beam the shape may change.
constexpr int ShapeReach = 15;

// Whether the shape has a cell of the block near a cell.
bool HasShapeNear(const lms3dRasterBlock& cells, int u, int v)
{
  const int from = std::max(u - ShapeReach, 0);
  const int to = std::min(u + ShapeReach, lms3dRaster::Size - 1);
  const std::uint64_t mask =
    (~std::uint64_t{ 0 } << from) & (~std::uint64_t{ 0 } >> (lms3dRaster::Size - 1 - to));
  std::uint64_t found = 0;
  const int end = std::min(v + ShapeReach, lms3dRaster::Size - 1);
  for (int row = std::max(v - ShapeReach, 0); row <= end; ++row)
  {
    found |= cells.Shape[row];
  }
  return (found & mask) != 0;
}
} // namespace

// A quick look, in the sensor frame. Returns false if in doubt.
bool lms3dPassedBeams::IsSurelyShort(int beamId, double range) const
{
  const lms3dBeamTable& table = this->Ranges.GetTable();
  const double cosine = lms3dDot(this->Normal, table.GetDirection(beamId));
  if (table.HasStarts() || std::abs(cosine) < QuickCosine)
  {
    return false;
  }
  const double crossing = -this->Height / cosine;
  const double margin = QuickShare * (1.0 + std::abs(crossing));
  return crossing < -margin || range - crossing < PassedShare * this->MaximumError - margin;
}

lms3dPassedBeams::Passage lms3dPassedBeams::Find(const lms3dFusedPlane& plane, int beamId) const
{
  const double range = this->Ranges.GetRange(beamId);
  if (range == 0.0 || this->IsSurelyShort(beamId, range))
  {
    return {};
  }
  const lms3dVector direction = this->Ranges.GetDirection(beamId);
  const lms3dVector start = this->Ranges.GetStart(beamId);
  const double cosine = lms3dDot(plane.Frame.GetNormal(), direction);
  if (std::abs(cosine) < SmallestCosine)
  {
    return {};
  }
  const double crossing = -plane.Frame.GetHeight(start) / cosine;
  if (!(crossing > 0.0) || range - crossing <= PassedShare * this->MaximumError)
  {
    return {};
  }
  return { true, plane.Frame.ToCells(lms3dAdd(start, lms3dScale(direction, crossing))) };
}

void lms3dPassedBeams::FindBins(const lms3dFusedPlane& plane, int firstBlock)
{
  this->Bins.clear();
  this->HasBin.resize(static_cast<std::size_t>(this->Ranges.GetTable().GetNumberOfBins()));
  for (int block = firstBlock; block < plane.Raster.GetNumberOfBlocks(); ++block)
  {
    const lms3dRasterBlock& cells = plane.Raster.GetBlock(block);
    const lms3dVector centre = plane.Frame.ToWorld(
      { (cells.U + 0.5) * lms3dRaster::Size, (cells.V + 0.5) * lms3dRaster::Size });
    this->Ranges.FindBins(centre, HalfDiagonal * plane.Frame.GetCell(), this->BinsOfBlock);
    for (const int bin : this->BinsOfBlock)
    {
      if (!this->HasBin[bin])
      {
        this->HasBin[bin] = true;
        this->Bins.push_back(bin);
      }
    }
  }
  for (const int bin : this->Bins)
  {
    this->HasBin[bin] = false;
  }
}

void lms3dPassedBeams::Mark(lms3dFusedPlane& plane, int firstBlock)
{
  this->FindBins(plane, firstBlock);
  const lms3dVector& position = this->Ranges.GetPosition();
  this->Normal = this->Ranges.ToSensor(lms3dAdd(position, plane.Frame.GetNormal()));
  this->Height = plane.Frame.GetHeight(position);
  const lms3dBeamTable& table = this->Ranges.GetTable();
  for (const int bin : this->Bins)
  {
    for (const int* id = table.GetFirstInBin(bin); id != table.GetEndOfBin(bin); ++id)
    {
      this->MarkBeam(plane, firstBlock, *id);
    }
  }
}

void lms3dPassedBeams::MarkBeam(lms3dFusedPlane& plane, int firstBlock, int beamId)
{
  const Passage passage = this->Find(plane, beamId);
  if (!passage.IsPassed || std::abs(passage.Place[0]) > LargestCell ||
    std::abs(passage.Place[1]) > LargestCell)
  {
    return;
  }
  const auto column = static_cast<std::int32_t>(std::floor(passage.Place[0]));
  const auto row = static_cast<std::int32_t>(std::floor(passage.Place[1]));
  const int block =
    plane.Raster.Find(lms3dRaster::GetBlockOf(column), lms3dRaster::GetBlockOf(row));
  if (block < firstBlock)
  {
    return;
  }
  lms3dRasterBlock& cells = plane.Raster.GetBlock(block);
  const int u = lms3dRaster::GetPlaceOf(column);
  const int v = lms3dRaster::GetPlaceOf(row);
  std::uint64_t& word = cells.Passed[v];
  const std::uint64_t bit = std::uint64_t{ 1 } << u;
  if ((~word & bit) != 0 && HasShapeNear(cells, u, v))
  {
    plane.Raster.SetMark(block, lms3dRaster::DIRTY);
    plane.Raster.SetMark(block, lms3dRaster::DIRTY_AROUND);
  }
  if ((~word & cells.Touched[v] & bit) != 0)
  {
    plane.Raster.SetMark(block, lms3dRaster::STALE);
  }
  word |= bit;
  cells.HasPassed = true;
  if (this->Forgets)
  {
    cells.Must[v] &= ~bit;
    plane.Raster.SetMark(block, lms3dRaster::DIRTY);
  }
  this->MarkAround(plane, beamId, passage.Place);
}

// Opens a convex polygon between beams that passed, unless a return lies in it.
template <typename Points>
void lms3dPassedBeams::Open(lms3dFusedPlane& plane, const Points& points) const
{
  if (this->Forgets)
  {
    lms3dForTouchedStrips(points,
      [&](const lms3dCellStrip& strip)
      {
        plane.Raster.SetAndMark(&lms3dRasterBlock::Must, strip, false);
        return true;
      });
  }
  const bool isFree = !plane.Raster.HasAny(&lms3dRasterBlock::Must, lms3dGetTouchedBox(points)) ||
    lms3dForTouchedStrips(points,
      [&](const lms3dCellStrip& strip)
      { return !plane.Raster.HasAny(&lms3dRasterBlock::Must, strip); });
  if (isFree)
  {
    lms3dForTouchedStrips(points,
      [&](const lms3dCellStrip& strip)
      {
        plane.Raster.SetAndMark(&lms3dRasterBlock::Open, strip, true);
        return true;
      });
  }
}

void lms3dPassedBeams::MarkAround(
  lms3dFusedPlane& plane, int beamId, const lms3dPoint2& place) const
{
  const lms3dBeamTable& table = this->Ranges.GetTable();
  const auto find = [&](int id)
  {
    Passage passage = id < 0 ? Passage() : this->Find(plane, id);
    passage.IsPassed = passage.IsPassed &&
      std::abs(passage.Place[0] - place[0]) <= LargestDistance &&
      std::abs(passage.Place[1] - place[1]) <= LargestDistance;
    return passage;
  };
  const int turnId = table.GetNextTurn(beamId);
  const Passage inFan = find(table.GetNextInFan(beamId));
  const Passage inTurn = find(turnId);
  const Passage across = find(turnId < 0 ? -1 : table.GetNextInFan(turnId));
  if (inFan.IsPassed && inTurn.IsPassed && across.IsPassed)
  {
    this->Open(plane, std::array<lms3dPoint2, 4>{ place, inFan.Place, across.Place, inTurn.Place });
    return;
  }
  for (const Passage& passage : { inFan, inTurn })
  {
    if (passage.IsPassed)
    {
      this->Open(plane, std::array<lms3dPoint2, 2>{ place, passage.Place });
    }
  }
}
