// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "EqualDecimation.h"

#include "vtkLMS3DMapComparison.h"

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <array>
#include <cmath>
#include <set>

namespace
{
constexpr double Precision = 1.02;
// A smaller map is found within this number of triangles.
constexpr double Fewest = 20.0;

using Point = std::array<double, 3>;

std::set<Point> GetCorners(vtkPolyData* grid)
{
  std::set<Point> corners;
  vtkNew<vtkIdList> cell;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    grid->GetCellPoints(i, cell);
    for (vtkIdType corner = 0; corner < cell->GetNumberOfIds(); ++corner)
    {
      Point point;
      grid->GetPoint(cell->GetId(corner), point.data());
      corners.insert(point);
    }
  }
  return corners;
}

// The returns that are corners of the grid.
vtkSmartPointer<vtkPolyData> SelectReturns(vtkPolyData* scan, vtkPolyData* grid)
{
  const std::set<Point> corners = GetCorners(grid);
  auto selected = vtkSmartPointer<vtkPolyData>::New();
  selected->GetFieldData()->ShallowCopy(scan->GetFieldData());
  selected->GetPointData()->CopyAllocate(scan->GetPointData());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
  {
    Point point;
    scan->GetPoint(i, point.data());
    if (corners.count(point) > 0)
    {
      const vtkIdType number = points->InsertNextPoint(point.data());
      vertices->InsertNextCell(1, &number);
      selected->GetPointData()->CopyData(scan->GetPointData(), i, number);
    }
  }
  selected->SetPoints(points);
  selected->SetVerts(vertices);
  return selected;
}
} // namespace

EqualDecimation::EqualDecimation(
  const BenchmarkScene& scene, vtkPolyData* scan, const MapContender& grid)
  : Scene(scene)
  , Grid(grid)
  , Scan(SelectReturns(scan, grid.Map))
{
}

double EqualDecimation::GetLargestDistance(vtkIdType triangles) const
{
  vtkNew<vtkLMS3DMapComparison> comparison;
  comparison->SetInputData(DecimateByQuadrics(this->Grid, triangles, 0.0).Map);
  comparison->SetSceneData(this->Scene.Surface);
  comparison->SetScanData(this->Scan);
  comparison->SetNumberOfSamples(1);
  comparison->Update();
  return comparison->GetLargestReturnDistance();
}

std::optional<vtkIdType> EqualDecimation::FindTriangles(double bound) const
{
  double few = Fewest;
  double enough = static_cast<double>(this->Grid.Map->GetNumberOfCells());
  const double all = enough;
  while (enough > Precision * few)
  {
    const double middle = std::sqrt(few * enough);
    (this->GetLargestDistance(static_cast<vtkIdType>(middle)) > bound ? few : enough) = middle;
  }
  return enough < all ? std::optional(static_cast<vtkIdType>(enough)) : std::nullopt;
}
