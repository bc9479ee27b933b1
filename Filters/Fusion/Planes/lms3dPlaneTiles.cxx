// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fusion/Planes/lms3dPlaneTiles.h"

#include <cstdint>

void lms3dAddTiles(lms3dFusedPlane& plane, std::vector<const lms3dFusedTile*>& regions)
{
  lms3dRaster& raster = plane.Raster;
  for (; plane.TiledBlocks < raster.GetNumberOfBlocks(); ++plane.TiledBlocks)
  {
    lms3dRasterBlock& block = raster.GetBlock(plane.TiledBlocks);
    const bool isWhole = !plane.Verbatim.empty();
    const std::int32_t u = isWhole ? 0 : lms3dFusedTile::GetTileOf(block.U);
    const std::int32_t v = isWhole ? 0 : lms3dFusedTile::GetTileOf(block.V);
    block.Tile = plane.TileNumbers.Find(u, v);
    if (block.Tile < 0)
    {
      block.Tile = plane.UsedTiles++;
      plane.TileNumbers.Add(u, v, block.Tile);
      if (block.Tile == static_cast<int>(plane.Tiles.size()))
      {
        plane.Tiles.emplace_back();
        regions.push_back(&plane.Tiles.back());
      }
      plane.Tiles[block.Tile] = isWhole ? lms3dFusedTile() : lms3dFusedTile(u, v);
    }
    plane.Tiles[block.Tile].Blocks.push_back(plane.TiledBlocks);
  }
}
