// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/GapFixtures.h"

#include "Fixtures/SceneFixtures.h"
#include "Fixtures/TriangleTree.h"

#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace
{
double GetDegrees(int index)
{
  return index - WallScan::Middle;
}

Vector GetDirection(const GapBeam& beam)
{
  const double alpha = vtkMath::RadiansFromDegrees(GetDegrees(beam.Beam));
  const double beta = vtkMath::RadiansFromDegrees(GetDegrees(beam.Turn));
  return { std::cos(alpha) * std::cos(beta), -std::cos(alpha) * std::sin(beta), std::sin(alpha) };
}
} // namespace

WallScan::WallScan()
{
  for (int turn = 0; turn < Size; ++turn)
  {
    for (int beam = 0; beam < Size; ++beam)
    {
      this->Ranges.push_back(Distance / GetDirection({ turn, beam })[0]);
    }
  }
}

WallScan& WallScan::Lose(const std::vector<GapBeam>& beams)
{
  for (const GapBeam& beam : beams)
  {
    this->Set(beam, 0.0);
  }
  return *this;
}

WallScan& WallScan::Set(const GapBeam& beam, double range)
{
  this->Ranges[GetBeamId(beam)] = range;
  return *this;
}

vtkSmartPointer<vtkPolyData> WallScan::Make() const
{
  const std::vector<double> angles = MakeAngles(GetDegrees(0), GetDegrees(Size - 1), Size);
  return MakeScan(angles, angles,
    [this](int turn, int beam) {
      return this->GetRange({ turn, beam });
    });
}

std::vector<GapBeam> GetSquare(const GapBeam& first, int size)
{
  std::vector<GapBeam> square;
  square.reserve(static_cast<std::size_t>(size) * size);
  for (int i = 0; i < size * size; ++i)
  {
    square.push_back({ first.Turn + i / size, first.Beam + i % size });
  }
  return square;
}

void AddStatus(vtkPolyData* scan, const std::vector<int>& beamIds, int value)
{
  vtkNew<vtkUnsignedCharArray> status;
  status->SetName("Status");
  status->SetNumberOfValues(WallScan::Size * WallScan::Size);
  status->FillValue(0);
  for (int beamId : beamIds)
  {
    status->SetValue(beamId, static_cast<unsigned char>(value));
  }
  scan->GetFieldData()->AddArray(status);
}

vtkSmartPointer<vtkPolyData> MakeMap(vtkPolyData* scan, const GapProperties& properties)
{
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> filter;
  filter->SetInputDataObject(scan);
  filter->SetMaximumError(properties.MaximumError);
  filter->SetMaximumGapSize(properties.MaximumGapSize);
  filter->SetMaximumSpeckleSize(properties.MaximumSpeckleSize);
  filter->SetKeepSpeckles(properties.KeepSpeckles);
  filter->SetNumberOfThreads(properties.NumberOfThreads);
  EXPECT_EQ(UpdateAndGetError(filter), "");
  return filter->GetOutput();
}

std::vector<int> GetFieldValues(vtkPolyData* map, const char* name)
{
  vtkDataArray* array = map->GetFieldData()->GetArray(name);
  std::vector<int> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    values.push_back(static_cast<int>(array->GetTuple1(i)));
  }
  return values;
}

int CountHits(vtkPolyData* map, const GapBeam& beam)
{
  std::vector<Vector> points(map->GetNumberOfPoints());
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    map->GetPoint(i, points[i].data());
  }
  std::vector<TriangleTree::Triangle> triangles;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < map->GetNumberOfCells(); ++cell)
  {
    map->GetCellPoints(cell, corners);
    triangles.push_back({ corners->GetId(0), corners->GetId(1), corners->GetId(2) });
  }
  std::vector<TriangleTree::Hit> hits;
  // A little beside the beam, so that no edge is hit twice.
  const Vector aside = { 0.0, 1.7e-4, 1.1e-4 };
  TriangleTree(points, triangles).Cast(Normalize(GetDirection(beam) + aside), 0.0, hits);
  return static_cast<int>(hits.size());
}

double CountReturnsOnAll(vtkPolyData* map)
{
  double sum = 0.0;
  for (const char* kind : { "Patches", "Grid", "Facets", "Speckles", "RepeatedTurns" })
  {
    const std::string name = std::string("NumberOfReturnsOn") + kind;
    sum += map->GetFieldData()->HasArray(name.c_str()) ? GetField(map, name.c_str()) : 0.0;
  }
  return sum;
}

vtkSmartPointer<vtkPolyData> AddStrays(vtkPolyData* scan, double share, Random& random)
{
  auto strayed = vtkSmartPointer<vtkPolyData>::New();
  strayed->DeepCopy(scan);
  vtkDataArray* matrix = scan->GetFieldData()->GetArray("SensorToWorld");
  const Vector sensor = { matrix->GetTuple1(3), matrix->GetTuple1(7), matrix->GetTuple1(11) };
  vtkDataArray* ranges = strayed->GetPointData()->GetArray("Range");
  for (vtkIdType i = 0; i < strayed->GetNumberOfPoints(); ++i)
  {
    if (random.Get() < share)
    {
      Vector point;
      strayed->GetPoint(i, point.data());
      const double range = random.Get(0.3, 8.0);
      const Vector to = sensor + range / ranges->GetTuple1(i) * (point - sensor);
      strayed->GetPoints()->SetPoint(i, to.data());
      ranges->SetTuple1(i, range);
    }
  }
  return strayed;
}
