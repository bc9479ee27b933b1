// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that a map which grows scan by scan has the cells and triangles of a map that is made at
 * once from what all scans saw.
 */
#include "Fixtures/SceneBuilder.h"
#include "Fusion/FusionFixtures.h"
#include "Fusion/Planes/lms3dCreases.h"
#include "Fusion/Planes/lms3dRegionMesher.h"
#include "Fusion/Planes/lms3dRegionSightings.h"
#include "Fusion/lms3dGrowingMap.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace
{
constexpr double MaximumError = 0.01;

/// How a map differs from one that is made at once.
struct Differences
{
  int Blocks = 0;
  int BlocksThatDiffer = 0;
  /// Blocks that say wrongly whether all of their bits are set.
  int WrongBlocks = 0;
  /// Tiles whose triangles were made with the last scan.
  int Tiles = 0;
  int TilesThatDiffer = 0;
};

/// A plane with the cells of another one, whose shape is made at once.
void MakeAtOnce(const lms3dFusedPlanes& planes, std::size_t number, lms3dFusedPlane& made)
{
  const lms3dFusedPlane& plane = planes[number];
  made.Raster = plane.Raster;
  made.Verbatim = plane.Verbatim;
  made.IsWeak = plane.IsWeak;
  made.Raster.ClearMarks();
  for (int i = 0; i < made.Raster.GetNumberOfBlocks(); ++i)
  {
    lms3dRasterBlock& block = made.Raster.GetBlock(i);
    block.Shape = {};
    made.Raster.SetMark(i, lms3dRaster::DIRTY);
  }
  made.Shape.Update(lms3dGetCreaseLines(planes, static_cast<int>(number)), made.Raster);
}

bool IsSame(const lms3dFusedMesh& a, const lms3dFusedMesh& b)
{
  bool isSame = a.Points == b.Points && a.Triangles == b.Triangles;
  for (std::size_t i = 0; isSame && i < a.Triangles.size(); ++i)
  {
    isSame = a.Sightings[i].BestScan == b.Sightings[i].BestScan &&
      a.Sightings[i].ScanCount == b.Sightings[i].ScanCount &&
      a.Sightings[i].LastScan == b.Sightings[i].LastScan;
  }
  return isSame;
}

bool SaysRightly(const lms3dRasterBlock& block)
{
  const auto isFull = [](const lms3dBits& bits) { return bits == lms3dAllBits; };
  return block.IsFull == isFull(block.May) && block.IsShapeFull == isFull(block.Shape) &&
    block.IsMeshedFull == isFull(block.Meshed) &&
    block.IsAllCovered == (isFull(block.Covered) && isFull(block.Touched)) &&
    block.HasPassed == (block.Passed != lms3dNoBits) &&
    block.HasOpen == (block.Open != lms3dNoBits);
}

Differences Compare(const lms3dGrowingMap& map)
{
  Differences result;
  const lms3dFusedPlanes& planes = map.GetPlanes();
  for (std::size_t number = 0; number < planes.GetSize(); ++number)
  {
    const lms3dFusedPlane& plane = planes[number];
    lms3dFusedPlane made(plane.Frame);
    MakeAtOnce(planes, number, made);
    for (int i = 0; i < plane.Raster.GetNumberOfBlocks(); ++i)
    {
      ++result.Blocks;
      result.BlocksThatDiffer +=
        plane.Raster.GetBlock(i).Shape == made.Raster.GetBlock(i).Shape ? 0 : 1;
      result.WrongBlocks += SaysRightly(plane.Raster.GetBlock(i)) ? 0 : 1;
    }
    for (const lms3dFusedTile& tile : plane.Tiles)
    {
      if (tile.Revision != map.GetNumberOfScans())
      {
        continue;
      }
      lms3dFusedTile anew = tile;
      lms3dMakeTileMesh(
        made, anew, lms3dGetCreaseLines(planes, static_cast<int>(number)), MaximumError);
      lms3dSetSightings(made, anew);
      ++result.Tiles;
      result.TilesThatDiffer += IsSame(tile.Mesh, anew.Mesh) ? 0 : 1;
    }
  }
  return result;
}

/// Adds scans, and compares after each of them.
void ExpectMapsMadeAtOnce(const std::vector<MappedScan>& scans, bool forgets)
{
  lms3dGrowingMap map({ MaximumError, true, forgets });
  for (std::size_t i = 0; i < scans.size(); ++i)
  {
    ASSERT_TRUE(map.Add(scans[i].Map, scans[i].Scan, [](double) { return true; }));
    const Differences differences = Compare(map);
    EXPECT_GT(differences.Blocks, 0);
    EXPECT_GT(differences.Tiles, 0);
    EXPECT_EQ(differences.WrongBlocks, 0);
    EXPECT_EQ(differences.BlocksThatDiffer, 0)
      << "of " << differences.Blocks << " after scan " << i;
    EXPECT_EQ(differences.TilesThatDiffer, 0) << "of " << differences.Tiles << " after scan " << i;
  }
}
} // namespace

TEST(LMS3DFusedShapes, AreThoseOfARoomMadeAtOnce)
{
  ExpectMapsMadeAtOnce(ScanRoom(), false);
}

TEST(LMS3DFusedShapes, AreThoseOfNoisyScansMadeAtOnce)
{
  std::vector<MappedScan> scans = ScanRoom(true, 0.002);
  scans.resize(3);
  ExpectMapsMadeAtOnce(scans, false);
}

TEST(LMS3DFusedShapes, AreThoseOfABuildingMadeAtOnce)
{
  const vtkSmartPointer<vtkPolyData> building = ReadBuilding();
  std::vector<MappedScan> scans;
  for (const Point& position : std::vector<Point>{ { 10.5, 0.0, 1.2 }, { 9.8, 0.1, 1.2 },
         { 4.0, 0.2, 1.2 }, { -4.0, 0.0, 1.2 }, { -6.5, -3.5, 1.2 } })
  {
    scans.push_back(MakeMappedScan(building, position, false));
  }
  ExpectMapsMadeAtOnce(scans, false);
}

// A box goes away and comes back elsewhere.
TEST(LMS3DFusedShapes, AreThoseOfAMapThatForgetsMadeAtOnce)
{
  std::vector<MappedScan> scans;
  const std::vector<double> places = { 1.0, -2.0, 0.5 };
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    SceneBuilder scene;
    scene.AddBox({ -3.0, -3.0, 0.0 }, { 3.0, 3.0, 2.5 });
    scene.AddBox({ places[i], 0.5, 0.0 }, { places[i] + 1.0, 1.5, 1.5 });
    scans.push_back(
      MakeMappedScan(scene.GetSurface(), { -1.0 + 0.3 * static_cast<double>(i), -1.0, 1.2 }));
  }
  ExpectMapsMadeAtOnce(scans, true);
}
