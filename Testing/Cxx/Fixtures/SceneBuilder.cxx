// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/SceneBuilder.h"

#include "Fixtures/SceneFixtures.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <cmath>

SceneBuilder::SceneBuilder()
  : Surface(vtkSmartPointer<vtkPolyData>::New())
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  this->Surface->SetPoints(points);
  vtkNew<vtkCellArray> triangles;
  this->Surface->SetPolys(triangles);
}

vtkIdType SceneBuilder::AddPoint(const Vector& point)
{
  return this->Surface->GetPoints()->InsertNextPoint(point.data());
}

void SceneBuilder::AddTriangle(const Vector& a, const Vector& b, const Vector& c)
{
  this->Surface->GetPolys()->InsertNextCell(
    { this->AddPoint(a), this->AddPoint(b), this->AddPoint(c) });
}

void SceneBuilder::AddQuad(const Vector& a, const Vector& b, const Vector& c, const Vector& d)
{
  const vtkIdType first = this->AddPoint(a);
  this->AddPoint(b);
  const vtkIdType third = this->AddPoint(c);
  this->AddPoint(d);
  this->Surface->GetPolys()->InsertNextCell({ first, first + 1, third });
  this->Surface->GetPolys()->InsertNextCell({ first, third, third + 1 });
}

void SceneBuilder::AddTurnedBox(const Vector& center, const std::array<Vector, 3>& axes)
{
  for (int i = 0; i < 3; ++i)
  {
    const Vector& u = axes[(i + 1) % 3];
    const Vector& v = axes[(i + 2) % 3];
    for (const Vector& middle : { center + axes[i], center - axes[i] })
    {
      this->AddQuad(middle - u - v, middle + u - v, middle + u + v, middle - u + v);
    }
  }
}

void SceneBuilder::AddBox(const Vector& low, const Vector& high)
{
  const Vector half = 0.5 * (high - low);
  this->AddTurnedBox(
    low + half, { { { half[0], 0.0, 0.0 }, { 0.0, half[1], 0.0 }, { 0.0, 0.0, half[2] } } });
}

void SceneBuilder::AddCone(
  const Vector& foot, double radius, double topRadius, double height, int sides)
{
  const Vector top = foot + Vector{ 0.0, 0.0, height };
  const auto getRim = [&](int side, double size)
  {
    const double angle = 2.0 * vtkMath::Pi() * (side % sides) / sides;
    return Vector{ size * std::cos(angle), size * std::sin(angle), 0.0 };
  };
  for (int side = 0; side < sides; ++side)
  {
    const Vector a = foot + getRim(side, radius);
    const Vector b = foot + getRim(side + 1, radius);
    if (topRadius > 0.0)
    {
      const Vector c = top + getRim(side + 1, topRadius);
      const Vector d = top + getRim(side, topRadius);
      this->AddQuad(a, b, c, d);
      this->AddTriangle(c, top, d);
    }
    else
    {
      this->AddTriangle(a, b, top);
    }
  }
}

void SceneBuilder::AddBall(const Vector& center, double radius, int resolution)
{
  this->AddSurface(MakeBall(radius, resolution), center);
}

void SceneBuilder::AddSurface(vtkPolyData* triangles, const Vector& offset)
{
  const vtkIdType first = this->Surface->GetNumberOfPoints();
  for (vtkIdType i = 0; i < triangles->GetNumberOfPoints(); ++i)
  {
    Vector point;
    triangles->GetPoint(i, point.data());
    this->AddPoint(point + offset);
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell)
  {
    triangles->GetCellPoints(cell, corners);
    this->Surface->GetPolys()->InsertNextCell(
      { first + corners->GetId(0), first + corners->GetId(1), first + corners->GetId(2) });
  }
}
