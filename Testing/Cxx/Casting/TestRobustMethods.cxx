// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the header of vtkLMS3DScanFilter promises of bad and far scenes, for each
 * method.
 */
#include "Casting/MethodFixtures.h"
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

class RobustMethods : public testing::TestWithParam<int>
{
};

// How far, relative to the range, a far scene may seem to be off.
double GetFarError(int method)
{
  switch (method)
  {
    case vtkLMS3DScanFilter::EXACT:
      return 1e-15;
    case vtkLMS3DScanFilter::ANGLE_SUM:
      return 1e-9; // So near to a corner, planes beside their triangles count.
    default:
      return 1e-13;
  }
}

void ExpectSameRanges(vtkLMS3DScanFilter* scan, vtkLMS3DScanFilter* expected)
{
  const vtkIdType count = expected->GetOutput()->GetNumberOfPoints();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double range = GetRange(expected, i);
    ASSERT_NEAR(GetRange(scan, i), range, 1e-13 * range) << i;
  }
}

/// A triangle before the ball with one bad coordinate.
vtkSmartPointer<vtkPolyData> MakeBadTriangle(double bad, int corner)
{
  vtkSmartPointer<vtkPolyData> triangle =
    MakePolygon({ { 0.1, -0.1, -0.1 }, { 0.1, 0.2, -0.1 }, { 0.1, 0.0, 0.2 } });
  triangle->GetPoints()->SetPoint(corner, 0.1, corner == 1 ? bad : 0.0, corner == 1 ? 0.0 : bad);
  return triangle;
}

std::size_t Count(const std::string& text, const std::string& word)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
  {
    ++count;
  }
  return count;
}

} // namespace

TEST_P(RobustMethods, LeavesCellsOutThatAreNotFinite)
{
  vtkSmartPointer<vtkPolyData> ball = MakeBall(1.0, 24);
  vtkSmartPointer<vtkPolyData> floor = MakeFloor(1.0, -5.0);
  vtkNew<vtkLMS3DScanFilter> clean;
  SetUpScan(clean, Join(ball, floor), GetParam());
  EXPECT_EQ(UpdateAndGetWarning(clean), "");
  ASSERT_GE(clean->GetOutput()->GetNumberOfPoints(), GetMinimumShare(GetParam()) * 31 * 36);

  vtkSmartPointer<vtkPolyData> scene = ball;
  int count = 0;
  for (double bad : { NaN, Infinity, -Infinity, 1e300, -2e18 })
  {
    scene = Join(scene, MakeBadTriangle(bad, count++ % 3));
  }
  // A good cell after the bad ones.
  scene = Join(scene, floor);
  vtkNew<vtkLMS3DScanFilter> scan;
  SetUpScan(scan, scene, GetParam());
  const std::string warning = UpdateAndGetWarning(scan);
  EXPECT_EQ(Count(warning, "cells with a point that is not finite"), 1u) << warning;
  EXPECT_NE(warning.find("left out: 5."), std::string::npos) << warning;
  EXPECT_EQ(scan->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(Hash(scan->GetRangeImage()), Hash(clean->GetRangeImage()));
  EXPECT_EQ(Hash(scan->GetOutput()), Hash(clean->GetOutput()));
}

TEST_P(RobustMethods, KeepsTheNumbersOfTheCellsBehindThoseLeftOut)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  SetUpScan(scan, Join(MakeBadTriangle(NaN, 0), MakeFloor(1.0, -1.0)), GetParam());
  EXPECT_NE(UpdateAndGetWarning(scan), "");
  ASSERT_GT(scan->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scan->GetOutput()->GetPointData()->GetArray("CellId")->GetRange()[0], 1.0);
}

TEST_P(RobustMethods, WarnsOnlyWhenItBuilds)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  SetUpScan(scan, Join(MakeBall(1.0, 8), MakeBadTriangle(NaN, 0)), GetParam());
  EXPECT_NE(UpdateAndGetWarning(scan), "");
  scan->SetPosition(0.1, 0.0, 0.0);
  EXPECT_EQ(UpdateAndGetWarning(scan), "");
}

TEST_P(RobustMethods, RefusesASceneWithoutAUsableCell)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  SetUpScan(scan, Join(MakeBadTriangle(NaN, 0), MakeBadTriangle(1e19, 1)), GetParam());
  EXPECT_NE(UpdateAndGetError(scan), "");
  EXPECT_EQ(scan->GetErrorCode(), vtkErrorCode::UserError);
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scan->GetRangeImage()->GetNumberOfPoints(), 0);
}

TEST_P(RobustMethods, SeesDuplicatedFacesAsOne)
{
  vtkSmartPointer<vtkPolyData> ball = MakeBall(1.0, 24);
  vtkNew<vtkLMS3DScanFilter> once;
  SetUpScan(once, ball, GetParam());
  once->Update();
  vtkNew<vtkLMS3DScanFilter> twice;
  SetUpScan(twice, Join(ball, ball), GetParam());
  twice->Update();
  ExpectSameRanges(twice, once);
  const std::uint64_t first = Hash(twice->GetOutput());
  twice->Modified();
  twice->Update();
  EXPECT_EQ(Hash(twice->GetOutput()), first);
}

TEST_P(RobustMethods, NeverReturnsTheSurfaceItStandsOn)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  SetUpScan(scan, MakeFloor(10.0, 0.0), GetParam());
  scan->SetPosition(0.25, 0.5, 0.0);
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_P(RobustMethods, MayStandAsFarAwayAsItLikes)
{
  const double error = GetFarError(GetParam());
  for (double radius : { 1e-30, 1e-6, 1e-3, 1.0 })
  {
    for (double distance : { 1.0, 1e6, 1e13, 1e18 })
    {
      if (radius < distance)
      {
        vtkSmartPointer<vtkPolyData> ball = MakeBall(1.0, 8);
        const double inradius = GetInradius(ball);
        ScaleAndMove(ball, radius, {});
        vtkNew<vtkLMS3DScanFilter> scan;
        SetUpScan(scan, ball, GetParam());
        // The first beam runs along x, through the ball's middle.
        scan->SetPosition(-distance, 0.0, 0.0);
        scan->SetMaximumRange(Infinity);
        scan->SetAlphaRange(0.0, 90.0);
        EXPECT_EQ(UpdateAndGetError(scan), "");
        ASSERT_GE(scan->GetOutput()->GetNumberOfPoints(), 1) << radius << " at " << distance;
        EXPECT_EQ(GetArray(scan, "BeamId")->GetTuple1(0), 0.0);
        EXPECT_GE(GetRange(scan, 0), (distance - radius) * (1.0 - error))
          << radius << " at " << distance << ", off by " << GetRange(scan, 0) - distance;
        EXPECT_LE(GetRange(scan, 0), (distance - inradius * radius) * (1.0 + error)) << radius;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EachOfThem, RobustMethods,
  testing::Range(0, vtkLMS3DScanFilter::GetNumberOfIntersectionMethods()), GetMethodName);
