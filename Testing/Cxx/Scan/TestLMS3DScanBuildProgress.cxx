// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Progress and abort while vtkLMS3DScanFilter builds its acceleration structure.
 */
#include "Fixtures/ProgressListener.h"
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace
{
/// A wall of 1,000,000 triangles at x = 5, made without VTK's sources, which are slow.
vtkSmartPointer<vtkPolyData> MakeLargeScene()
{
  constexpr int Columns = 1000;
  constexpr int Rows = 500;
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples((Columns + 1) * (Rows + 1));
  double* coordinate = coordinates->GetPointer(0);
  for (int i = 0; i < (Columns + 1) * (Rows + 1); ++i)
  {
    const int row = i / (Columns + 1);
    *coordinate++ = 5.0;
    *coordinate++ = 0.01 * (i % (Columns + 1)) - 5.0;
    *coordinate++ = 0.02 * row - 5.0;
  }
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(6 * Columns * Rows);
  vtkIdType* corner = corners->GetPointer(0);
  for (int i = 0; i < Columns * Rows; ++i)
  {
    const vtkIdType low = i / Columns * (Columns + 1) + i % Columns;
    const vtkIdType high = low + Columns + 1;
    for (vtkIdType id : { low, low + 1, high, high, low + 1, high + 1 })
    {
      *corner++ = id;
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(3, corners);
  auto scene = vtkSmartPointer<vtkPolyData>::New();
  scene->SetPoints(points);
  scene->SetPolys(triangles);
  return scene;
}

// The share of the progress that the class documentation gives for building.
constexpr double BuildShare = 0.3;
} // namespace

TEST(LMS3DScanBuild, ReportsProgress)
{
  auto scan = MakeScan(MakeLargeScene());
  SetGrid(scan, 9, 8);
  std::vector<double> shares;
  const ProgressListener listener(scan, [&](double share) { shares.push_back(share); });
  scan->Update();
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1.0);
  const auto isOfBuild = [](double share) { return share > 0.0 && share < BuildShare; };
  EXPECT_GE(std::count_if(shares.begin(), shares.end(), isOfBuild), 5);
}

TEST(LMS3DScanBuild, StopsInTheFirstProgressEvent)
{
  auto scene = MakeLargeScene();
  auto scan = MakeScan(scene);
  SetGrid(scan, 9, 8);
  const auto start = std::chrono::steady_clock::now();
  {
    const ProgressListener stopper(scan,
      [&](double share)
      {
        if (share > 0.0)
        {
          scan->AbortExecuteOn();
        }
      });
    scan->Update();
  }
  const std::chrono::duration<double> stopped = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scan->GetRangeImage()->GetNumberOfPoints(), 0);
  EXPECT_EQ(scan->GetBuildTime(), 0u);

  scan->AbortExecuteOff();
  const auto again = std::chrono::steady_clock::now();
  scan->Update();
  const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - again;
  auto undisturbed = MakeScan(scene);
  SetGrid(undisturbed, 9, 8);
  undisturbed->Update();
  EXPECT_GT(scan->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(Hash(scan->GetOutput()), Hash(undisturbed->GetOutput()));
  EXPECT_LT(stopped.count(), 0.5 * whole.count());
}

TEST(LMS3DScanBuild, StopsWhileEmbreeBuilds)
{
  auto scan = MakeScan(MakeLargeScene());
  SetGrid(scan, 9, 8);
  for (const double limit : { 0.4 * BuildShare, 0.6 * BuildShare })
  {
    const ProgressListener stopper(scan,
      [&](double share)
      {
        if (share > limit)
        {
          scan->AbortExecuteOn();
        }
      });
    scan->Update();
    EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(scan->GetBuildTime(), 0u);
    scan->AbortExecuteOff();
    scan->Modified();
  }
  EXPECT_EQ(UpdateAndGetError(scan), "");
  EXPECT_GT(scan->GetOutput()->GetNumberOfPoints(), 0);
}
