// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that the raster of a scan is bounded by the number of its returns, and that the map keeps
 * its laws then.
 */
#include "Fixtures/SceneBuilder.h"
#include "Fusion/FusionFixtures.h"
#include "Fusion/lms3dGrowingMap.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkNew.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
/// A floor around the point below the sensor.
void AddFloor(double half, SceneBuilder& scene)
{
  scene.AddQuad(
    { -half, -half, 0.0 }, { half, -half, 0.0 }, { half, half, 0.0 }, { -half, half, 0.0 });
}

/// A floor of 6 x 6 m, a wall at a distance, and behind the sensor a thing that one beam meets.
vtkSmartPointer<vtkPolyData> MakeFarScene(double distance)
{
  SceneBuilder scene;
  AddFloor(3.0, scene);
  const double half = 0.3 * distance;
  scene.AddQuad({ distance, half, 0.0 }, { distance, -half, 0.0 }, { distance, -half, half },
    { distance, half, half });
  const double small = 0.01 * distance;
  scene.AddQuad({ -distance, -small, -small }, { -distance, small, -small },
    { -distance, small, small }, { -distance, -small, small });
  return scene.GetSurface();
}

/// With 91 x 90 beams.
MappedScan ScanFar(vtkPolyData* scene, const Point& position, double maximumError)
{
  vtkNew<vtkLMS3DScanFilter> scanner;
  scanner->SetInputData(scene);
  scanner->SetPosition(position[0], position[1], position[2]);
  scanner->SetAlphaResolution(91);
  scanner->SetBetaResolution(90);
  scanner->SetMaximumRange(1e9);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> mapper;
  mapper->SetInputConnection(scanner->GetOutputPort());
  mapper->SetMaximumError(maximumError);
  mapper->Update();
  return { scanner->GetOutput(), mapper->GetOutput() };
}

/// Scans of two poses, and what becomes of them.
struct TwoScans
{
  TwoScans(vtkPolyData* scene, double maximumError)
    : Map({ maximumError, true, false })
  {
    this->Fusion->SetMaximumError(maximumError);
    for (const double x : { 0.0, 0.7 })
    {
      this->Scans.push_back(ScanFar(scene, { x, 0.1, 1.0 }, maximumError));
      EXPECT_TRUE(this->Map.Add(
        this->Scans.back().Map, this->Scans.back().Scan, [](double) { return true; }));
      this->Returns += static_cast<int>(this->Scans.back().Scan->GetNumberOfPoints());
    }
    AddAll(this->Scans, this->Fusion);
    this->Fusion->Update();
    this->Verdict = JudgeFusion(this->Fusion->GetOutput(), this->Scans, maximumError);
  }

  int CountBlocks() const
  {
    int blocks = 0;
    for (const lms3dFusedPlane& plane : this->Map.GetPlanes().GetAll())
    {
      blocks += plane.Raster.GetNumberOfBlocks();
    }
    return blocks;
  }

  std::vector<MappedScan> Scans;
  lms3dGrowingMap Map;
  vtkNew<vtkLMS3DMapFusion> Fusion;
  int Returns = 0;
  FusionVerdict Verdict;
};
} // namespace

// With a raster of all triangles, the map has more than a hundred million blocks at 5 km.
TEST(LMS3DSparseParts, HaveFewBlocksFarAway)
{
  for (const double distance : { 5e3, 2e4, 1e6 })
  {
    const TwoScans scans(MakeFarScene(distance), 0.01);
    // The floor has 800 blocks.
    EXPECT_LT(scans.CountBlocks(), 1500) << distance;
    EXPECT_EQ(scans.Verdict.Beyond, 0) << distance << ": " << scans.Verdict.LargestDistance;
    EXPECT_GT(scans.Verdict.Returns, scans.Returns - 10);
    for (const MappedScan& scan : scans.Scans)
    {
      EXPECT_GT(scan.Scan->GetBounds()[1], 0.999 * distance);
      EXPECT_LT(scan.Scan->GetBounds()[0], -0.999 * distance);
    }
  }
}

TEST(LMS3DSparseParts, BlockNoBeams)
{
  const TwoScans scans(MakeFarScene(5e3), 0.01);
  EXPECT_EQ(scans.Verdict.Blocked, 0);
}

// The whole floor needs 88 million blocks.
TEST(LMS3DSparseParts, KeepTheirSurfaceWhereReturnsAreNear)
{
  SceneBuilder scene;
  AddFloor(1000.0, scene);
  const TwoScans scans(scene.GetSurface(), 0.01);
  EXPECT_LT(scans.CountBlocks(), 64 * scans.Returns);
  EXPECT_EQ(scans.Verdict.Beyond, 0) << scans.Verdict.LargestDistance;
  EXPECT_EQ(scans.Verdict.Blocked, 0);
  const TriangleTree tree = MakeTree(scans.Fusion->GetOutput(), { 0.0, 0.1, 0.0 });
  for (int i = 0; i < 36; ++i)
  {
    const double angle = 0.17 * i;
    for (const double radius : { 0.5, 1.0, 2.0, 3.0 })
    {
      const Vector place = { radius * std::cos(angle), radius * std::sin(angle), 0.0 };
      EXPECT_LT(tree.GetDistance(place, 1.0), 0.01) << angle << " " << radius;
    }
  }
}

// The room needs billions of blocks.
TEST(LMS3DSparseParts, HaveFewBlocksWithSmallBounds)
{
  const TwoScans scans(ReadRoom(), 1e-5);
  EXPECT_LT(scans.CountBlocks(), 2 * scans.Returns);
  EXPECT_EQ(scans.Verdict.Beyond, 0) << scans.Verdict.LargestDistance;
}

TEST(LMS3DSparseParts, DoNotDependOnThreads)
{
  const TwoScans scans(MakeFarScene(2e4), 0.01);
  vtkNew<vtkLMS3DMapFusion> single;
  single->SetNumberOfThreads(1);
  AddAll(scans.Scans, single);
  single->Update();
  vtkPolyData* const map = single->GetOutput();
  vtkPolyData* const other = scans.Fusion->GetOutput();
  ASSERT_EQ(map->GetNumberOfPoints(), other->GetNumberOfPoints());
  ASSERT_EQ(map->GetNumberOfPolys(), other->GetNumberOfPolys());
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    Vector a;
    Vector b;
    map->GetPoint(i, a.data());
    other->GetPoint(i, b.data());
    EXPECT_EQ(a, b);
  }
}
