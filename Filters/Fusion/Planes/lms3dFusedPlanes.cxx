// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Planes/lms3dFusedPlanes.h"

#include "Fusion/Cells/lms3dCoveredCells.h"
#include "Fusion/Cells/lms3dRasterRows.h"
#include "Fusion/Planes/lms3dFacet.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

namespace
{
// Cells for each bound.
constexpr double CellsPerBound = 3.0;
// Bounds: the size of the cubes in which planes are looked for.
constexpr double CubeShare = 50.0;
// A weak plane with more returns is not weak any more.
constexpr std::size_t LargestWeakCount = 20000;

// Lets a scan have seen a block. Returns whether this changes its sightings.
bool See(
  const lms3dMappedReturn& mapped, const lms3dVector& normal, int scan, lms3dRasterBlock& block)
{
  const bool isLast = block.Sightings.LastScan < scan;
  block.Sightings.ScanCount += block.Sightings.LastScan < scan ? 1 : 0;
  block.Sightings.LastScan = std::max(block.Sightings.LastScan, scan);
  const double quality = -lms3dDot(normal, mapped.Direction) / (mapped.Range * mapped.Range);
  if (quality > block.Quality)
  {
    block.Quality = quality;
    block.Sightings.BestScan = scan;
    return true;
  }
  return isLast;
}
} // namespace

lms3dFusedPlanes::lms3dFusedPlanes(double maximumError)
  : MaximumError(maximumError)
  , Cell(maximumError / CellsPerBound)
  , Memory(std::make_shared<lms3dBlockMemory>(sizeof(lms3dRasterBlock)))
  , Boxes(CubeShare * maximumError)
{
}

int lms3dFusedPlanes::MakePlane(
  const lms3dVector& point, const lms3dVector& normal, const lms3dVector& middle)
{
  const lms3dPlaneFrame frame(point, normal, this->Cell, middle);
  if (!this->Unused.empty())
  {
    const int number = this->Unused.back();
    this->Unused.pop_back();
    this->Planes[number].Reuse(frame);
    return number;
  }
  this->Planes.emplace_back(frame, this->Memory);
  this->Boxes.AddPlane();
  return static_cast<int>(this->Planes.size()) - 1;
}

void lms3dFusedPlanes::Clear(int number)
{
  this->Planes[number].Clear();
  this->Boxes.Remove(static_cast<std::size_t>(number));
  this->Cleared.push_back(number);
}

void lms3dFusedPlanes::ReuseNumbers()
{
  const auto unused = std::partition(this->Cleared.begin(), this->Cleared.end(),
    [this](int number) { return this->IsCreaseOfOthers(number); });
  std::for_each(unused, this->Cleared.end(), [this](int number) { this->DropCreases(number); });
  this->Unused.insert(this->Unused.end(), unused, this->Cleared.end());
  this->Cleared.erase(unused, this->Cleared.end());
  std::sort(this->Unused.begin(), this->Unused.end(), std::greater<>());
}

// Whether a plane that has not gone ends at a crease with a plane.
bool lms3dFusedPlanes::IsCreaseOfOthers(int number) const
{
  const auto& creases = this->Planes[number].Creases;
  return std::any_of(creases.begin(), creases.end(),
    [this](const auto& crease) { return !this->Planes[crease.first].HasGone; });
}

void lms3dFusedPlanes::DropCreases(int number)
{
  for (const auto& crease : this->Planes[number].Creases)
  {
    this->Planes[crease.first].Creases.erase(number);
  }
  this->Planes[number].Creases.clear();
}

void lms3dFusedPlanes::GrowBox(int number, const lms3dLocalMap& local, int triangle)
{
  for (int corner = 0; corner < 3; ++corner)
  {
    this->GrowBox(number, local.GetCorner(triangle, corner));
  }
}

void lms3dFusedPlanes::GuessTriangle(int number, const lms3dLocalMap& local, int triangle)
{
  this->GuessTriangle(number,
    { local.GetCorner(triangle, 0), local.GetCorner(triangle, 1), local.GetCorner(triangle, 2) });
}

void lms3dFusedPlanes::GuessTriangle(int number, const std::array<lms3dVector, 3>& corners)
{
  lms3dFusedPlane& plane = this->Planes[number];
  const std::array<lms3dPoint2, 3> cells = { plane.Frame.ToCells(corners[0]),
    plane.Frame.ToCells(corners[1]), plane.Frame.ToCells(corners[2]) };
  if (plane.Raster.HasMayOrGuess(lms3dGetTouchedBox(cells)))
  {
    return;
  }
  lms3dForTouchedStrips(cells,
    [&](const lms3dCellStrip& strip)
    {
      plane.Raster.SetGuess(strip);
      return true;
    });
}

void lms3dFusedPlanes::AcceptGuesses(int number)
{
  lms3dRaster& raster = this->Planes[number].Raster;
  if (!raster.MayHaveGuess())
  {
    return;
  }
  raster.ForgetGuesses();
  const std::vector<int>& marked = raster.GetMarked();
  for (const int i : marked)
  {
    if (!raster.HasMark(i, lms3dRaster::GUESSED))
    {
      continue;
    }
    raster.AcceptGuess(i);
    this->Planes[number].HasSurface = true;
  }
}

// Whether the mesh explains a return in a cell. Most cells are covered themselves.
bool lms3dFusedPlanes::IsCovered(
  const lms3dFusedPlane& plane, const lms3dRasterBlock& block, std::int32_t u, std::int32_t v) const
{
  const int row = lms3dRaster::GetPlaceOf(v);
  const int column = lms3dRaster::GetPlaceOf(u);
  if (block.IsAllCovered || (block.Covered[row] >> column & 1U) != 0)
  {
    return true;
  }
  return lms3dIsCovered(
    plane.Raster, plane.GetCellsOfTile(u, v), u, v, block.GetCoveredReach(row, column));
}

bool lms3dFusedPlanes::AddReturn(int number, const lms3dMappedReturn& mapped)
{
  lms3dFusedPlane& plane = this->Planes[number];
  if (!plane.Explains(mapped.Point, mapped.Direction, this->GetLargestDistance()))
  {
    return false;
  }
  const lms3dPoint2 place = plane.Frame.ToCells(mapped.Point);
  const auto u = lms3dGetCellOf(place[0]);
  const auto v = lms3dGetCellOf(place[1]);
  const int blockNumber = plane.Raster.Make(lms3dRaster::GetBlockOf(u), lms3dRaster::GetBlockOf(v));
  plane.Raster.SetReturn(blockNumber, lms3dRaster::GetPlaceOf(u), lms3dRaster::GetPlaceOf(v));
  this->NoteReturn(plane, blockNumber, mapped, place);
  if (!this->IsCovered(plane, plane.Raster.GetBlock(blockNumber), u, v))
  {
    plane.Raster.SetMark(blockNumber, lms3dRaster::STALE);
  }
  return true;
}

// Notes what a return in a block means for the plane, apart from its region.
void lms3dFusedPlanes::NoteReturn(lms3dFusedPlane& plane, int blockNumber,
  const lms3dMappedReturn& mapped, const lms3dPoint2& place) const
{
  const int scan = mapped.Scan < 0 ? this->Scan : mapped.Scan;
  if (plane.IsWeak)
  {
    plane.Returns.push_back(mapped);
    plane.Returns.back().Scan = scan;
    if (plane.Returns.size() > LargestWeakCount)
    {
      plane.IsWeak = false;
      plane.Returns = {};
    }
  }
  lms3dRasterBlock& block = plane.Raster.GetBlock(blockNumber);
  const double height = std::abs(plane.Frame.GetHeight(mapped.Point));
  const int reach = lms3dGetCoveredReach(height, this->Cell, this->MaximumError);
  const int row = lms3dRaster::GetPlaceOf(lms3dGetCellOf(place[1]));
  const std::uint64_t bit = std::uint64_t{ 1 } << lms3dRaster::GetPlaceOf(lms3dGetCellOf(place[0]));
  block.Halfway[row] |= reach <= 1 ? bit : 0;
  block.Far[row] |= reach == 0 ? bit : 0;
  if (See(mapped, plane.Frame.GetNormal(), scan, block))
  {
    plane.Raster.SetMark(blockNumber, lms3dRaster::SEEN);
  }
}

void lms3dFusedPlanes::AddBeside(int number, const lms3dMappedReturn& mapped)
{
  lms3dFusedPlane& plane = this->Planes[number];
  const lms3dPoint2 place = plane.Frame.ToCells(mapped.Point);
  const auto u = lms3dGetCellOf(place[0]);
  const auto v = lms3dGetCellOf(place[1]);
  const int block = plane.Raster.Find(lms3dRaster::GetBlockOf(u), lms3dRaster::GetBlockOf(v));
  plane.Raster.GetBlock(block).Beside[lms3dRaster::GetPlaceOf(v)] |= std::uint64_t{ 1 }
    << lms3dRaster::GetPlaceOf(u);
  this->NoteReturn(plane, block, mapped, place);
  // The mesher takes the farthest return of a cell for all of its returns.
  if (!this->IsCovered(plane, plane.Raster.GetBlock(block), u, v))
  {
    plane.Raster.SetMark(block, lms3dRaster::STALE);
  }
}

void lms3dFusedPlanes::AddBesideOrFacet(int number, const lms3dMappedReturn& mapped)
{
  if (number >= 0)
  {
    this->AddBeside(number, mapped);
  }
  else
  {
    this->AddFacet(mapped);
  }
}

// A small triangle around a return, across its beam.
void lms3dFusedPlanes::AddFacet(const lms3dMappedReturn& mapped)
{
  const lms3dVector normal = lms3dScale(mapped.Direction, -1.0);
  const int number = this->MakePlane(mapped.Point, normal);
  const lms3dPlaneFrame& frame = this->Planes[number].Frame;
  const std::array<lms3dPoint2, 3> facet = lms3dMakeFacet(frame.ToCells(mapped.Point));
  this->Planes[number].Verbatim.push_back(
    { frame.ToWorld(facet[0]), frame.ToWorld(facet[1]), frame.ToWorld(facet[2]) });
  this->Planes[number].IsWeak = true;
  this->GrowBox(number, mapped.Point);
  this->AddReturn(number, mapped);
}
