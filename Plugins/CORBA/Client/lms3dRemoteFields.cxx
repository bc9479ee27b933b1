// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Client/lms3dRemoteFields.h"

#include "Pipeline/lms3dArray.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeUInt64Array.h>

void lms3dSetPoints(vtkDoubleArray* points, vtkPolyData* data)
{
  vtkNew<vtkPoints> all;
  all->SetData(points);
  data->SetPoints(all);
}

void lms3dSetTriangles(vtkDoubleArray* points, vtkTypeInt32Array* connectivity, vtkPolyData* data)
{
  lms3dSetPoints(points, data);
  const std::size_t count = static_cast<std::size_t>(connectivity->GetNumberOfValues()) / 3;
  const auto offsets = lms3dMakeArray<vtkTypeInt32Array>("Offsets", count + 1);
  lms3dFillOffsets(offsets->GetPointer(0), count, 3);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  data->SetPolys(cells);
}

void lms3dAddField(const char* name, std::uint64_t number, vtkFieldData* fieldData)
{
  const auto array = lms3dMakeArray<vtkTypeUInt64Array>(name, 1);
  array->SetValue(0, number);
  lms3dAddHiddenArray(array, fieldData);
}

void lms3dAddField(const char* name, const char* text, vtkFieldData* fieldData)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  lms3dAddHiddenArray(array, fieldData);
}
