// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapErrors.h"

#include "Table.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>

MapErrors::MapErrors(const BenchmarkScene& scene, vtkPolyData* scan, vtkPolyData* map)
{
  this->Comparison->SetInputData(map);
  this->Comparison->SetSceneData(scene.Surface);
  this->Comparison->SetScanData(scan);
  this->Comparison->Update();
}

std::string MapErrors::Format(const char* name, double factor, int decimals, int component) const
{
  return Table::Format(factor * this->Get(name, component), decimals);
}

double MapErrors::GetMeanOfBoth() const
{
  return 0.5 * (this->Get("MapToScene", 0) + this->Get("SceneToMap", 0));
}

double MapErrors::Get(const char* name, int component) const
{
  vtkDataArray* result = this->Comparison->GetOutput()->GetFieldData()->GetArray(name);
  return result->GetComponent(0, component);
}
