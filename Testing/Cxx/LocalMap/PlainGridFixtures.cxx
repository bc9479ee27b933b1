// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/PlainGridFixtures.h"

#include <vtkErrorCode.h>
#include <vtkIdList.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

PlainGridPipeline::PlainGridPipeline(vtkDataObject* scene)
{
  this->Scan->SetInputDataObject(scene);
  this->Map->SetInputConnection(this->Scan->GetOutputPort());
  this->Map->SetMaximumError(0.0);
}

vtkPolyData* PlainGridPipeline::Run()
{
  this->Map->Update();
  return this->Map->GetOutput();
}

vtkSmartPointer<vtkPolyData> CopyScan(vtkLMS3DScanFilter* scan)
{
  scan->Update();
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(scan->GetOutput());
  return copy;
}

std::set<Edge> GetDirectedEdges(vtkPolyData* map)
{
  std::set<Edge> edges;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < map->GetNumberOfCells(); ++cell)
  {
    map->GetCellPoints(cell, corners);
    EXPECT_EQ(corners->GetNumberOfIds(), 3);
    for (int i = 0; i < 3; ++i)
    {
      const Edge edge(corners->GetId(i), corners->GetId((i + 1) % 3));
      EXPECT_NE(edge.first, edge.second);
      EXPECT_TRUE(edges.insert(edge).second) << "two triangles turn the same way at an edge";
    }
  }
  return edges;
}

vtkIdType CountBoundaryEdges(const std::set<Edge>& edges)
{
  return std::count_if(edges.begin(), edges.end(),
    [&](const Edge& edge) {
      return edges.count({ edge.second, edge.first }) == 0;
    });
}

void ExpectRefused(vtkPolyData* scan, const std::string& words)
{
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> filter;
  filter->SetInputDataObject(scan);
  for (double bound : { 0.0, 0.01 })
  {
    filter->SetMaximumError(bound);
    const std::string error = UpdateAndGetError(filter);
    EXPECT_NE(error.find(words), std::string::npos) << error;
    EXPECT_EQ(filter->GetErrorCode(), vtkErrorCode::UserError);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  }
}
