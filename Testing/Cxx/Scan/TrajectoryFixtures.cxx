// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/TrajectoryFixtures.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <vector>

const std::vector<Point> ThreePositions = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 2, 0 } };

vtkSmartPointer<vtkPolyData> MakePoses(const std::vector<Point>& positions)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& position : positions)
  {
    points->InsertNextPoint(position.data());
  }
  auto poses = vtkSmartPointer<vtkPolyData>::New();
  poses->SetPoints(points);
  return poses;
}

void AddLine(vtkPolyData* poses, const std::vector<vtkIdType>& order)
{
  if (poses->GetNumberOfLines() == 0)
  {
    poses->SetLines(vtkNew<vtkCellArray>());
  }
  poses->GetLines()->InsertNextCell(static_cast<vtkIdType>(order.size()), order.data());
}

void AddArray(
  vtkPolyData* poses, const char* name, int components, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (double value : values)
  {
    array->InsertNextValue(value);
  }
  poses->GetPointData()->AddArray(array);
}

vtkSmartPointer<vtkLMS3DScanFilter> MakeScanAlong(vtkPolyData* poses)
{
  auto scan = MakeScan(MakeBall(5.0));
  SetGrid(scan, 9, 8);
  scan->SetTrajectoryData(poses);
  return scan;
}

std::vector<double> GetTimes(vtkLMS3DScanFilter* scan, int port)
{
  scan->UpdateInformation();
  vtkInformation* info = scan->GetOutputInformation(port);
  const double* first = info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  return first ? std::vector<double>(
                   first, first + info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()))
               : std::vector<double>();
}
