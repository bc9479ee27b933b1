// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/lms3dJoinedArrays.h"

#include <vtkAbstractArray.h>

#include <algorithm>

namespace
{
bool HasArrayLike(const lms3dTupleSource& source, vtkAbstractArray* model)
{
  vtkAbstractArray* array = source.Arrays->GetAbstractArray(model->GetName());
  return array && array->GetDataType() == model->GetDataType() &&
    array->GetNumberOfComponents() == model->GetNumberOfComponents() &&
    array->GetNumberOfTuples() >= source.Size;
}

vtkSmartPointer<vtkAbstractArray> Join(
  const std::vector<lms3dTupleSource>& sources, vtkIdType count, vtkAbstractArray* model)
{
  auto joined =
    vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(model->GetDataType()));
  joined->SetName(model->GetName());
  joined->SetNumberOfComponents(model->GetNumberOfComponents());
  joined->SetNumberOfTuples(count);
  joined->CopyComponentNames(model);
  for (const lms3dTupleSource& source : sources)
  {
    joined->InsertTuples(
      source.Targets, source.Tuples, source.Arrays->GetAbstractArray(model->GetName()));
  }
  return joined;
}
} // namespace

void lms3dJoinArrays(
  const std::vector<lms3dTupleSource>& sources, vtkIdType count, vtkFieldData* joined)
{
  const int arrays = sources.empty() ? 0 : sources.front().Arrays->GetNumberOfArrays();
  for (int i = 0; i < arrays; ++i)
  {
    vtkAbstractArray* model = sources.front().Arrays->GetAbstractArray(i);
    if (model->GetName() && !joined->HasArray(model->GetName()) &&
      std::all_of(sources.begin(), sources.end(),
        [model](const lms3dTupleSource& source) { return HasArrayLike(source, model); }))
    {
      joined->AddArray(Join(sources, count, model));
    }
  }
}
