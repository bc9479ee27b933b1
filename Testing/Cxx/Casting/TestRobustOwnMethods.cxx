// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the header of vtkLMS3DScanFilter promises of tiny, large and far scenes, for each
 * method except VTK's.
 */
#include "Casting/MethodFixtures.h"
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkDataArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// All except VTK's, whose tolerance is a length: it hits beyond a limit, tiny scenes grow by it,
/// and beams are lost where coordinates are rounded to more.
class RobustOwnMethods : public testing::TestWithParam<int>
{
};
} // namespace

TEST_P(RobustOwnMethods, SeesScenesOfAnySizeAtAnyOffset)
{
  for (double scale : { 1e-6, 1e-3, 1.0, 1e3, 1e7 })
  {
    for (double offset : { 0.0, 1e5, 1e7 })
    {
      vtkSmartPointer<vtkPolyData> ball = MakeBall(1.0, 24);
      const double inradius = GetInradius(ball);
      const Point center = { scale * offset, 0.0, -scale * offset };
      ScaleAndMove(ball, scale, center);
      vtkNew<vtkLMS3DScanFilter> scan;
      SetUpScan(scan, ball, GetParam());
      scan->SetPosition(center.data());
      scan->SetMaximumRange(Infinity);
      scan->Update();
      ASSERT_GE(scan->GetOutput()->GetNumberOfPoints(), GetMinimumShare(GetParam()) * 31 * 36)
        << scale << ", " << offset;
      // The vertices themselves are rounded at an offset.
      const double tolerance = scale * (1e-14 + 4e-16 * offset);
      const double* ranges = GetArray(scan, "Range")->GetRange();
      EXPECT_GE(ranges[0], scale * inradius - tolerance) << scale << ", " << offset;
      EXPECT_LE(ranges[1], scale + tolerance) << scale << ", " << offset;
    }
  }
}

TEST_P(RobustOwnMethods, SeesTinyScenes)
{
  for (double radius : { 1e-9, 1e-15, 1e-20, 1e-22, 1e-24, 1e-100 })
  {
    vtkSmartPointer<vtkPolyData> ball = MakeBall(1.0, 12);
    const double inradius = GetInradius(ball);
    ScaleAndMove(ball, radius, {});
    vtkNew<vtkLMS3DScanFilter> scan;
    SetUpScan(scan, ball, GetParam());
    EXPECT_EQ(UpdateAndGetWarning(scan), "") << radius;
    ASSERT_GE(scan->GetOutput()->GetNumberOfPoints(), GetMinimumShare(GetParam()) * 31 * 36)
      << radius;
    const double* ranges = GetArray(scan, "Range")->GetRange();
    EXPECT_GE(ranges[0], radius * inradius * (1.0 - 1e-14)) << radius;
    EXPECT_LE(ranges[1], radius * (1.0 + 1e-14)) << radius;
  }
}

TEST_P(RobustOwnMethods, CountsUpToTheMaximumRange)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  SetUpScan(scan, MakeBall(1.0, 24), GetParam());
  scan->SetAlphaRange(33.0, 90.0);
  scan->SetAlphaResolution(1);
  scan->SetBetaRange(77.0, 90.0);
  scan->SetBetaResolution(1);
  scan->Update();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 1);
  const double range = GetRange(scan, 0);
  scan->SetMaximumRange(range);
  scan->Update();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 1);
  EXPECT_EQ(GetRange(scan, 0), range);
  scan->SetMaximumRange(std::nextafter(range, 0.0));
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
}

INSTANTIATE_TEST_SUITE_P(EachOfThem, RobustOwnMethods,
  testing::Values(vtkLMS3DScanFilter::EXACT, vtkLMS3DScanFilter::FAST,
    vtkLMS3DScanFilter::ANGLE_SUM, vtkLMS3DScanFilter::MOLLER_TRUMBORE),
  GetMethodName);
