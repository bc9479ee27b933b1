// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Range errors of scans with all mountings, of mirrors beside the axis and of turning
 * platforms.
 */
#include "RangeErrors/RangeErrorFixtures.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Bias = 0.25;

struct Platform
{
  int Mounting;
  Point AxisOffset;
  double TurnRate;
};

void Mount(const Platform& platform, vtkLMS3DScanFilter* scan)
{
  scan->SetPosition(0.2, 0.1, 0.3);
  scan->SetOrientation(10.0, 20.0, 30.0);
  scan->SetMounting(platform.Mounting);
  scan->SetAxisOffset(platform.AxisOffset.data());
  scan->SetTurnRate(platform.TurnRate);
  SetGrid(scan, 91, 30);
}

double GetLength(const Point& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

Point GetPoint(vtkPolyData* scan, vtkIdType i)
{
  Point point;
  scan->GetPoint(i, point.data());
  return point;
}

// A bias moves each point along its beam. Going back by the range leads to the start of the beam.
void ExpectPointsOnBeams(RangeErrorPipeline& pipeline, double lengthOfOffset)
{
  const Point sensor = { 0.2, 0.1, 0.3 };
  double worst = 0.0;
  for (vtkIdType i = 0; i < pipeline.Scan->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const Point from = GetPoint(pipeline.Scan->GetOutput(), i);
    const Point to = GetPoint(pipeline.Errors->GetOutput(), i);
    Point moved, start;
    for (int axis = 0; axis < 3; ++axis)
    {
      moved[axis] = to[axis] - from[axis];
      start[axis] = from[axis] - GetRange(pipeline.Scan, i) / Bias * moved[axis] - sensor[axis];
    }
    worst = std::max(
      { worst, std::abs(GetLength(moved) - Bias), std::abs(GetLength(start) - lengthOfOffset) });
  }
  EXPECT_LT(worst, 1e-12);
}

const Platform Platforms[] = { { 0, { 0.1, 0.2, -0.1 }, 0.0 }, { 0, { 0.0, 0.0, 0.0 }, 37.5 },
  { 1, { 0.0, 0.0, 0.0 }, 0.0 }, { 1, { -0.2, 0.0, 0.05 }, -20.0 }, { 2, { 0.0, 0.0, 0.0 }, 0.0 },
  { 2, { 0.1, 0.1, 0.1 }, 10.0 }, { 3, { 0.0, 0.0, 0.0 }, 0.0 }, { 3, { 0.0, 0.1, 0.0 }, 75.0 } };
} // namespace

TEST(LMS3DRangeErrorFilter, MovesPointsAlongTheBeamsOfAnyPlatform)
{
  for (const Platform& platform : Platforms)
  {
    SCOPED_TRACE(testing::Message() << platform.Mounting << ' ' << platform.TurnRate);
    RangeErrorPipeline pipeline(MakeBall(2.0));
    Mount(platform, pipeline.Scan);
    pipeline.Errors->SetRangeBias(Bias);
    pipeline.Run();
    ASSERT_GT(pipeline.Scan->GetOutput()->GetNumberOfPoints(), 2000);
    ExpectPointsOnBeams(pipeline, GetLength(platform.AxisOffset));
  }
}

TEST(LMS3DRangeErrorFilter, WritesThePlatformOn)
{
  for (const Platform& platform : Platforms)
  {
    RangeErrorPipeline pipeline(MakeBall(2.0));
    Mount(platform, pipeline.Scan);
    AddAllErrors(pipeline.Errors);
    pipeline.Run();
    ExpectImageOfScan(pipeline.Errors->GetRangeImage(), pipeline.Errors->GetOutput());
    for (const char* name : { "Mounting", "AxisOffset", "TurnRate" })
    {
      vtkDataArray* before = pipeline.Scan->GetOutput()->GetFieldData()->GetArray(name);
      vtkDataArray* after = pipeline.Errors->GetOutput()->GetFieldData()->GetArray(name);
      ASSERT_EQ(before == nullptr, after == nullptr) << name;
      EXPECT_TRUE(!before || Hash(before) == Hash(after)) << name;
    }
  }
}
