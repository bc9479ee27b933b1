// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Returns/lms3dHandedReturns.h"

#include "Fusion/Planes/lms3dCoveringPlanes.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace
{
// As a share of the bound: returns that are nearer to their plane stay if it covers them.
constexpr double NearShare = 0.05;
// How much nearer another plane must be, as a share of the distance.
constexpr double NearerShare = 0.5;

using Cell = lms3dFusedTile::Cell;

Cell GetCell(const lms3dFusedPlane& plane, const lms3dMappedReturn& mapped)
{
  const lms3dPoint2 place = plane.Frame.ToCells(mapped.Point);
  return { lms3dGetCellOf(place[0]), lms3dGetCellOf(place[1]) };
}

lms3dCellStrip MakeStrip(const Cell& cell)
{
  return lms3dMakeCellStrip(cell[0], cell[1]);
}

/// Hands the returns of one plane over.
class Giver
{
public:
  Giver(lms3dFusedPlanes& planes, int number)
    : Planes(planes)
    , Number(number)
    , Plane(planes[number])
  {
  }

  void Give(int revision)
  {
    bool isNew = this->Plane.TiledBlocks == 0;
    for (const lms3dFusedTile& tile : this->Plane.Tiles)
    {
      if (tile.Revision == revision && !tile.Blocks.empty())
      {
        isNew = true;
        this->Facets.insert(tile.Facets.begin(), tile.Facets.end());
      }
    }
    if (!isNew)
    {
      return;
    }
    const bool hadReturns = !this->Plane.Returns.empty();
    this->Plane.DropForgotten();
    this->SetCovered(false);
    this->FindTakers();
    this->Move();
    this->SetCovered(true);
    if (hadReturns && this->Plane.Returns.empty())
    {
      this->Planes.Clear(this->Number);
    }
  }

private:
  /// The returns of a cell, with the planes that take them.
  using Takers = std::vector<std::pair<std::size_t, int>>;

  void SetCovered(bool isCovered)
  {
    for (const Cell& facet : this->Facets)
    {
      this->Plane.Raster.Set(&lms3dRasterBlock::Covered, MakeStrip(facet), isCovered);
    }
  }

  /// Whether a return may go, as far as its own plane says: the distance that a plane which takes
  /// it must not exceed, 0 if it stays.
  double GetLargestDistance(const lms3dMappedReturn& mapped) const
  {
    const double bound = this->Planes.GetMaximumError();
    const double height = std::abs(this->Plane.Frame.GetHeight(mapped.Point));
    if (!this->Planes.Covers(this->Plane, mapped))
    {
      return bound;
    }
    return height > NearShare * bound ? NearerShare * height : 0.0;
  }

  /// Finds what goes. If another return of a cell stays, no return of the cell goes.
  void FindTakers()
  {
    const std::vector<lms3dMappedReturn>& returns = this->Plane.Returns;
    lms3dCoveringPlanes search(this->Planes);
    for (std::size_t i = 0; i < returns.size(); ++i)
    {
      const double largest = this->GetLargestDistance(returns[i]);
      const int taker = largest > 0.0 ? search.Find(returns[i], { this->Number }, largest) : -1;
      if (taker >= 0)
      {
        this->TakersOf[GetCell(this->Plane, returns[i])].emplace_back(i, taker);
      }
    }
    if (this->TakersOf.empty())
    {
      return;
    }
    std::map<Cell, std::size_t> counts;
    for (const lms3dMappedReturn& mapped : returns)
    {
      const Cell cell = GetCell(this->Plane, mapped);
      if (this->TakersOf.count(cell) > 0)
      {
        ++counts[cell];
      }
    }
    for (const auto& [cell, count] : counts)
    {
      if (this->TakersOf[cell].size() < count)
      {
        this->TakersOf.erase(cell);
      }
    }
  }

  /// Facets of cells that go are no facets any more: if they explained their returns, the other
  /// planes would hand these back.
  void Move()
  {
    if (this->TakersOf.empty())
    {
      return;
    }
    std::vector<bool> goes(this->Plane.Returns.size());
    for (const auto& [cell, takers] : this->TakersOf)
    {
      this->Facets.erase(cell);
      this->Plane.Raster.Forget(MakeStrip(cell));
      this->Plane.Raster.SetMark(
        this->Plane.Raster.Find(lms3dRaster::GetBlockOf(cell[0]), lms3dRaster::GetBlockOf(cell[1])),
        lms3dRaster::STALE);
      for (const auto& [number, taker] : takers)
      {
        this->Planes.AddBeside(taker, this->Plane.Returns[number]);
        goes[number] = true;
      }
    }
    std::vector<lms3dMappedReturn> left;
    for (std::size_t i = 0; i < goes.size(); ++i)
    {
      if (!goes[i])
      {
        left.push_back(this->Plane.Returns[i]);
      }
    }
    this->Plane.Returns.swap(left);
  }

  lms3dFusedPlanes& Planes;
  const int Number;
  lms3dFusedPlane& Plane;
  std::set<Cell> Facets;
  std::map<Cell, Takers> TakersOf;
};
} // namespace

void lms3dHandReturnsOver(lms3dFusedPlanes& planes, int revision)
{
  const std::size_t end = planes.GetSize();
  for (std::size_t i = 0; i < end; ++i)
  {
    if (planes[i].IsWeak && planes[i].Verbatim.empty())
    {
      Giver(planes, static_cast<int>(i)).Give(revision);
    }
  }
}
