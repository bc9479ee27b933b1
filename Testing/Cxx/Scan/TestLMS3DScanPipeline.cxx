// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkLMS3DScanFilter in a pipeline: what makes it build and run, progress, threads, pieces.
 */
#include "Casting/MethodFixtures.h"
#include "Fixtures/ProgressListener.h"
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPoints.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

TEST(LMS3DScanPipeline, BuildsForANewSurfaceAndNotForANewPose)
{
  vtkSmartPointer<vtkPolyData> ball = MakeBall(1.0);
  auto scan = MakeScan(ball);
  SetGrid(scan, 9, 8);
  EXPECT_EQ(scan->GetBuildTime(), 0u);
  scan->Update();
  const vtkMTimeType first = scan->GetBuildTime();
  EXPECT_GT(first, 0u);

  scan->SetPosition(0.1, 0.0, 0.0);
  scan->SetOrientation(0.0, 0.0, 5.0);
  SetGrid(scan, 17, 16);
  scan->Update();
  EXPECT_EQ(scan->GetBuildTime(), first);

  scan->SetPosition(0.0, 0.0, 0.0);
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    Point p;
    ball->GetPoint(i, p.data());
    ball->GetPoints()->SetPoint(i, 2 * p[0], 2 * p[1], 2 * p[2]);
  }
  ball->GetPoints()->Modified();
  scan->Update();
  EXPECT_GT(scan->GetBuildTime(), first);
  EXPECT_GT(GetRange(scan, 0), 1.5);
}

TEST(LMS3DScanPipeline, NoticesAChangeInsideOfAComposite)
{
  vtkSmartPointer<vtkPolyData> ball = MakeBall(1.0);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeFloor(1.0, -50.0));
  blocks->SetBlock(1, ball);
  auto scan = MakeScan(blocks);
  SetGrid(scan, 9, 8);
  scan->Update();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 72);
  // The cells of the ball follow the one of the floor.
  EXPECT_GE(GetArray(scan, "CellId")->GetRange()[0], 1.0);

  const vtkMTimeType first = scan->GetBuildTime();
  ball->DeepCopy(MakeBall(2.0));
  scan->Modified();
  scan->Update();
  EXPECT_GT(scan->GetBuildTime(), first);
  EXPECT_GT(GetRange(scan, 0), 1.5);
}

TEST(LMS3DScanPipeline, NoticesABlockThatIsTakenAway)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, MakeBall(2.0));
  inner->SetBlock(1, MakeBall(1.0));
  vtkNew<vtkMultiBlockDataSet> outer;
  outer->SetBlock(0, inner);
  auto scan = MakeScan(outer);
  SetGrid(scan, 9, 8);
  scan->Update();
  EXPECT_LT(GetRange(scan, 0), 1.1);
  inner->SetBlock(1, nullptr);
  scan->Modified();
  scan->Update();
  EXPECT_GT(GetRange(scan, 0), 1.9);
}

TEST(LMS3DScanPipeline, TellsProgressFromTheStartToTheEnd)
{
  auto scan = MakeScan(MakeBall(1.0));
  std::vector<double> shares;
  const ProgressListener listener(scan, [&](double share) { shares.push_back(share); });
  scan->SetNumberOfThreads(1);
  scan->Update();
  // At least once for every tenth of the work.
  ASSERT_GE(shares.size(), 10u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_EQ(shares.back(), 1.0);
}

TEST(LMS3DScanPipeline, StopsWhenAskedAndIsWholeAgainAfterwards)
{
  auto scan = MakeScan(MakeBall(1.0));
  // Only the calling thread reports progress, and other threads could do all of its work.
  scan->SetNumberOfThreads(1);
  {
    const ProgressListener stopper(scan,
      [&](double share)
      {
        if (share > 0.5)
        {
          scan->AbortExecuteOn();
        }
      });
    scan->Update();
  }
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);

  scan->AbortExecuteOff();
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 361 * 360);
}

TEST(LMS3DScanPipeline, NamesCellsByTheirGlobalIds)
{
  auto ball = MakeBall(1.0, 12);
  auto plain = MakeScan(ball);
  SetGrid(plain, 19, 18);
  plain->Update();
  vtkNew<vtkIntArray> ids;
  ids->SetName("Ids");
  const vtkIdType cells = ball->GetNumberOfCells();
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    ids->InsertNextValue(static_cast<int>(1000 - cell));
  }
  vtkNew<vtkPolyData> numbered;
  numbered->ShallowCopy(ball);
  numbered->GetCellData()->SetGlobalIds(ids);
  auto scan = MakeScan(numbered);
  SetGrid(scan, 19, 18);
  scan->Update();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), plain->GetOutput()->GetNumberOfPoints());
  vtkDataArray* named = GetArray(scan, "CellId");
  vtkDataArray* counted = GetArray(plain, "CellId");
  int same = 0;
  for (vtkIdType i = 0; i < named->GetNumberOfTuples(); ++i)
  {
    same += named->GetTuple1(i) == 1000 - counted->GetTuple1(i) ? 1 : 0;
    EXPECT_GT(named->GetTuple1(i), 1000 - cells);
  }
  // At vertices and edges of the ball the smallest id wins, which is another cell.
  EXPECT_GT(same, named->GetNumberOfTuples() / 2);
  EXPECT_LT(same, named->GetNumberOfTuples());
}

TEST(LMS3DScanPipeline, IsOnePieceOfAllTheScene)
{
  vtkNew<vtkSphereSource> source;
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputConnection(source->GetOutputPort());
  SetGrid(scan, 9, 8);
  scan->UpdatePiece(1, 2, 0);
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  scan->UpdatePiece(0, 2, 0);
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 72);
}

TEST(LMS3DScanPipeline, ScansThousandsOfBlocks)
{
  // A wall around the sensor, each piece of it a block of 20 triangles.
  constexpr int NumberOfBlocks = 20000;
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int block = 0; block < NumberOfBlocks; ++block)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int i = 0; i < 22; ++i)
    {
      const int step = i / 2;
      const double angle = 2.0 * vtkMath::Pi() * (block + 0.1 * step) / NumberOfBlocks;
      points->InsertNextPoint(10.0 * std::cos(angle), 10.0 * std::sin(angle), i % 2 ? 1.0 : -1.0);
    }
    vtkNew<vtkCellArray> triangles;
    for (vtkIdType i = 0; i < 20; ++i)
    {
      const vtkIdType corners[3] = { i, i + 1, i + 2 };
      triangles->InsertNextCell(3, corners);
    }
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(points);
    surface->SetPolys(triangles);
    blocks->SetBlock(block, surface);
  }
  auto scan = MakeScan(blocks);
  scan->SetAlphaRange(0.0, 90.0);
  SetGrid(scan, 1, 3600);
  EXPECT_EQ(UpdateAndGetError(scan), "");
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 3600);
  // Cells are numbered through; beta turns clockwise, and the wall counterclockwise.
  for (vtkIdType turn = 1; turn < 3600; ++turn)
  {
    const double share = 1.0 - turn / 3600.0;
    ASSERT_NEAR(GetArray(scan, "CellId")->GetTuple1(turn), share * 20 * NumberOfBlocks, 3.0);
    ASSERT_NEAR(GetRange(scan, turn), 10.0, 1e-8);
  }
}

namespace
{
class EveryMethod : public testing::TestWithParam<int>
{
};
} // namespace

TEST_P(EveryMethod, GivesTheSameBitsForAnyNumberOfThreads)
{
  auto scan = MakeScan(ReadRoom());
  scan->SetIntersectionMethod(GetParam());
  scan->SetPosition(0.3, -0.2, 1.0);
  SetGrid(scan, 61, 59);
  scan->SetNumberOfThreads(1);
  scan->Update();
  const std::uint64_t expectedScan = Hash(scan->GetOutput());
  const std::uint64_t expectedImage = Hash(scan->GetRangeImage());
  for (int threads : { 2, 3, 8 })
  {
    scan->SetNumberOfThreads(threads);
    scan->Update();
    EXPECT_EQ(Hash(scan->GetOutput()), expectedScan) << threads << " threads";
    EXPECT_EQ(Hash(scan->GetRangeImage()), expectedImage) << threads << " threads";
  }
}

INSTANTIATE_TEST_SUITE_P(LMS3DScanPipeline, EveryMethod,
  testing::Range(0, vtkLMS3DScanFilter::GetNumberOfIntersectionMethods()), GetMethodName);
