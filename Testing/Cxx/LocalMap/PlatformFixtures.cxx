// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/PlatformFixtures.h"

#include "Fixtures/TriangleTree.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace
{
std::vector<double> GetValues(vtkPolyData* data, const char* name)
{
  std::vector<double> values;
  if (vtkDataArray* array = data->GetFieldData()->GetArray(name))
  {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      values.push_back(array->GetTuple1(i));
    }
  }
  return values;
}

void SetValues(vtkPolyData* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (double value : values)
  {
    array->InsertNextValue(value);
  }
  data->GetFieldData()->AddArray(array);
}

// Writes x, y and z of the frame in which the platform yaws.
void TurnAxes(int mounting, vtkPolyData* scan)
{
  std::vector<double> matrix = GetValues(scan, "SensorToWorld");
  for (int row = 0; row < 3; ++row)
  {
    double* m = matrix.data() + 4 * row;
    const double x = m[0], y = m[1], z = m[2];
    if (mounting == vtkLMS3DScanFilter::PITCHING)
    {
      m[1] = -z;
      m[2] = y;
    }
    else if (mounting == vtkLMS3DScanFilter::ROLLING)
    {
      m[0] = y;
      m[1] = z;
      m[2] = x;
    }
  }
  SetValues(scan, "SensorToWorld", matrix);
}

void Unfold(vtkPolyData* scan)
{
  const std::vector<double> alphas = GetValues(scan, "AlphaAngles");
  std::vector<double> betas = GetValues(scan, "BetaAngles");
  const int beams = static_cast<int>(alphas.size());
  const int turns = static_cast<int>(betas.size());
  const int center = beams / 2;
  vtkDataArray* ids = scan->GetPointData()->GetArray("BeamId");
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    const int id = static_cast<int>(ids->GetTuple1(i));
    const int off = id % beams - center;
    const int turn = id / beams + (off < 0 ? turns : 0);
    ids->SetTuple1(i, turn * (center + 1) + center - std::abs(off));
  }
  std::vector<double> elevations;
  for (int row = 0; row <= center; ++row)
  {
    elevations.push_back(90.0 - alphas[beams - 1 - row]);
  }
  for (int turn = 0; turn < turns; ++turn)
  {
    betas.push_back(betas[turn] + 180.0);
  }
  SetValues(scan, "AlphaAngles", elevations);
  SetValues(scan, "BetaAngles", betas);
}
} // namespace

std::vector<TestPlatform> GetTestPlatforms()
{
  std::vector<TestPlatform> platforms;
  for (int mounting = 0; mounting < 4; ++mounting)
  {
    const std::string name = vtkLMS3DScanFilter::GetMountingName(mounting);
    platforms.push_back({ name, mounting });
    platforms.push_back({ name + "Ahead", mounting, { 0.05, 0.0, 0.0 } });
    platforms.push_back({ name + "Aside", mounting, { 0.0, 0.1, 0.0 } });
    platforms.push_back({ name + "Behind", mounting, { -0.15, -0.05, 0.1 } });
    platforms.push_back({ name + "Far", mounting, { 0.1, 0.1, -0.2 } });
    platforms.push_back({ name + "Turning", mounting, { 0.0, 0.0, 0.0 }, 75.0 });
    platforms.push_back({ name + "TurningBackAside", mounting, { 0.1, 0.05, 0.0 }, -30.0 });
  }
  return platforms;
}

vtkSmartPointer<vtkPolyData> MakeScan(const MapScene& scene, const TestPlatform& platform)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputData(scene.Surface);
  scan->SetPosition(scene.Position.data());
  scan->SetOrientation(scene.Orientation.data());
  scan->SetMaximumRange(scene.MaximumRange);
  scan->SetAlphaResolution(scene.AlphaResolution);
  scan->SetBetaResolution(90);
  scan->SetBetaRange(0.0, platform.IsFanAlongAxis() ? 178.0 : 360.0);
  scan->SetMounting(platform.Mounting);
  scan->SetAxisOffset(platform.AxisOffset.data());
  scan->SetTurnRate(platform.TurnRate);
  scan->Update();
  return scan->GetOutput();
}

vtkSmartPointer<vtkPolyData> ToYawing(vtkPolyData* scan)
{
  auto yawing = vtkSmartPointer<vtkPolyData>::New();
  yawing->DeepCopy(scan);
  const std::vector<double> field = GetValues(scan, "Mounting");
  const int mounting = field.empty() ? 0 : static_cast<int>(field[0]);
  TurnAxes(mounting, yawing);
  if (mounting == vtkLMS3DScanFilter::YAWING_TOP || mounting == vtkLMS3DScanFilter::ROLLING)
  {
    Unfold(yawing);
  }
  yawing->GetFieldData()->RemoveArray("Mounting");
  return yawing;
}

double GetLargestDistance(vtkPolyData* scan, vtkPolyData* map)
{
  std::vector<Vector> points(map->GetNumberOfPoints());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    map->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  std::vector<TriangleTree::Triangle> triangles;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < map->GetNumberOfCells(); ++cell)
  {
    map->GetCellPoints(cell, corners);
    triangles.push_back({ corners->GetId(0), corners->GetId(1), corners->GetId(2) });
  }
  const TriangleTree surface(points, triangles);
  double largest = 0.0;
  for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
  {
    Vector point;
    scan->GetPoint(i, point.data());
    largest = std::max(largest, surface.GetDistance(point));
  }
  return largest;
}

double GetField(vtkPolyData* map, const char* name)
{
  return map->GetFieldData()->GetArray(name)->GetTuple1(0);
}
