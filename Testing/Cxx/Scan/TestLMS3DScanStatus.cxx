// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The array Status: each of its codes, and where it is.
 */
#include "Fixtures/ProgressListener.h"
#include "Scan/DetectionFixtures.h"

#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Filter = vtkLMS3DScanFilter;

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Walls across the axes: near at x = 0.5, at y = 5, black at y = -5, and far at x = -20. Nothing
/// is above.
vtkSmartPointer<vtkPolyData> MakeWalls()
{
  auto walls = Join(Join(MakeWall(0.5), MakeWall(-20.0)),
    Join(MakePolygon({ { -1, 5, -1 }, { 1, 5, -1 }, { 1, 5, 1 }, { -1, 5, 1 } }),
      MakePolygon({ { -1, -5, -1 }, { 1, -5, -1 }, { 1, -5, 1 }, { -1, -5, 1 } })));
  SetReflectances(walls, { 1.0, 1.0, 1.0, 0.0 });
  return walls;
}

/// Beams along -x, y, -y, x and up, the last one four times.
vtkSmartPointer<Filter> MakeStatusScan(vtkDataObject* scene)
{
  auto scan = MakeScan(scene);
  scan->SetAlphaRange(0.0, 90.0);
  SetGrid(scan, 2, 4);
  scan->ComputeStatusOn();
  return scan;
}

std::vector<int> UpdateAndGetStatus(Filter* scan)
{
  EXPECT_EQ(UpdateAndGetError(scan), "");
  return GetStatus(scan);
}
} // namespace

TEST(LMS3DScanStatus, NamesEachReason)
{
  auto scan = MakeStatusScan(MakeWalls());
  scan->SetMinimumRange(1.0);
  scan->SetMaximumRange(10.0);
  scan->SetRangeAtTenPercent(10.0);
  scan->SetReflectanceArray("Reflectance");
  // Beta turns clockwise: x, -y, -x, y.
  EXPECT_EQ(UpdateAndGetStatus(scan),
    (std::vector<int>{ Filter::TOO_NEAR, Filter::NOTHING_MET, Filter::TOO_WEAK, Filter::NOTHING_MET,
      Filter::BEYOND_RANGE, Filter::NOTHING_MET, Filter::RETURN, Filter::NOTHING_MET }));
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 1);
}

TEST(LMS3DScanStatus, FollowsTheProperties)
{
  auto scan = MakeStatusScan(MakeWalls());
  scan->SetMaximumRange(Infinity);
  const auto turns = [&scan]
  {
    const std::vector<int> status = UpdateAndGetStatus(scan);
    return status.size() == 8 ? std::vector<int>{ status[0], status[2], status[4], status[6] }
                              : std::vector<int>();
  };
  EXPECT_EQ(turns(), (std::vector<int>{ 0, 0, 0, 0 }));
  // Limits come before weakness.
  scan->SetRangeAtTenPercent(10.0);
  scan->SetReflectanceArray("Reflectance");
  scan->SetMaximumRange(4.0);
  EXPECT_EQ(turns(), (std::vector<int>{ 0, 2, 2, 2 }));
  scan->SetMaximumRange(5.0);
  EXPECT_EQ(turns(), (std::vector<int>{ 0, 3, 2, 0 }));
  scan->SetMinimumRange(5.0);
  EXPECT_EQ(turns(), (std::vector<int>{ 4, 3, 2, 0 }));
  scan->SetMaximumRange(Infinity);
  scan->SetMinimumRange(30.0);
  EXPECT_EQ(turns(), (std::vector<int>{ 4, 4, 4, 4 }));
  // 100 percent at 31.6 m.
  scan->SetMinimumRange(0.0);
  scan->SetRangeAtTenPercent(2.0);
  EXPECT_EQ(turns(), (std::vector<int>{ 0, 3, 3, 0 }));
}

TEST(LMS3DScanStatus, IsOffAndThenThereIsNoArray)
{
  auto scan = MakeStatusScan(MakeWalls());
  scan->ComputeStatusOff();
  EXPECT_FALSE(vtkNew<Filter>()->GetComputeStatus());
  scan->Update();
  EXPECT_FALSE(scan->GetOutput()->GetFieldData()->HasArray("Status"));
  EXPECT_EQ(scan->GetRangeImage()->GetPointData()->GetNumberOfArrays(), 1);
  scan->ComputeStatusOn();
  scan->Update();
  vtkPointData* image = scan->GetRangeImage()->GetPointData();
  EXPECT_EQ(image->GetNumberOfArrays(), 2);
  EXPECT_STREQ(image->GetArrayName(1), "Status");
  EXPECT_STREQ(image->GetScalars()->GetName(), "Range");
  EXPECT_FALSE(scan->GetOutput()->GetPointData()->HasArray("Status"));
  scan->ComputeStatusOff();
  scan->Update();
  EXPECT_EQ(scan->GetRangeImage()->GetPointData()->GetNumberOfArrays(), 1);
}

TEST(LMS3DScanStatus, CountsAddUpInTheRoom)
{
  auto scan = MakeScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->SetMinimumRange(1.5);
  scan->SetMaximumRange(3.5);
  scan->SetRangeAtTenPercent(2.5);
  scan->SetReflectanceArray("Color");
  scan->ComputeStatusOn();
  const std::vector<int> status = UpdateAndGetStatus(scan);
  vtkDataArray* ranges = scan->GetRangeImage()->GetPointData()->GetArray("Range");
  ASSERT_EQ(status.size(), 361u * 360u);
  std::vector<int> counts(5, 0);
  for (std::size_t beam = 0; beam < status.size(); ++beam)
  {
    ASSERT_GE(status[beam], 0);
    ASSERT_LE(status[beam], 4);
    ++counts[status[beam]];
    ASSERT_EQ(
      status[beam] == Filter::RETURN, !std::isnan(ranges->GetTuple1(static_cast<vtkIdType>(beam))));
  }
  EXPECT_EQ(counts[Filter::RETURN], scan->GetOutput()->GetNumberOfPoints());
  // The room is closed.
  EXPECT_EQ(counts[Filter::NOTHING_MET], 0);
  for (int code : { Filter::RETURN, Filter::BEYOND_RANGE, Filter::TOO_WEAK, Filter::TOO_NEAR })
  {
    EXPECT_GT(counts[code], 0) << code;
  }
}

TEST(LMS3DScanStatus, WithoutRangeAtTenPercentNothingIsTooWeak)
{
  auto scan = MakeStatusScan(MakeWalls());
  scan->SetReflectanceArray("Reflectance");
  const std::vector<int> status = UpdateAndGetStatus(scan);
  EXPECT_EQ(std::count(status.begin(), status.end(), Filter::TOO_WEAK), 0);
}

TEST(LMS3DScanStatus, ReportsProgressThatNeverFallsAndStopsInTheSecondCast)
{
  auto scan = MakeScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->SetMaximumRange(3.0);
  scan->ComputeStatusOn();
  std::vector<double> shares;
  {
    const ProgressListener listener(scan, [&](double share) { shares.push_back(share); });
    scan->Update();
  }
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1.0);
  const std::vector<int> status = GetStatus(scan);
  // The calling thread reports. With several threads it may do no part of the second cast.
  scan->SetNumberOfThreads(1);
  {
    const ProgressListener stopper(
      scan, [&](double share) { scan->SetAbortExecute(share > 0.75 && share < 1.0); });
    scan->Modified();
    scan->Update();
  }
  scan->SetAbortExecute(0);
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_FALSE(scan->GetOutput()->GetFieldData()->HasArray("Status"));
  EXPECT_EQ(scan->GetRangeImage()->GetNumberOfPoints(), 0);
  EXPECT_EQ(UpdateAndGetStatus(scan), status);
}

TEST(LMS3DScanStatus, TheMapDoesNotDependOnTheNewArrays)
{
  auto scan = MakeScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->SetMaximumRange(4.0);
  SetGrid(scan, 91, 90);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetInputConnection(scan->GetOutputPort());
  map->Update();
  const std::uint64_t expected = Hash(map->GetOutput());
  const vtkIdType triangles = map->GetOutput()->GetNumberOfCells();
  scan->ComputeStatusOn();
  EXPECT_EQ(UpdateAndGetError(map), "");
  EXPECT_EQ(Hash(map->GetOutput()), expected);
  scan->ComputeIncidenceOn();
  scan->ComputeIntensityOn();
  EXPECT_EQ(UpdateAndGetError(map), "");
  EXPECT_EQ(map->GetOutput()->GetNumberOfCells(), triangles);
}
