// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that openings into the open stay open: no triangle of a fused map lies where a beam left
 * that is known to have met nothing. Lost beams open nothing.
 */
#include "Fixtures/ScanDamage.h"
#include "Fixtures/SceneBuilder.h"
#include "Fixtures/TriangleTree.h"
#include "Fusion/FusionFixtures.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{
constexpr double Bound = 0.02;
// Metres: the wall with the windows is a square around the y-axis.
constexpr double Distance = 2.0;
constexpr double HalfSize = 1.5;
constexpr int AlphaResolution = 361;
constexpr int BetaResolution = 360;
const std::vector<Point> Poses = { { 0.013, 0.0, 0.011 }, { 0.3, 0.2, 0.1 }, { -0.25, 0.1, -0.2 } };

/// A square window. Metres.
struct Window
{
  double Left;
  double Size;
};

/// Windows of 2 to 12 bounds beside one another, with their lower sides at z = 0.
std::vector<Window> GetWindows()
{
  std::vector<Window> windows;
  double left = -1.3;
  for (const double bounds : { 2.0, 3.0, 5.0, 8.0, 10.0, 11.0, 12.0 })
  {
    windows.push_back({ left, bounds * Bound });
    left += bounds * Bound + 0.2;
  }
  return windows;
}

void AddWall(double left, double right, double bottom, double top, double y, SceneBuilder& scene)
{
  scene.AddQuad({ left, y, bottom }, { right, y, bottom }, { right, y, top }, { left, y, top });
}

/// The wall with the windows.
SceneBuilder MakeWall()
{
  SceneBuilder scene;
  double left = -HalfSize;
  for (const Window& window : GetWindows())
  {
    const double right = window.Left + window.Size;
    AddWall(left, window.Left, -HalfSize, HalfSize, Distance, scene);
    AddWall(window.Left, right, -HalfSize, 0.0, Distance, scene);
    AddWall(window.Left, right, window.Size, HalfSize, Distance, scene);
    left = right;
  }
  AddWall(left, HalfSize, -HalfSize, HalfSize, Distance, scene);
  return scene;
}

std::vector<vtkSmartPointer<vtkPolyData>> Scan(
  vtkPolyData* scene, bool hasStatus, double maximumRange = 80.0)
{
  std::vector<vtkSmartPointer<vtkPolyData>> scans;
  for (const Point& pose : Poses)
  {
    vtkNew<vtkLMS3DScanFilter> scanner;
    scanner->SetInputData(scene);
    scanner->SetPosition(pose[0], pose[1], pose[2]);
    SetGrid(scanner, AlphaResolution, BetaResolution);
    scanner->SetComputeStatus(hasStatus);
    scanner->SetMaximumRange(maximumRange);
    scanner->Update();
    scans.emplace_back(scanner->GetOutput());
  }
  return scans;
}

vtkSmartPointer<vtkPolyData> Fuse(
  const std::vector<vtkSmartPointer<vtkPolyData>>& scans, int maximumGapSize)
{
  vtkNew<vtkLMS3DMapFusion> fusion;
  fusion->SetMaximumError(Bound);
  for (const vtkSmartPointer<vtkPolyData>& scan : scans)
  {
    vtkNew<vtkLMS3DSurfaceReconstructionFilter> mapper;
    mapper->SetInputData(scan);
    mapper->SetMaximumError(Bound);
    mapper->SetMaximumGapSize(maximumGapSize);
    mapper->Update();
    EXPECT_TRUE(fusion->AddScan(mapper->GetOutput(), scan));
  }
  fusion->Update();
  return fusion->GetOutput();
}

/// What the map has where beams have no return.
struct Unreturned
{
  int Blocked = 0;
  int Free = 0;
  /// The same of beams that pass through the windows: for each window.
  std::vector<int> BlockedInWindow = std::vector<int>(GetWindows().size());
  std::vector<int> FreeInWindow = std::vector<int>(GetWindows().size());
};

/// The number of the window through which a beam passes, -1 if there is none.
int FindWindow(const Point& position, const Point& direction)
{
  const double share = (Distance - position[1]) / direction[1];
  const double x = position[0] + share * direction[0];
  const double z = position[2] + share * direction[2];
  const std::vector<Window> windows = GetWindows();
  const auto found = std::find_if(windows.begin(), windows.end(),
    [&](const Window& window)
    {
      return share > 0.0 && z > 0.0 && z < window.Size && x > window.Left &&
        x < window.Left + window.Size;
    });
  return found == windows.end() ? -1 : static_cast<int>(found - windows.begin());
}

/// Counts the beams of a scan that have no return.
void Count(vtkPolyData* scan, const Point& position, vtkPolyData* map, Unreturned& beams)
{
  const TriangleTree tree = MakeTree(map, position);
  std::vector<bool> hasReturn(AlphaResolution * BetaResolution);
  vtkDataArray* const ids = scan->GetPointData()->GetArray("BeamId");
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    hasReturn[static_cast<std::size_t>(ids->GetTuple1(i))] = true;
  }
  vtkDataArray* const alpha = scan->GetFieldData()->GetArray("AlphaAngles");
  vtkDataArray* const beta = scan->GetFieldData()->GetArray("BetaAngles");
  std::vector<TriangleTree::Hit> hits;
  for (int id = 0; id < AlphaResolution * BetaResolution; ++id)
  {
    if (hasReturn[id])
    {
      continue;
    }
    const Point direction = GetPaperDirection(
      alpha->GetTuple1(id % AlphaResolution), beta->GetTuple1(id / AlphaResolution));
    hits.clear();
    tree.Cast(direction, 0.0, hits);
    const int isBlocked = hits.empty() ? 0 : 1;
    beams.Blocked += isBlocked;
    beams.Free += 1 - isBlocked;
    if (const int window = FindWindow(position, direction); window >= 0)
    {
      beams.BlockedInWindow[window] += isBlocked;
      beams.FreeInWindow[window] += 1 - isBlocked;
    }
  }
}

Unreturned Count(const std::vector<vtkSmartPointer<vtkPolyData>>& scans, vtkPolyData* map)
{
  Unreturned beams;
  for (std::size_t i = 0; i < scans.size(); ++i)
  {
    Count(scans[i], Poses[i], map, beams);
  }
  return beams;
}

/// Expects that no beam without a return is blocked, and that beams passed all windows.
void ExpectOpen(const std::vector<vtkSmartPointer<vtkPolyData>>& scans, int maximumGapSize)
{
  const Unreturned beams = Count(scans, Fuse(scans, maximumGapSize));
  EXPECT_EQ(beams.Blocked, 0);
  for (std::size_t window = 0; window < beams.FreeInWindow.size(); ++window)
  {
    EXPECT_GT(beams.FreeInWindow[window], 0) << window;
    EXPECT_EQ(beams.BlockedInWindow[window], 0) << window;
  }
}
} // namespace

TEST(LMS3DFusedOpenings, StayOpenWithoutStatus)
{
  const auto scans = Scan(MakeWall().GetSurface(), false);
  for (const int maximumGapSize : { -1, 0 })
  {
    ExpectOpen(scans, maximumGapSize);
  }
}

TEST(LMS3DFusedOpenings, StayOpenWhereBeamsMetNothing)
{
  const auto scans = Scan(MakeWall().GetSurface(), true);
  for (const int maximumGapSize : { -1, 0 })
  {
    ExpectOpen(scans, maximumGapSize);
  }
}

/// A second wall behind the windows is out of the range.
TEST(LMS3DFusedOpenings, StayOpenWhereSurfaceIsBeyondTheRange)
{
  SceneBuilder scene = MakeWall();
  AddWall(-30.0, 30.0, -30.0, 30.0, 10.0, scene);
  ExpectOpen(Scan(scene.GetSurface(), true, 5.0), -1);
}

/// Without Status, beams without a return may have been lost if the local map closes gaps.
TEST(LMS3DFusedOpenings, CloseIfBeamsMayHaveBeenLost)
{
  const auto scans = Scan(MakeWall().GetSurface(), false);
  const Unreturned beams = Count(scans, Fuse(scans, 1));
  for (std::size_t window = 0; window < 6; ++window)
  {
    EXPECT_GT(beams.BlockedInWindow[window], 0) << window;
    EXPECT_EQ(beams.FreeInWindow[window], 0) << window;
  }
}

/// Beams whose returns were too weak open no hole in a wall, even if the local maps have holes
/// there.
TEST(LMS3DFusedOpenings, AreNoneWhereReturnsWereTooWeak)
{
  SceneBuilder scene;
  AddWall(-HalfSize, HalfSize, -HalfSize, HalfSize, Distance, scene);
  const auto whole = Scan(scene.GetSurface(), true);
  std::vector<vtkSmartPointer<vtkPolyData>> damaged;
  for (const auto& scan : whole)
  {
    ScanDamage damage;
    damage.Dropouts = 0.05;
    damage.Shape = ScanDamage::Shapes::Blobs;
    damage.Seed = static_cast<int>(damaged.size());
    damaged.push_back(Damage(scan, damage));
    EXPECT_LT(damaged.back()->GetNumberOfPoints(), scan->GetNumberOfPoints());
  }
  const vtkSmartPointer<vtkPolyData> map = Fuse(damaged, 0);
  const Unreturned lost = Count(damaged, map);
  const Unreturned open = Count(whole, map);
  EXPECT_EQ(open.Blocked, 0);
  const int returnsThatWereLost = lost.Blocked + lost.Free - open.Free;
  EXPECT_GT(lost.Blocked, 1000);
  EXPECT_LE(returnsThatWereLost - lost.Blocked, returnsThatWereLost / 100);
}
