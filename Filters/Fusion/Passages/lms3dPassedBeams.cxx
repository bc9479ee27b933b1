// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Passages/lms3dPassedBeams.h"

#include "Fusion/Cells/lms3dRasterRows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace
{
// Cells: what lies between beams that are farther apart, at grazing angles, is unknown.
constexpr double LargestDistance = 128.0;
// Cells: no block lies farther away.
constexpr double LargestCell = 2e9;
} // namespace

void lms3dPassedBeams::Mark(
  const lms3dSeenRanges& ranges, lms3dFusedPlane& plane, const lms3dBlockGroups& groups)
{
  this->Passages.Find(ranges, plane, groups);
  this->LastBlock = {};
  for (std::size_t i = 0; i < this->Passages.GetSize(); ++i)
  {
    this->MarkBeam(ranges, plane, groups.GetFirstBlock(), i);
  }
}

void lms3dPassedBeams::MarkBeam(
  const lms3dSeenRanges& ranges, lms3dFusedPlane& plane, int firstBlock, std::size_t number)
{
  const lms3dPoint2& place = this->Passages.GetPlace(number);
  if (std::abs(place[0]) > LargestCell || std::abs(place[1]) > LargestCell)
  {
    return;
  }
  const auto column = lms3dGetCellOf(place[0]);
  const auto row = lms3dGetCellOf(place[1]);
  const int block = this->LastBlock.Find(
    lms3dRaster::GetBlockOf(column), lms3dRaster::GetBlockOf(row), plane.Raster);
  if (block < firstBlock)
  {
    return;
  }
  lms3dRasterBlock& cells = plane.Raster.GetBlock(block);
  const int u = lms3dRaster::GetPlaceOf(column);
  const int v = lms3dRaster::GetPlaceOf(row);
  const std::uint64_t bit = std::uint64_t{ 1 } << u;
  if ((~cells.Passed[v] & cells.Touched[v] & bit) != 0)
  {
    plane.Raster.SetMark(block, lms3dRaster::STALE);
  }
  plane.Raster.Pass(block, u, v);
  if (this->Forgets)
  {
    lms3dCellStrip cell;
    cell.Row = row;
    cell.Add(column, column);
    plane.Raster.Forget(cell);
  }
  this->MarkAround(ranges.GetTable(), plane, number);
}

bool lms3dPassedBeams::IsOpen(const lms3dRaster& raster, const lms3dCellBox& box) const
{
  return this->LastBlock.Has(box)
    ? raster.HasAll(&lms3dRasterBlock::Open, this->LastBlock.GetNumber(), box)
    : raster.HasAll(&lms3dRasterBlock::Open, box);
}

// Opens a convex polygon between beams that passed, unless a return lies in it.
template <typename Points>
void lms3dPassedBeams::Open(lms3dFusedPlane& plane, const Points& points) const
{
  const lms3dCellBox box = lms3dGetTouchedBox(points);
  if (!this->Forgets && this->IsOpen(plane.Raster, box))
  {
    return;
  }
  if (this->Forgets)
  {
    lms3dForTouchedStrips(points,
      [&](const lms3dCellStrip& strip)
      {
        plane.Raster.Forget(strip);
        return true;
      });
  }
  const bool isFree = !plane.Raster.HasAny(&lms3dRasterBlock::Must, box) ||
    lms3dForTouchedStrips(points,
      [&](const lms3dCellStrip& strip)
      { return !plane.Raster.HasAny(&lms3dRasterBlock::Must, strip); });
  if (isFree)
  {
    lms3dForTouchedStrips(points,
      [&](const lms3dCellStrip& strip)
      {
        plane.Raster.Open(strip);
        return true;
      });
  }
}

void lms3dPassedBeams::MarkAround(
  const lms3dBeamTable& table, lms3dFusedPlane& plane, std::size_t number) const
{
  const int beamId = this->Passages.GetBeam(number);
  const lms3dPoint2& place = this->Passages.GetPlace(number);
  const auto find = [&](int id)
  {
    lms3dPassage passage = id < 0 ? lms3dPassage() : this->Passages.Get(id);
    passage.IsPassed = passage.IsPassed &&
      std::abs(passage.Place[0] - place[0]) <= LargestDistance &&
      std::abs(passage.Place[1] - place[1]) <= LargestDistance;
    return passage;
  };
  const auto [nextId, acrossId, turnId] = table.GetNeighbours(beamId);
  const lms3dPassage inFan = find(nextId);
  const lms3dPassage inTurn = find(turnId);
  const lms3dPassage across = find(acrossId);
  if (inFan.IsPassed && inTurn.IsPassed && across.IsPassed)
  {
    this->Open(plane, std::array<lms3dPoint2, 4>{ place, inFan.Place, across.Place, inTurn.Place });
    return;
  }
  for (const lms3dPassage& passage : { inFan, inTurn })
  {
    if (passage.IsPassed)
    {
      this->Open(plane, std::array<lms3dPoint2, 2>{ place, passage.Place });
    }
  }
}
