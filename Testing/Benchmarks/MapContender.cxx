// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapContender.h"

#include "Timer.h"

#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkBoxMuellerRandomSequence.h>
#include <vtkContourFilter.h>
#include <vtkDecimatePro.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkQuadricDecimation.h>
#include <vtkSurfaceReconstructionFilter.h>

namespace
{
constexpr double CellsPerDiagonal = 100.0;

// On exact planes all collapses cost vtkQuadricDecimation nothing; it then takes them in an order
// that gathers all edges at a few vertices, and minutes in place of seconds. This much noise
// (metres) spares it that.
constexpr double Shaking = 1e-6;

template <typename Decimation>
MapContender Decimate(const MapContender& grid, vtkPolyData* input, vtkIdType triangles,
  double budget, const std::string& name)
{
  vtkNew<Decimation> decimation;
  decimation->SetInputData(input);
  decimation->SetTargetReduction(
    1.0 - static_cast<double>(triangles) / static_cast<double>(grid.Map->GetNumberOfCells()));
  const double ms = GetBestMilliseconds(budget,
    [&]
    {
      decimation->Modified();
      decimation->Update();
    });
  return { grid.Name + " + " + name, decimation->GetOutput(), grid.Milliseconds + ms };
}

vtkSmartPointer<vtkPolyData> Shake(vtkPolyData* surface)
{
  auto shaken = vtkSmartPointer<vtkPolyData>::New();
  shaken->DeepCopy(surface);
  vtkDataArray* coordinates = shaken->GetPoints()->GetData();
  vtkNew<vtkBoxMuellerRandomSequence> random;
  for (vtkIdType i = 0; i < coordinates->GetNumberOfValues(); ++i, random->Next())
  {
    const double x = coordinates->GetComponent(i / 3, static_cast<int>(i % 3));
    coordinates->SetComponent(
      i / 3, static_cast<int>(i % 3), x + random->GetScaledValue(0.0, Shaking));
  }
  return shaken;
}

// The scan's arrays give the beam of each return.
void GetSensor(vtkPolyData* scan, double sensor[3])
{
  vtkDataArray* matrix = scan->GetFieldData()->GetArray("SensorToWorld");
  for (int axis = 0; axis < 3; ++axis)
  {
    sensor[axis] = matrix->GetTuple1(4 * axis + 3);
  }
}
} // namespace

vtkSmartPointer<vtkPolyData> AddRangeNoise(vtkPolyData* scan, double sigma)
{
  auto noisy = vtkSmartPointer<vtkPolyData>::New();
  noisy->DeepCopy(scan);
  vtkDataArray* ranges = noisy->GetPointData()->GetArray("Range");
  double sensor[3];
  GetSensor(scan, sensor);
  vtkNew<vtkBoxMuellerRandomSequence> random;
  for (vtkIdType i = 0; i < noisy->GetNumberOfPoints(); ++i, random->Next())
  {
    const double range = ranges->GetTuple1(i);
    const double measured = range + random->GetScaledValue(0.0, sigma);
    ranges->SetTuple1(i, measured);
    double point[3];
    noisy->GetPoint(i, point);
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = sensor[axis] + (point[axis] - sensor[axis]) * (measured / range);
    }
    noisy->GetPoints()->SetPoint(i, point);
  }
  return noisy;
}

double GetFairBound(double noise)
{
  return noise > 0.0 ? 4.0 * noise : 0.01;
}

MapContender MakeLocalMap(
  vtkPolyData* scan, double maximumError, double depthStep, double budget, const MapGaps& gaps)
{
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> filter;
  filter->SetInputData(scan);
  filter->SetMaximumError(maximumError);
  filter->SetDepthStep(depthStep);
  filter->SetMaximumGapSize(gaps.MaximumGapSize);
  filter->SetMaximumSpeckleSize(gaps.MaximumSpeckleSize);
  filter->SetNumberOfThreads(1);
  const double ms = GetBestMilliseconds(budget,
    [&]
    {
      filter->Modified();
      filter->Update();
    });
  return { maximumError > 0.0 ? "LMS3D map" : "LMS3D grid", filter->GetOutput(), ms };
}

MapContender DecimateByQuadrics(const MapContender& grid, vtkIdType triangles, double budget)
{
  return Decimate<vtkQuadricDecimation>(
    grid, Shake(grid.Map), triangles, budget, "vtkQuadricDecimation");
}

MapContender DecimatePro(const MapContender& grid, vtkIdType triangles, double budget)
{
  return Decimate<vtkDecimatePro>(grid, grid.Map, triangles, budget, "vtkDecimatePro");
}

MapContender ReconstructFromPoints(vtkPolyData* scan, double budget)
{
  vtkNew<vtkSurfaceReconstructionFilter> distance;
  distance->SetInputData(scan);
  distance->SetSampleSpacing(scan->GetLength() / CellsPerDiagonal);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputConnection(distance->GetOutputPort());
  contour->SetValue(0, 0.0);
  const double ms = GetBestMilliseconds(budget,
    [&]
    {
      distance->Modified();
      contour->Update();
    });
  return { "vtkSurfaceReconstructionFilter", contour->GetOutput(), ms };
}
