// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapJudgeFixture.h"

#include "Fixtures/SceneFixtures.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

MapJudge::MapJudge()
{
  this->Scene.Surface = MakeBall(2.0, 96);
  this->Scene.AlphaResolution = 31;
  this->Scene.BetaResolution = 30;
  this->Scan = MakeScan(this->Scene);
  this->TakeGrid();
}

void MapJudge::TakeGrid()
{
  this->Map->DeepCopy(MakeMap(this->Scan, 0.0));
  this->AddValue<vtkIntArray>("NumberOfPatches", 1);
  this->AddValue<vtkIntArray>(
    "NumberOfReturns", static_cast<double>(this->Scan->GetNumberOfPoints()));
  this->AddValue<vtkIntArray>(
    "NumberOfReturnsOnPatches", static_cast<double>(this->Scan->GetNumberOfPoints()));
  this->AddValue<vtkDoubleArray>("LargestDeviation", 0.0);
  this->ReadTriangles();
}

void MapJudge::ReadTriangles()
{
  this->Triangles.clear();
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < this->Map->GetNumberOfCells(); ++cell)
  {
    this->Map->GetCellPoints(cell, corners);
    this->Triangles.push_back({ corners->GetId(0), corners->GetId(1), corners->GetId(2) });
  }
}

vtkIdType MapJudge::AddPoint(const Vector& point)
{
  this->Map->GetPointData()->GetArray("Range")->InsertNextTuple1(GetLength(point));
  const Vector normal = (-1.0 / GetLength(point)) * point;
  this->Map->GetPointData()->GetNormals()->InsertNextTuple(normal.data());
  return this->Map->GetPoints()->InsertNextPoint(point.data());
}

Vector MapJudge::GetPoint(vtkIdType number)
{
  Vector point;
  this->Map->GetPoint(number, point.data());
  return point;
}

void MapJudge::MovePoint(vtkIdType number, double factor)
{
  const Vector to = factor * this->GetPoint(number);
  this->Map->GetPoints()->SetPoint(number, to.data());
  this->Map->GetPointData()->GetArray("Range")->SetTuple1(number, GetLength(to));
}

void MapJudge::AddFacet(double aside, double factor)
{
  constexpr double Size = 0.01;
  const double range = factor * this->Scan->GetPointData()->GetArray("Range")->GetTuple1(0);
  const auto add = [&](double x, double y) {
    return this->AddPoint(range * Normalize({ aside + Size * x, Size * y, -1.0 }));
  };
  const vtkIdType a = add(1.0, 0.0);
  const vtkIdType b = add(-1.0, 1.0);
  this->Triangles.push_back({ a, b, add(-1.0, -1.0) });
}

void MapJudge::MoveReturn(vtkIdType number, double factor)
{
  Vector point;
  this->Scan->GetPoint(number, point.data());
  const Vector to = factor * point;
  this->Scan->GetPoints()->SetPoint(number, to.data());
  vtkDataArray* ranges = this->Scan->GetPointData()->GetArray("Range");
  ranges->SetTuple1(number, factor * ranges->GetTuple1(number));
}

MapVerdict MapJudge::Judge()
{
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> patches;
  patches->SetName("PatchId");
  for (const auto& [a, b, c] : this->Triangles)
  {
    cells->InsertNextCell({ a, b, c });
    patches->InsertNextValue(0);
  }
  this->Map->SetPolys(cells);
  this->Map->GetCellData()->AddArray(patches);
  this->Promise.Scene = this->Scene.Surface;
  return JudgeMap(this->Scan, this->Map, this->Promise);
}

void MapJudge::ExpectBreach(const std::string& law)
{
  const MapVerdict verdict = this->Judge();
  EXPECT_GT(verdict.GetNumberOfBreaches(law), 0) << law << verdict;
}
