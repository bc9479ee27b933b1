// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What vtkLMS3DMapComparison measures, on surfaces with known errors.
 */
#include "Comparison/ComparisonFixtures.h"

#include "Geometry/lms3dAngle.h"

#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkReverseSense.h>
#include <vtkTransform.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace
{
// The error of an area's share that 200,000 evenly spread samples measure.
constexpr double ShareError = 1e-3;

// The rounding error of a sum of 200,000 equal numbers.
constexpr double SumError = 1e-13;

vtkSmartPointer<vtkPolyData> Reverse(vtkPolyData* surface)
{
  vtkNew<vtkReverseSense> reverse;
  reverse->SetInputData(surface);
  reverse->Update();
  return reverse->GetOutput();
}

/// The inside of a cube of 4 m about the origin, with or without its ceiling at +z.
vtkSmartPointer<vtkPolyData> MakeCube(bool hasCeiling)
{
  vtkSmartPointer<vtkPolyData> cube = hasCeiling ? MakeFloor(2.0, 2.0) : MakePolygon({});
  for (const Point& turn : { Point{ 0, 0, 0 }, Point{ 90, 0, 0 }, Point{ -90, 0, 0 },
         Point{ 0, 90, 0 }, Point{ 0, -90, 0 } })
  {
    vtkNew<vtkTransform> transform;
    transform->RotateX(turn[0]);
    transform->RotateY(turn[1]);
    cube = Join(cube, Transform(MakeFloor(2.0, -2.0), transform));
  }
  return cube;
}
} // namespace

TEST(LMS3DMapComparison, FindsNothingWrongWithTheSceneItself)
{
  Comparison comparison(MakeCube(true), MakeCube(true), Point{ 0.3, -0.2, 0.1 });
  comparison.ExpectErrors("MapToScene", { 0.0, 0.0, 0.0, 0.0 }, 1e-15);
  comparison.ExpectErrors("SceneToMap", { 0.0, 0.0, 0.0, 0.0 }, 1e-15);
  EXPECT_EQ(comparison.Update()->GetCorrectness(), 1.0);
  EXPECT_EQ(comparison.Update()->GetCompleteness(), 1.0);
  EXPECT_EQ(comparison.Update()->GetFScore(), 1.0);
  EXPECT_EQ(comparison.Update()->GetAreaInFreeSpace(), 0.0);
  EXPECT_EQ(comparison.Update()->GetMapTriangles(), 12.0);
  EXPECT_NEAR(comparison.Update()->GetMapArea(), 96.0, 1e-9);
  EXPECT_NEAR(comparison.Update()->GetVisibleArea(), 96.0, 1e-9);
}

TEST(LMS3DMapComparison, MeasuresAShiftedPlane)
{
  for (double height : { 0.03, -0.03 })
  {
    Comparison comparison(MakeFloor(2.0, height), MakeFloor(2.0, 0.0), Point{ 0.1, 0.2, 1.0 });
    comparison.ExpectErrors("MapToScene", { 0.03, 0.03, 0.03, 0.03 }, SumError);
    comparison.ExpectErrors("SceneToMap", { 0.03, 0.03, 0.03, 0.03 }, SumError);
    comparison.ExpectErrors("NormalError", { 0.0, 0.0, 0.0, 0.0 }, 1e-12);
    EXPECT_EQ(comparison.Update()->GetCorrectness(), 0.0);
    EXPECT_EQ(comparison.Update()->GetCompleteness(), 0.0);
    EXPECT_EQ(comparison.Update()->GetFScore(), 0.0);
    // The sensor has seen that the space above the floor is empty. It does not see below the floor.
    EXPECT_NEAR(comparison.Update()->GetAreaInFreeSpace(), height > 0.0 ? 16.0 : 0.0, 1e-9);
    comparison.Filter->SetTolerance(0.031);
    EXPECT_EQ(comparison.Update()->GetCorrectness(), 1.0);
    EXPECT_EQ(comparison.Update()->GetCompleteness(), 1.0);
    EXPECT_EQ(comparison.Update()->GetAreaInFreeSpace(), 0.0);
  }
}

TEST(LMS3DMapComparison, MeasuresATiltedPlane)
{
  vtkNew<vtkTransform> tilt;
  tilt->RotateY(3.0);
  Comparison comparison(
    Transform(MakeFloor(1.0, 0.0), tilt), MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 5.0 });
  const double sine = std::sin(3.0 * lms3dRadiansPerDegree);
  comparison.ExpectErrors("MapToScene",
    { 0.5 * sine, std::sqrt(1.0 / 3.0) * sine, 0.95 * sine, sine }, ShareError * sine);
  comparison.ExpectErrors("NormalError", { 3.0, 3.0, 3.0, 3.0 }, 1e-9);
  EXPECT_NEAR(comparison.Update()->GetCorrectness(), 0.01 / sine, ShareError);
}

TEST(LMS3DMapComparison, MeasuresALargerBall)
{
  const double facet = GetInradius(MakeBall(1.0));
  Comparison comparison(Reverse(MakeBall(2.1)), MakeBall(2.0), Point{ 0.0, 0.0, 0.0 });
  // The facets are parallel, and 0.1 m apart at their vertices.
  EXPECT_GE(comparison.Update()->GetMapToSceneMean(), 0.1 * facet - 1e-7);
  EXPECT_LE(comparison.Update()->GetMapToSceneMaximum(), 0.1 + 1e-7);
  EXPECT_GE(comparison.Update()->GetSceneToMapMean(), 0.1 * facet - 1e-7);
  EXPECT_LE(comparison.Update()->GetSceneToMapMaximum(), 0.1 + 1e-7);
  EXPECT_EQ(comparison.Update()->GetAreaInFreeSpace(), 0.0);
  // The angle between facets that share a corner.
  EXPECT_LT(comparison.Update()->GetNormalErrorMaximum(), std::hypot(360.0 / 48.0, 180.0 / 47.0));

  Comparison smaller(MakeBall(1.9), MakeBall(2.0), Point{ 0.0, 0.0, 0.0 });
  EXPECT_NEAR(smaller.Update()->GetAreaInFreeSpace(), smaller.Update()->GetMapArea(), 1e-9);
}

// In a square of side a, the distance of a point from the border has the mean a / 6 and the mean
// square a^2 / 24. It exceeds x in the share (1 - 2 x / a)^2 of the square.
TEST(LMS3DMapComparison, MissesAWall)
{
  Comparison comparison(MakeCube(false), MakeCube(true), Point{ 0.3, -0.2, 0.1 });
  comparison.ExpectErrors("MapToScene", { 0.0, 0.0, 0.0, 0.0 }, 1e-15);
  comparison.ExpectErrors("SceneToMap",
    { 4.0 / 36.0, std::sqrt(16.0 / 24.0 / 6.0), 2.0 * (1.0 - std::sqrt(0.3)), 2.0 }, 0.01);
  EXPECT_EQ(comparison.Update()->GetCorrectness(), 1.0);
  comparison.Filter->SetTolerance(0.5);
  EXPECT_NEAR(comparison.Update()->GetCompleteness(), (6.0 - 0.75 * 0.75) / 6.0, ShareError);
  const double completeness = comparison.Update()->GetCompleteness();
  EXPECT_DOUBLE_EQ(comparison.Update()->GetFScore(), 2.0 * completeness / (1.0 + completeness));
}

TEST(LMS3DMapComparison, MissesWhatAHoleLeavesOut)
{
  vtkSmartPointer<vtkPolyData> map = MakePolygon({});
  for (int side = 0; side < 4; ++side)
  {
    vtkNew<vtkTransform> turn;
    turn->RotateZ(90.0 * side);
    map = Join(map,
      Transform(MakePolygon({ { -2, -2, 0 }, { 2, -2, 0 }, { 1, -1, 0 }, { -1, -1, 0 } }), turn));
  }
  Comparison comparison(map, MakeFloor(2.0, 0.0), Point{ 0.0, 0.0, 1.0 });
  comparison.ExpectErrors("SceneToMap",
    { 2.0 / 6.0 / 4.0, std::sqrt(4.0 / 24.0 / 4.0), 1.0 - std::sqrt(0.2), 1.0 }, 0.006);
  EXPECT_NEAR(
    comparison.Update()->GetCompleteness(), 0.75 + 0.25 * (1.0 - 0.99 * 0.99), ShareError);
}

TEST(LMS3DMapComparison, SeesBetweenTheVertices)
{
  // The map bridges a ditch 1 m deep, although all its vertices lie on the scene.
  vtkSmartPointer<vtkPolyData> scene = MakePolygon({});
  for (const Point& piece : { Point{ -2, -1, 0 }, Point{ -1, 1, -1 }, Point{ 1, 2, 0 } })
  {
    scene = Join(scene,
      MakePolygon({ { piece[0], -2, piece[2] }, { piece[1], -2, piece[2] },
        { piece[1], 2, piece[2] }, { piece[0], 2, piece[2] } }));
  }
  Comparison comparison(MakeFloor(2.0, 0.0), scene, Point{ 0.0, 0.0, 2.0 });
  EXPECT_NEAR(comparison.Update()->GetMapToSceneMaximum(), 1.0, 1e-4);
  EXPECT_NEAR(comparison.Update()->GetCorrectness(), 0.5 + 0.02 / 4.0, ShareError);
  EXPECT_NEAR(comparison.Update()->GetAreaInFreeSpace(), 8.0 - 0.08, 0.02);
  vtkPolyData* map = comparison.Filter->GetOutput();
  EXPECT_EQ(map->GetPointData()->GetArray("Error")->GetRange()[1], 0.0);
  EXPECT_NEAR(map->GetCellData()->GetArray("LargestError")->GetTuple1(0), 1.0, 1e-4);
}

TEST(LMS3DMapComparison, DistinguishesBackFromFront)
{
  Comparison comparison(Reverse(MakeFloor(2.0, 0.03)), MakeFloor(2.0, 0.0), Point{ 0.1, 0.2, 1.0 });
  comparison.ExpectErrors("NormalError", { 180.0, 180.0, 180.0, 180.0 }, 1e-12);
  comparison.ExpectErrors("MapToScene", { 0.03, 0.03, 0.03, 0.03 }, SumError);
}

TEST(LMS3DMapComparison, MeasuresOnlyWhatTheSensorSees)
{
  const auto front = MakePolygon({ { 2, -1, -1 }, { 2, 1, -1 }, { 2, 1, 1 }, { 2, -1, 1 } });
  const auto hidden = MakePolygon({ { 4, -2, -2 }, { 4, 2, -2 }, { 4, 2, 2 }, { 4, -2, 2 } });
  const auto behind = MakePolygon({ { -3, -1, -1 }, { -3, 1, -1 }, { -3, 1, 1 }, { -3, -1, 1 } });
  const auto above = MakePolygon({ { -1, -1, 9 }, { 1, -1, 9 }, { 1, 1, 9 }, { -1, 1, 9 } });
  const auto scene = Join(Join(front, hidden), Join(behind, above));
  const std::vector<double> alphas = { -50.0, 0.0, 50.0 };
  const std::vector<double> betas = { -60.0, 0.0, 60.0 };

  Comparison narrow(front, scene, MakePose({ 0, 0, 0 }, alphas, betas));
  EXPECT_EQ(narrow.Update()->GetCompleteness(), 1.0);
  EXPECT_NEAR(narrow.Update()->GetVisibleArea(), 4.0, 0.01);

  Comparison allAround(front, scene, Point{ 0, 0, 0 });
  EXPECT_NEAR(allAround.Update()->GetVisibleArea(), 12.0, 0.01);
  EXPECT_NEAR(allAround.Update()->GetCompleteness(), 1.0 / 3.0, ShareError);
  allAround.Filter->SetMaximumRange(8.0);
  EXPECT_NEAR(allAround.Update()->GetVisibleArea(), 8.0, 0.01);
  // The minimum range hides a disc of the nearer wall, with a squared radius of 2.2^2 - 2^2.
  allAround.Filter->SetMinimumRange(2.2);
  EXPECT_NEAR(allAround.Update()->GetVisibleArea(), 8.0 - lms3dPi * 0.84, 0.01);
}

TEST(LMS3DMapComparison, CountsOnlySpaceThatTheSensorSawToBeEmpty)
{
  const auto scene = MakePolygon({ { 2, -1, -1 }, { 2, 1, -1 }, { 2, 1, 1 }, { 2, -1, 1 } });
  const auto phantom = MakePolygon({ { -3, -1, -1 }, { -3, 1, -1 }, { -3, 1, 1 }, { -3, -1, 1 } });
  Comparison narrow(
    Join(scene, phantom), scene, MakePose({ 0, 0, 0 }, { -50.0, 50.0 }, { -60.0, 0.0, 60.0 }));
  EXPECT_EQ(narrow.Update()->GetAreaInFreeSpace(), 0.0);
  // A beam without a return shows that space is empty up to the maximum range.
  Comparison allAround(Join(scene, phantom), scene, Point{ 0, 0, 0 });
  EXPECT_NEAR(allAround.Update()->GetAreaInFreeSpace(), 4.0, 1e-4);
  allAround.Filter->SetMaximumRange(2.9);
  EXPECT_EQ(allAround.Update()->GetAreaInFreeSpace(), 0.0);
}

TEST(LMS3DMapComparison, CountsClosedGapsApart)
{
  const auto scene = MakePolygon({ { 2, -9, -9 }, { 2, 9, -9 }, { 2, 9, 9 }, { 2, -9, 9 } });
  const auto map =
    MakePolygon({ { 1.5, -0.5, -0.5 }, { 1.5, 0.5, -0.5 }, { 1.5, 0.5, 0.5 }, { 1.5, -0.5, 0.5 } });
  std::vector<double> angles;
  for (int i = -30; i <= 30; ++i)
  {
    angles.push_back(i);
  }
  vtkSmartPointer<vtkPolyData> pose = MakePose({ 0, 0, 0 }, angles, angles);
  Comparison open(map, scene, pose);
  EXPECT_NEAR(open.Update()->GetAreaInFreeSpace(), 1.0, 1e-9);
  EXPECT_EQ(open.Update()->GetClosedGapAreaInFreeSpace(), 0.0);

  // The turns before the middle one, where y is above 0.
  std::vector<double> closed(30 * 61);
  std::iota(closed.begin(), closed.end(), 0.0);
  AddDoubles(map, "ClosedBeamIds", closed);
  Comparison half(map, scene, pose);
  EXPECT_NEAR(half.Update()->GetAreaInFreeSpace(), 0.5, 1e-3);
  EXPECT_NEAR(half.Update()->GetClosedGapAreaInFreeSpace(), 0.5, 1e-3);
  EXPECT_EQ(
    half.GetField("ClosedGapAreaInFreeSpace"), half.Update()->GetClosedGapAreaInFreeSpace());
  // Numbers beyond the scan.
  AddDoubles(map, "ClosedBeamIds", { 61.0 * 61.0 + 1.0, -1.0 });
  Comparison none(map, scene, pose);
  EXPECT_NEAR(none.Update()->GetAreaInFreeSpace(), 1.0, 1e-9);
}

TEST(LMS3DMapComparison, TurnsTheViewWithTheSensor)
{
  const auto wall = MakePolygon({ { 2, -1, -1 }, { 2, 1, -1 }, { 2, 1, 1 }, { 2, -1, 1 } });
  // The sensor is turned 90 degrees to the left, so the wall is 90 degrees to its right. Beta turns
  // right.
  vtkSmartPointer<vtkPolyData> pose = MakePose({ 0, 0, 0 }, { -50.0, 50.0 }, { 30.0, 90.0, 150.0 });
  AddDoubles(pose, "SensorToWorld", { 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 });
  Comparison right(wall, wall, pose);
  EXPECT_NEAR(right.Update()->GetVisibleArea(), 4.0, 1e-9);
  AddDoubles(pose, "BetaAngles", { 210.0, 270.0, 330.0 });
  Comparison left(wall, wall, pose);
  left.ExpectError("sees nothing");
}
