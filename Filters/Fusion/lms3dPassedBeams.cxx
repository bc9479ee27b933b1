// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/lms3dPassedBeams.h"

#include "Fusion/lms3dRasterRows.h"

#include <array>
#include <cmath>

namespace
{
// The diagonal of a block from its centre, cells.
constexpr double HalfDiagonal = 45.26;
// Cells: what lies between beams that are farther apart, at grazing angles, is unknown.
constexpr double LargestDistance = 128.0;
// The share of the bound from which on a beam counts as passed; less than 1 because of rounding.
constexpr double PassedShare = 0.999;
constexpr double SmallestCosine = 1e-9;
} // namespace

lms3dPassedBeams::Passage lms3dPassedBeams::Find(const lms3dFusedPlane& plane, int beamId) const
{
  const double range = this->Ranges.GetRange(beamId);
  if (range == 0.0)
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

void lms3dPassedBeams::Mark(lms3dFusedPlane& plane, int block)
{
  const lms3dRasterBlock& cells = plane.Raster.GetBlock(block);
  const lms3dVector centre = plane.Frame.ToWorld(
    { (cells.U + 0.5) * lms3dRaster::Size, (cells.V + 0.5) * lms3dRaster::Size });
  this->Ranges.FindBins(centre, HalfDiagonal * plane.Frame.GetCell(), this->Bins);
  const lms3dBeamTable& table = this->Ranges.GetTable();
  for (const int bin : this->Bins)
  {
    for (const int* id = table.GetFirstInBin(bin); id != table.GetEndOfBin(bin); ++id)
    {
      this->MarkBeam(plane, block, *id);
    }
  }
}

void lms3dPassedBeams::MarkBeam(lms3dFusedPlane& plane, int block, int beamId)
{
  const Passage passage = this->Find(plane, beamId);
  if (!passage.IsPassed)
  {
    return;
  }
  lms3dRasterBlock& cells = plane.Raster.GetBlock(block);
  const double u = std::floor(passage.Place[0]) - static_cast<double>(cells.U) * lms3dRaster::Size;
  const double v = std::floor(passage.Place[1]) - static_cast<double>(cells.V) * lms3dRaster::Size;
  if (u < 0.0 || v < 0.0 || u >= lms3dRaster::Size || v >= lms3dRaster::Size)
  {
    return;
  }
  std::uint64_t& word = cells.Passed[static_cast<int>(v)];
  const std::uint64_t bit = std::uint64_t{ 1 } << static_cast<int>(u);
  plane.IsChanged = plane.IsChanged || (~word & cells.Touched[static_cast<int>(v)] & bit) != 0;
  word |= bit;
  if (this->Forgets)
  {
    cells.Must[static_cast<int>(v)] &= ~bit;
  }
  this->MarkAround(plane, beamId, passage.Place);
}

// Opens a convex polygon between beams that passed, unless a return lies in it.
template <typename Points>
void lms3dPassedBeams::Open(lms3dFusedPlane& plane, const Points& points) const
{
  const auto setRow = [&](lms3dRaster::BitsOf bits, bool value)
  {
    return [&plane, bits, value](std::int32_t row, std::int32_t first, std::int32_t last)
    {
      plane.Raster.SetRow(bits, row, first, last, value, false, [](int) {});
      return true;
    };
  };
  if (this->Forgets)
  {
    lms3dForTouchedRows(points, setRow(&lms3dRasterBlock::Must, false));
  }
  const bool isFree = lms3dForTouchedRows(points,
    [&](std::int32_t row, std::int32_t first, std::int32_t last)
    { return !plane.Raster.HasAny(&lms3dRasterBlock::Must, row, first, last); });
  if (isFree)
  {
    lms3dForTouchedRows(points, setRow(&lms3dRasterBlock::Open, true));
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
