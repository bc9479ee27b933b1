// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dSceneOutput.h"

#include <vtkAbstractArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <utility>

namespace
{
struct Size
{
  explicit Size(const lms3dScene& scene)
  {
    for (const lms3dShape& shape : scene.Shapes)
    {
      this->Points += static_cast<vtkIdType>(shape.Mesh->Points.size());
      this->Triangles += static_cast<vtkIdType>(shape.Mesh->Triangles.size());
    }
  }

  vtkIdType Points = 0;
  vtkIdType Triangles = 0;
};

// (x, y, z) becomes (x, -z, y).
lms3dTransform GetTurn(bool turnYUp)
{
  return turnYUp ? lms3dTransform::Frame({ 1, 0, 0 }, { 0, 0, 1 }, { 0, -1, 0 }) : lms3dTransform();
}

void AddPoints(const lms3dScene& scene, bool turnYUp, vtkPolyData* surface)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(Size(scene).Points);
  double* out = coordinates->GetPointer(0);
  for (const lms3dShape& shape : scene.Shapes)
  {
    const lms3dTransform toScene = GetTurn(turnYUp) * shape.ToWorld;
    for (const lms3dPoint& point : shape.Mesh->Points)
    {
      const lms3dPoint placed = toScene.Apply(point);
      out = std::copy(placed.begin(), placed.end(), out);
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  surface->SetPoints(points);
}

// A mirror reverses the orientation of triangles, so their corners are swapped back.
vtkIdType* AddTriangles(const lms3dShape& shape, vtkIdType firstPoint, vtkIdType* out)
{
  const bool isMirror = shape.ToWorld.IsMirror();
  for (const std::array<std::int32_t, 3>& triangle : shape.Mesh->Triangles)
  {
    *out++ = firstPoint + triangle[0];
    *out++ = firstPoint + triangle[isMirror ? 2 : 1];
    *out++ = firstPoint + triangle[isMirror ? 1 : 2];
  }
  return out;
}

void AddTriangles(const lms3dScene& scene, vtkPolyData* surface)
{
  const vtkIdType count = Size(scene).Triangles;
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(3 * count);
  vtkIdType* out = connectivity->GetPointer(0);
  vtkIdType firstPoint = 0;
  for (const lms3dShape& shape : scene.Shapes)
  {
    out = AddTriangles(shape, firstPoint, out);
    firstPoint += static_cast<vtkIdType>(shape.Mesh->Points.size());
  }
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  vtkIdType* offset = offsets->GetPointer(0);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offset[i] = 3 * i;
  }
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, connectivity);
  surface->SetPolys(polygons);
}

void AddShapes(const lms3dScene& scene, vtkPolyData* surface)
{
  vtkNew<vtkIntArray> shapeIds;
  shapeIds->SetName("ShapeId");
  shapeIds->SetNumberOfValues(Size(scene).Triangles);
  vtkNew<vtkStringArray> names;
  names->SetName("ShapeNames");
  names->GetInformation()->Set(vtkAbstractArray::GUI_HIDE(), 1); // no choice for colouring
  int* shapeId = shapeIds->GetPointer(0);
  for (const lms3dShape& shape : scene.Shapes)
  {
    const int id = static_cast<int>(names->InsertNextValue(shape.Name));
    shapeId = std::fill_n(shapeId, shape.Mesh->Triangles.size(), id);
  }
  surface->GetCellData()->AddArray(shapeIds);
  surface->GetFieldData()->AddArray(names);
}

void AddColors(const lms3dScene& scene, vtkPolyData* surface)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Color");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(Size(scene).Triangles);
  unsigned char* out = colors->GetPointer(0);
  for (const lms3dShape& shape : scene.Shapes)
  {
    const std::vector<lms3dColor>& ofTriangles = shape.Mesh->Colors;
    for (std::size_t i = 0; i < shape.Mesh->Triangles.size(); ++i)
    {
      const lms3dColor& color = ofTriangles.empty() ? shape.Color : ofTriangles[i];
      out = std::copy(color.begin(), color.end(), out);
      *out++ = shape.Opacity;
    }
  }
  surface->GetCellData()->AddArray(colors);
}
} // namespace

bool lms3dHasSurface(const lms3dScene& scene)
{
  return Size(scene).Triangles > 0;
}

void lms3dWriteScene(const lms3dScene& scene, bool turnYUp, vtkPolyData* surface)
{
  AddPoints(scene, turnYUp, surface);
  AddTriangles(scene, surface);
  AddShapes(scene, surface);
  AddColors(scene, surface);
}
