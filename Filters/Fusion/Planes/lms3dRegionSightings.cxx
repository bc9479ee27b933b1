// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Planes/lms3dRegionSightings.h"

#include <numeric>
#include <vector>

namespace
{
/// The block nearest to a place in which a return lies, nullptr if there is none. The place is in
/// blocks.
template <typename Numbers>
const lms3dRasterBlock* FindNearest(
  const lms3dRaster& raster, const Numbers& numbers, const lms3dPoint2& place)
{
  const lms3dRasterBlock* best = nullptr;
  double least = 0.0;
  for (const int number : numbers)
  {
    const lms3dRasterBlock& block = raster.GetBlock(number);
    const double u = block.U + 0.5 - place[0];
    const double v = block.V + 0.5 - place[1];
    const double distance = u * u + v * v;
    if (block.Sightings.ScanCount > 0 && (!best || distance < least))
    {
      best = &block;
      least = distance;
    }
  }
  return best;
}

/// `place` is in blocks. `other` is nullptr, or what was found outside of the tile before.
lms3dSightings GetSightings(const lms3dRaster& raster, const lms3dFusedTile& tile,
  const lms3dPoint2& place, const lms3dRasterBlock*& other)
{
  const int number = raster.Find(lms3dGetCellOf(place[0]), lms3dGetCellOf(place[1]));
  if (number >= 0 && raster.GetBlock(number).Sightings.ScanCount > 0)
  {
    return raster.GetBlock(number).Sightings;
  }
  const lms3dRasterBlock* nearest = FindNearest(raster, tile.Blocks, place);
  if (!nearest && !other)
  {
    std::vector<int> all(static_cast<std::size_t>(raster.GetNumberOfBlocks()));
    std::iota(all.begin(), all.end(), 0);
    other = FindNearest(raster, all, place);
  }
  nearest = nearest ? nearest : other;
  return nearest ? nearest->Sightings : lms3dSightings();
}
} // namespace

void lms3dSetSightings(const lms3dFusedPlane& plane, lms3dFusedTile& tile)
{
  lms3dFusedMesh& mesh = tile.Mesh;
  mesh.Sightings.clear();
  const lms3dRasterBlock* other = nullptr;
  for (const auto& [a, b, c] : mesh.Triangles)
  {
    const lms3dVector centre =
      lms3dScale(lms3dAdd(mesh.Points[a], lms3dAdd(mesh.Points[b], mesh.Points[c])), 1.0 / 3.0);
    const lms3dPoint2 cells = plane.Frame.ToCells(centre);
    mesh.Sightings.push_back(GetSightings(
      plane.Raster, tile, { cells[0] / lms3dRaster::Size, cells[1] / lms3dRaster::Size }, other));
  }
}
