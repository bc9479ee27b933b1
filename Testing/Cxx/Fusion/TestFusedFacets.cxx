// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the facets of returns to which the region of a plane does not grow.
 */
#include "Fusion/Planes/lms3dFusedPlanes.h"
#include "Fusion/Planes/lms3dRegionMesher.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{
constexpr double Bound = 0.01;
constexpr std::int32_t Row = 15;

lms3dCellStrip MakeStrip(std::int32_t row, std::int32_t first, std::int32_t last)
{
  lms3dCellStrip strip;
  strip.Row = row;
  strip.Add(first, last);
  return strip;
}

/// A plane of few returns with one block, which is its tile.
struct SmallPlane
{
  SmallPlane()
    : Plane(Planes[Planes.MakePlane({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 })])
  {
    this->Plane.IsWeak = true;
    this->Plane.Tiles.emplace_back();
    this->Plane.Tiles.front().Blocks.push_back(this->Plane.Raster.Make(0, 0));
    this->Plane.Raster.GetBlock(0).Tile = 0;
  }

  /// Adds a return above the middle of a cell of the row, at a height in metres.
  void AddBeside(std::int32_t column, double height = 0.0)
  {
    lms3dMappedReturn mapped;
    mapped.Point = this->Plane.Frame.ToWorld({ column + 0.5, Row + 0.5 });
    mapped.Point[2] += height;
    mapped.Direction = { 0.0, 0.0, -1.0 };
    mapped.Range = 2.0;
    mapped.BeamId = column;
    mapped.Triangle = 0;
    mapped.Scan = 0;
    this->Planes.AddBeside(0, mapped);
  }

  /// Sets or clears the shape of the region in a square around the row.
  void SetShape(bool value)
  {
    for (std::int32_t row = 5; row < 25; ++row)
    {
      this->Plane.Raster.Set(&lms3dRasterBlock::Shape, MakeStrip(row, 5, 24), value);
    }
  }

  const lms3dFusedTile& MakeMesh()
  {
    lms3dFusedTile& tile = this->Plane.Tiles.front();
    lms3dMakeTileMesh(this->Plane, tile, {}, Bound);
    this->Plane.Raster.ClearMarks();
    return tile;
  }

  bool HasBeside(std::int32_t column) const
  {
    return this->Plane.Raster.Has(&lms3dRasterBlock::Beside, column, Row);
  }

  lms3dFusedPlanes Planes{ Bound };
  lms3dFusedPlane& Plane;
};
} // namespace

TEST(LMS3DFusedFacets, AreAtReturnsThatNoLaterMeshCovers)
{
  SmallPlane scene;
  scene.SetShape(true);
  scene.MakeMesh();
  scene.AddBeside(15);
  EXPECT_TRUE(scene.MakeMesh().Facets.empty());
  EXPECT_FALSE(scene.MakeMesh().Mesh.Triangles.empty());
  scene.SetShape(false);
  const lms3dFusedTile& tile = scene.MakeMesh();
  EXPECT_EQ(tile.Facets, (std::vector<lms3dFusedTile::Cell>{ { 15, Row } }));
  EXPECT_EQ(tile.Mesh.Triangles.size(), 1U);
}

/// A beam passed beside the region, so the region ends there. A cell beside it has a return that
/// the region explains, although another return of the block is much farther from the plane.
TEST(LMS3DFusedFacets, AreAtReturnsThatAreTooFarThemselves)
{
  for (const double height : { 0.6 * Bound, 0.8 * Bound })
  {
    SmallPlane scene;
    scene.SetShape(true);
    for (std::int32_t row = 0; row < 40; ++row)
    {
      scene.Plane.Raster.Pass(0, 25, row);
    }
    for (std::int32_t row = 5; row < 25; ++row)
    {
      scene.Plane.Raster.Set(&lms3dRasterBlock::Must, MakeStrip(row, 5, 23), true);
    }
    scene.MakeMesh();
    scene.AddBeside(15, 0.95 * Bound);
    scene.AddBeside(25, height);
    const bool isFar = height > 0.7 * Bound;
    EXPECT_EQ(scene.Plane.Raster.HasMark(0, lms3dRaster::STALE), isFar);
    EXPECT_EQ(scene.MakeMesh().Facets.size(), isFar ? 1U : 0U);
  }
}

TEST(LMS3DFusedFacets, GoWithReturnsThatAreForgotten)
{
  SmallPlane scene;
  scene.AddBeside(15);
  EXPECT_EQ(scene.MakeMesh().Mesh.Triangles.size(), 1U);
  scene.Plane.Raster.Forget(MakeStrip(Row, 16, 20));
  EXPECT_FALSE(scene.Plane.Raster.HasMark(0, lms3dRaster::STALE));
  scene.Plane.Raster.Pass(0, 15, Row);
  scene.Plane.Raster.Forget(MakeStrip(Row, 15, 15));
  EXPECT_TRUE(scene.Plane.Raster.HasMark(0, lms3dRaster::STALE));
  EXPECT_TRUE(scene.MakeMesh().Mesh.Triangles.empty());
}

TEST(LMS3DFusedFacets, StayIfOtherReturnsAreForgotten)
{
  SmallPlane scene;
  scene.AddBeside(15);
  scene.AddBeside(40);
  scene.Plane.DropForgotten();
  ASSERT_EQ(scene.Plane.Returns.size(), 2U);
  scene.Plane.Raster.Forget(MakeStrip(Row, 40, 40));
  EXPECT_TRUE(scene.HasBeside(15));
  EXPECT_FALSE(scene.HasBeside(40));
  scene.Plane.DropForgotten();
  ASSERT_EQ(scene.Plane.Returns.size(), 1U);
  EXPECT_EQ(scene.Plane.Returns.front().BeamId, 15);
  EXPECT_EQ(scene.MakeMesh().Facets, (std::vector<lms3dFusedTile::Cell>{ { 15, Row } }));
}

/// The region of a plane is the triangle of a local map. A return was covered by an earlier mesh.
TEST(LMS3DFusedFacets, AreBesideTrianglesOfLocalMaps)
{
  for (const std::int32_t column : { 10, 24 })
  {
    SmallPlane scene;
    const lms3dPlaneFrame& frame = scene.Plane.Frame;
    scene.Plane.Verbatim.push_back(
      { frame.ToWorld({ 5.0, 5.0 }), frame.ToWorld({ 25.0, 5.0 }), frame.ToWorld({ 5.0, 25.0 }) });
    scene.Plane.Raster.Set(&lms3dRasterBlock::Must, MakeStrip(Row, 8, 8), true);
    scene.AddBeside(column);
    const lms3dFusedTile& tile = scene.MakeMesh();
    EXPECT_EQ(tile.Facets.size(), column == 24 ? 1U : 0U);
    EXPECT_EQ(tile.Mesh.Triangles.size(), column == 24 ? 2U : 1U);
  }
}

/// The triangle has no cell's centre, but its returns lie on it.
TEST(LMS3DFusedFacets, AreNotOnTrianglesOfLocalMaps)
{
  SmallPlane scene;
  const lms3dPlaneFrame& frame = scene.Plane.Frame;
  scene.Plane.Verbatim.push_back(
    { frame.ToWorld({ 5.1, 5.1 }), frame.ToWorld({ 5.3, 5.1 }), frame.ToWorld({ 5.1, 5.3 }) });
  scene.Plane.Raster.Set(&lms3dRasterBlock::Must, MakeStrip(5, 5, 5), true);
  EXPECT_EQ(scene.MakeMesh().Mesh.Triangles.size(), 1U);
}
