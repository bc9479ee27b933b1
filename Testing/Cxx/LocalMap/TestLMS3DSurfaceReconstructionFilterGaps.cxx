// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Plain grids at depth steps and misses.
 */
#include "LocalMap/PlainGridFixtures.h"

#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
/// The largest range difference along a triangle's edge.
double GetLargestStep(vtkPolyData* map)
{
  vtkDataArray* range = map->GetPointData()->GetArray("Range");
  double largest = 0.0;
  for (const Edge& edge : GetDirectedEdges(map))
  {
    largest =
      std::max(largest, std::abs(range->GetTuple1(edge.first) - range->GetTuple1(edge.second)));
  }
  return largest;
}
} // namespace

TEST(LMS3DSurfaceReconstructionFilter, NeverCrossesADepthStep)
{
  // A plate one metre in front of a wall.
  const double x = 3.0;
  PlainGridPipeline pipeline(Join(
    MakePolygon({ { x, -9, -9 }, { x, 9, -9 }, { x, 9, 9 }, { x, -9, 9 } }),
    MakePolygon(
      { { x - 1, -0.5, -0.5 }, { x - 1, 0.5, -0.5 }, { x - 1, 0.5, 0.5 }, { x - 1, -0.5, 0.5 } })));
  pipeline.Scan->SetAlphaRange(-40.0, 40.0);
  pipeline.Scan->SetAlphaResolution(161);
  pipeline.Scan->SetBetaRange(-40.0, 40.0);
  pipeline.Scan->SetBetaResolution(161);
  vtkPolyData* map = pipeline.Run();
  EXPECT_EQ(map->GetNumberOfPoints(), 161 * 161);
  EXPECT_LT(GetLargestStep(map), 0.2);
  for (vtkIdType cell = 0; cell < map->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    map->GetCell(cell)->GetBounds(bounds);
    ASSERT_LT(bounds[1] - bounds[0], 1e-9) << "a triangle lies on the plate or on the wall";
  }

  // A DepthStep above the step bridges it.
  const vtkIdType separate = map->GetNumberOfCells();
  pipeline.Map->SetDepthStep(1.5);
  EXPECT_EQ(pipeline.Run()->GetNumberOfCells(), 2 * 160 * 160);
  EXPECT_LT(separate, 2 * 160 * 160);
}

TEST(LMS3DSurfaceReconstructionFilter, KeepsAGrazingFloorWhole)
{
  // Up to 57 m away, where the returns of neighbouring beams are tens of metres apart.
  PlainGridPipeline pipeline(MakeFloor(1000.0, -1.0));
  pipeline.Scan->SetAlphaRange(-90.0, -1.0);
  pipeline.Scan->SetAlphaResolution(179);
  vtkPolyData* map = pipeline.Run();
  EXPECT_GT(GetLargestStep(map), 15.0);
  EXPECT_EQ(map->GetNumberOfCells(), 2 * 177 * 360 + 360);
}

TEST(LMS3DSurfaceReconstructionFilter, NeverJoinsAcrossAMiss)
{
  PlainGridPipeline pipeline(MakeBall(2.0));
  pipeline.Scan->SetAlphaResolution(19);
  pipeline.Scan->SetBetaResolution(36);
  vtkSmartPointer<vtkPolyData> scan = CopyScan(pipeline.Scan);
  // Take the return in the middle of the grid away.
  vtkNew<vtkPolyData> holed;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  holed->SetPoints(points);
  holed->GetPointData()->CopyAllocate(scan->GetPointData());
  holed->GetFieldData()->ShallowCopy(scan->GetFieldData());
  for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
  {
    if (i != 18 * 19 + 9)
    {
      const vtkIdType to = points->InsertNextPoint(scan->GetPoint(i));
      holed->GetPointData()->CopyData(scan->GetPointData(), i, to);
    }
  }
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetMaximumError(0.0);
  map->SetInputDataObject(holed);
  map->Update();
  // Each of the four cells around the hole keeps one of its two triangles.
  EXPECT_EQ(map->GetOutput()->GetNumberOfCells(), pipeline.Run()->GetNumberOfCells() - 4);
  EXPECT_EQ(CountBoundaryEdges(GetDirectedEdges(map->GetOutput())), 4);
}
