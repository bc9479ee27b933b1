// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/DetectionFixtures.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>

void SetReflectances(vtkDataSet* scene, const std::vector<double>& values, const char* name)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (double value : values)
  {
    array->InsertNextValue(value);
  }
  scene->GetCellData()->AddArray(array);
}

vtkSmartPointer<vtkPolyData> Paint(vtkSmartPointer<vtkPolyData> scene, double reflectance)
{
  SetReflectances(
    scene, std::vector<double>(static_cast<std::size_t>(scene->GetNumberOfCells()), reflectance));
  return scene;
}

vtkSmartPointer<vtkPolyData> MakeWall(double distance, double degrees)
{
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  const double x = std::sin(angle);
  const double z = std::cos(angle);
  return MakePolygon({ { distance + x, -1.0, -z }, { distance + x, 1.0, -z },
    { distance - x, 1.0, z }, { distance - x, -1.0, z } });
}

vtkSmartPointer<vtkLMS3DScanFilter> MakeBeam(vtkDataObject* scene)
{
  auto scan = MakeScan(scene);
  SetGrid(scan, 1, 1);
  scan->SetAlphaRange(0.0, 0.0);
  scan->SetBetaRange(0.0, 0.0);
  return scan;
}

void SeeTenPercentAtTenMetres(vtkLMS3DScanFilter* scan)
{
  scan->SetRangeAtTenPercent(10.0);
  scan->SetReflectanceArray("Reflectance");
  scan->SetMaximumRange(std::numeric_limits<double>::infinity());
}

bool HasReturn(vtkLMS3DScanFilter* scan)
{
  EXPECT_EQ(UpdateAndGetError(scan), "");
  return scan->GetOutput()->GetNumberOfPoints() > 0;
}

std::vector<int> GetStatus(vtkLMS3DScanFilter* scan)
{
  vtkDataArray* ofImage = scan->GetRangeImage()->GetPointData()->GetArray("Status");
  vtkDataArray* ofScan = scan->GetOutput()->GetFieldData()->GetArray("Status");
  EXPECT_TRUE(ofImage && ofScan);
  if (!ofImage || !ofScan)
  {
    return {};
  }
  EXPECT_EQ(ofImage->GetDataType(), VTK_UNSIGNED_CHAR);
  // One copy in memory.
  EXPECT_EQ(ofImage->GetVoidPointer(0), ofScan->GetVoidPointer(0));
  std::vector<int> status;
  status.reserve(ofImage->GetNumberOfTuples());
  for (vtkIdType i = 0; i < ofImage->GetNumberOfTuples(); ++i)
  {
    status.push_back(static_cast<int>(ofImage->GetTuple1(i)));
  }
  return status;
}
