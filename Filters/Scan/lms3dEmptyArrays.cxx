// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/lms3dEmptyArrays.h"

#include <vtkAbstractArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkMultiProcessStream.h>
#include <vtkSmartPointer.h>

#include <string>

namespace
{
// Without a name for each component, VTK has none.
std::string GetComponentName(vtkAbstractArray* array, int component)
{
  const char* const name =
    array->HasAComponentName() ? array->GetComponentName(component) : nullptr;
  return name ? name : "";
}

void Describe(vtkDataSetAttributes* data, vtkMultiProcessStream& stream)
{
  stream << data->GetNumberOfArrays();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    stream << std::string(array->GetName()) << array->GetDataType()
           << array->GetNumberOfComponents() << data->IsArrayAnAttribute(i);
    for (int component = 0; component < array->GetNumberOfComponents(); ++component)
    {
      stream << GetComponentName(array, component);
    }
  }
}

void AddArray(vtkMultiProcessStream& stream, vtkDataSetAttributes* data)
{
  std::string name;
  int type = 0;
  int components = 0;
  int attribute = 0;
  stream >> name >> type >> components >> attribute;
  const auto array = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  for (int component = 0; component < components; ++component)
  {
    stream >> name;
    if (!name.empty())
    {
      array->SetComponentName(component, name.c_str());
    }
  }
  data->AddArray(array);
  if (attribute >= 0)
  {
    data->SetActiveAttribute(array->GetName(), attribute);
  }
}
} // namespace

void lms3dAddEmptyArrays(const lms3dProcesses& processes, vtkDataSetAttributes* data)
{
  vtkMultiProcessStream stream;
  processes.RunCollectively(
    [&]
    {
      if (processes.IsFirst())
      {
        Describe(data, stream);
      }
    });
  processes.Broadcast(stream);
  processes.RunCollectively(
    [&]
    {
      int count = 0;
      for (stream >> count; !processes.IsFirst() && count > 0; --count)
      {
        AddArray(stream, data);
      }
    });
}
