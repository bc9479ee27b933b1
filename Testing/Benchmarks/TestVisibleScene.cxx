// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VisibleScene.h"

#include <vtkCellArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

namespace
{
/// Squares of 3 x 3 fields with two triangles each: one in the plane z = 0, and, beside it, one
/// that stands upright. Field i of the first one has the cells 2 i and 2 i + 1.
vtkSmartPointer<vtkPolyData> MakeSquares()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int square = 0; square < 2; ++square)
  {
    for (int v = 0; v <= 3; ++v)
    {
      for (int u = 0; u <= 3; ++u)
      {
        points->InsertNextPoint(square == 0 ? u : 3.0, v, square == 0 ? 0.0 : u);
      }
    }
    for (vtkIdType v = 0; v < 3; ++v)
    {
      for (vtkIdType u = 0; u < 3; ++u)
      {
        const vtkIdType first = 16 * square + 4 * v + u;
        const vtkIdType low[3] = { first, first + 1, first + 5 };
        const vtkIdType high[3] = { first, first + 5, first + 4 };
        cells->InsertNextCell(3, low);
        cells->InsertNextCell(3, high);
      }
    }
  }
  auto scene = vtkSmartPointer<vtkPolyData>::New();
  scene->SetPoints(points);
  scene->SetPolys(cells);
  return scene;
}

void Hit(vtkIdType first, vtkIdType last, VisibleScene& scene)
{
  vtkNew<vtkPolyData> scan;
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("CellId");
  for (vtkIdType cell = first; cell <= last; ++cell)
  {
    cells->InsertNextValue(cell);
  }
  scan->GetPointData()->AddArray(cells);
  scene.Add(scan);
}
} // namespace

TEST(VisibleScene, NeedsNoTrianglesBeforeAHit)
{
  EXPECT_EQ(VisibleScene(MakeSquares()).CountTriangles(), 0);
}

TEST(VisibleScene, JoinsTrianglesOfOnePlane)
{
  VisibleScene scene(MakeSquares());
  Hit(0, 0, scene);
  EXPECT_EQ(scene.CountTriangles(), 1);
  Hit(0, 5, scene);
  EXPECT_EQ(scene.CountTriangles(), 2);
  Hit(6, 17, scene);
  EXPECT_EQ(scene.CountTriangles(), 2);
}

TEST(VisibleScene, KeepsTrianglesOfOtherPlanesApart)
{
  VisibleScene scene(MakeSquares());
  Hit(0, 35, scene);
  EXPECT_EQ(scene.CountTriangles(), 4);
}

// Four corners outside and four around the hole.
TEST(VisibleScene, CountsHoles)
{
  VisibleScene scene(MakeSquares());
  Hit(0, 7, scene);
  Hit(10, 17, scene);
  EXPECT_EQ(scene.CountTriangles(), 8);
}
