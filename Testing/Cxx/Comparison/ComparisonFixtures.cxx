// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/ComparisonFixtures.h"

#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

void AddDoubles(vtkPolyData* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->GetFieldData()->AddArray(array);
}

vtkSmartPointer<vtkPolyData> MakePose(
  const Point& sensor, const std::vector<double>& alphas, const std::vector<double>& betas)
{
  auto pose = vtkSmartPointer<vtkPolyData>::New();
  AddDoubles(pose, "AlphaAngles", alphas);
  AddDoubles(pose, "BetaAngles", betas);
  AddDoubles(pose, "SensorToWorld",
    { 1, 0, 0, sensor[0], 0, 1, 0, sensor[1], 0, 0, 1, sensor[2], 0, 0, 0, 1 });
  return pose;
}

vtkSmartPointer<vtkPolyData> Transform(vtkPolyData* surface, vtkTransform* transform)
{
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputData(surface);
  filter->SetTransform(transform);
  filter->Update();
  return filter->GetOutput();
}

Comparison::Comparison(vtkPolyData* map, vtkDataObject* scene, const Point& sensor)
  : Comparison(map, scene, MakePose(sensor))
{
}

Comparison::Comparison(vtkPolyData* map, vtkDataObject* scene, vtkPolyData* scan)
{
  this->Filter->SetInputData(map);
  this->Filter->SetSceneData(scene);
  this->Filter->SetScanData(scan);
}

vtkLMS3DMapComparison* Comparison::Update()
{
  this->Filter->Update();
  return this->Filter;
}

double Comparison::GetField(const char* name, int component)
{
  vtkDataArray* result = this->Update()->GetOutput()->GetFieldData()->GetArray(name);
  EXPECT_NE(result, nullptr) << name;
  return result ? result->GetComponent(0, component) : -1.0;
}

void Comparison::ExpectErrors(
  const char* name, const std::array<double, 4>& expected, double allowed)
{
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_NEAR(this->GetField(name, i), expected[i], allowed) << name << " component " << i;
  }
}

void Comparison::ExpectError(const std::string& text)
{
  const std::string error = UpdateAndGetError(this->Filter);
  EXPECT_NE(error.find(text), std::string::npos) << error;
  EXPECT_EQ(this->Filter->GetErrorCode(), vtkErrorCode::UserError);
  this->ExpectNoResults();
}

void Comparison::ExpectNoResults()
{
  for (int port = 0; port < 2; ++port)
  {
    vtkPolyData* output = vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(port));
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
  }
  EXPECT_TRUE(std::isnan(this->Filter->GetMapToSceneMean()));
  EXPECT_TRUE(std::isnan(this->Filter->GetFScore()));
  EXPECT_EQ(this->Filter->GetMapTriangles(), 0);
}

vtkPolyData* Comparison::GetScenePoints()
{
  return vtkPolyData::SafeDownCast(this->Update()->GetOutputDataObject(1));
}
