// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks a map of scans along the corridor of the closed building against the building itself:
 * scans from afar see its ends at grazing incidence, so their local maps guess surface outside of
 * it.
 */
#include "Fixtures/TriangleTree.h"
#include "Fusion/FusionFixtures.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace
{
constexpr double MaximumError = 0.01;
// Metres: the distance of samples on a triangle.
constexpr double Spacing = 0.2;
// Metres: the corners of the building with the niches of its windows.
constexpr Vector Low = { -12.14, -8.14, 0.0 };
constexpr Vector High = { 12.0, 7.34, 3.6 };

/// From both ends of the corridor, and from rooms with tables, shelves and columns, all poses moved
/// by an offset.
std::vector<MappedScan> ScanBuilding(vtkPolyData* building, const Point& offset = { 0.0, 0.0, 0.0 })
{
  std::vector<MappedScan> scans;
  for (const Point& position : std::vector<Point>{ { 10.5, 0.0, 1.2 }, { 4.0, 0.2, 1.2 },
         { -4.0, 0.0, 1.2 }, { -10.5, 0.0, 1.2 }, { -6.5, -3.5, 1.2 }, { 8.0, 3.5, 1.2 } })
  {
    scans.push_back(MakeMappedScan(building, lms3dAdd(position, offset)));
  }
  return scans;
}

struct Falsehood
{
  /// Square metres of all triangles, and of samples farther than 0.1 m from the scene.
  double Area = 0.0;
  double FarArea = 0.0;
  /// Metres: how far a corner lies outside of the building.
  double Outside = 0.0;
};

/// Adds samples on one triangle.
void AddTriangle(
  const std::array<Vector, 3>& corners, const TriangleTree& scene, Falsehood& falsehood)
{
  const Vector u = lms3dSubtract(corners[1], corners[0]);
  const Vector v = lms3dSubtract(corners[2], corners[0]);
  const double area = 0.5 * lms3dGetLength(lms3dCross(u, v));
  const double longest = std::max({ lms3dGetLength(u), lms3dGetLength(v),
    lms3dGetLength(lms3dSubtract(corners[1], corners[2])) });
  const int count = 1 + static_cast<int>(longest / Spacing);
  const double share = area / (count * count);
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < 2 * (count - i) - 1; ++j)
    {
      const double third = j % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0;
      const int pair = j / 2;
      const double along = (i + third) / count;
      const double across = (pair + third) / count;
      const Vector sample =
        lms3dAdd(corners[0], lms3dAdd(lms3dScale(u, along), lms3dScale(v, across)));
      falsehood.FarArea += scene.GetDistance(sample, 0.2) > 0.1 ? share : 0.0;
    }
  }
  falsehood.Area += area;
  for (const Vector& corner : corners)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      falsehood.Outside =
        std::max({ falsehood.Outside, Low[axis] - corner[axis], corner[axis] - High[axis] });
    }
  }
}

Falsehood FindFalsehood(vtkPolyData* map, vtkPolyData* building)
{
  const TriangleTree scene = MakeTree(building, { 0.0, 0.0, 0.0 });
  const TriangleTree triangles = MakeTree(map, { 0.0, 0.0, 0.0 });
  Falsehood falsehood;
  for (std::size_t i = 0; i < triangles.GetNumberOfTriangles(); ++i)
  {
    AddTriangle(triangles.GetCorners(i), scene, falsehood);
  }
  return falsehood;
}
} // namespace

TEST(LMS3DFusedBuilding, HasLittleSurfaceFarFromTheBuilding)
{
  const vtkSmartPointer<vtkPolyData> building = ReadBuilding();
  const std::vector<MappedScan> scans = ScanBuilding(building);
  vtkNew<vtkLMS3DMapFusion> fusion;
  AddAll(scans, fusion);
  fusion->Update();
  const Falsehood fused = FindFalsehood(fusion->GetOutput(), building);
  RecordProperty("FarArea", std::to_string(fused.FarArea));
  RecordProperty("Outside", std::to_string(fused.Outside));
  EXPECT_GT(fused.Area, 600.0);
  EXPECT_LT(fused.FarArea, 9.0);
  EXPECT_LT(fused.Outside, 2.0);
  const FusionVerdict verdict = JudgeFusion(fusion->GetOutput(), scans, MaximumError);
  EXPECT_EQ(verdict.Beyond, 0) << verdict.LargestDistance;
  EXPECT_EQ(verdict.Blocked, 0);
}

TEST(LMS3DFusedBuilding, DoesNotDependOnThreadsIfItForgets)
{
  const vtkSmartPointer<vtkPolyData> building = ReadBuilding();
  std::vector<MappedScan> scans = ScanBuilding(building);
  const std::vector<MappedScan> more = ScanBuilding(building, { 0.4, 0.3, 0.2 });
  scans.insert(scans.end(), more.begin(), more.end());
  const auto fuse = [&](int threads)
  {
    vtkNew<vtkLMS3DMapFusion> fusion;
    fusion->SetForgetSeenThrough(true);
    fusion->SetNumberOfThreads(threads);
    AddAll(scans, fusion);
    fusion->Update();
    return Hash(fusion->GetOutput());
  };
  const std::uint64_t expected = fuse(1);
  EXPECT_EQ(fuse(2), expected);
  EXPECT_EQ(fuse(5), expected);
}
