// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapFixtures.h"

#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
vtkSmartPointer<vtkDoubleArray> MakeArray(const char* name, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  for (double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

// By the method of Box and Muller.
double GetNormal(Random& random)
{
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.Get()));
  return radius * std::cos(2.0 * vtkMath::Pi() * random.Get());
}

void MixIn(vtkFieldData* data, std::vector<std::uint64_t>& hashes)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = data->GetArray(i)) // Arrays of strings are not numeric.
    {
      hashes.push_back(Hash(array));
    }
  }
}
} // namespace

vtkSmartPointer<vtkPolyData> MakeScan(const MapScene& scene, bool hasStatus)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputData(scene.Surface);
  scan->SetPosition(scene.Position.data());
  scan->SetOrientation(scene.Orientation.data());
  scan->SetMaximumRange(scene.MaximumRange);
  scan->SetAlphaRange(scene.AlphaRange.data());
  scan->SetBetaRange(scene.BetaRange.data());
  scan->SetAlphaResolution(scene.AlphaResolution);
  scan->SetBetaResolution(scene.BetaResolution);
  scan->SetComputeStatus(hasStatus);
  scan->Update();
  return scan->GetOutput();
}

std::vector<double> MakeAngles(double first, double last, int count)
{
  std::vector<double> angles(count);
  for (int i = 0; i < count; ++i)
  {
    angles[i] = count == 1 ? first : (first * (count - 1 - i) + last * i) / (count - 1);
  }
  return angles;
}

vtkSmartPointer<vtkPolyData> MakeScan(const std::vector<double>& alphas,
  const std::vector<double>& betas, const std::function<double(int turn, int number)>& getRange)
{
  auto scan = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIntArray> beamIds;
  beamIds->SetName("BeamId");
  vtkNew<vtkIdTypeArray> cellIds;
  cellIds->SetName("CellId");
  std::vector<double> ranges;
  for (std::size_t turn = 0; turn < betas.size(); ++turn)
  {
    for (std::size_t number = 0; number < alphas.size(); ++number)
    {
      const double range = getRange(static_cast<int>(turn), static_cast<int>(number));
      if (range > 0.0)
      {
        const double alpha = vtkMath::RadiansFromDegrees(alphas[number]);
        const double beta = vtkMath::RadiansFromDegrees(betas[turn]);
        const double level = std::abs(alphas[number]) == 90.0 ? 0.0 : range * std::cos(alpha);
        points->InsertNextPoint(
          level * std::cos(beta), -level * std::sin(beta), range * std::sin(alpha));
        beamIds->InsertNextValue(static_cast<int>(turn * alphas.size() + number));
        cellIds->InsertNextValue(0);
        ranges.push_back(range);
      }
    }
  }
  scan->SetPoints(points);
  scan->GetPointData()->AddArray(MakeArray("Range", ranges));
  scan->GetPointData()->AddArray(beamIds);
  scan->GetPointData()->AddArray(cellIds);
  scan->GetFieldData()->AddArray(MakeArray("AlphaAngles", alphas));
  scan->GetFieldData()->AddArray(MakeArray("BetaAngles", betas));
  scan->GetFieldData()->AddArray(
    MakeArray("SensorToWorld", { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }));
  return scan;
}

vtkSmartPointer<vtkPolyData> AddNoise(vtkPolyData* scan, double sigma, Random& random)
{
  auto noisy = vtkSmartPointer<vtkPolyData>::New();
  noisy->DeepCopy(scan);
  vtkDataArray* matrix = scan->GetFieldData()->GetArray("SensorToWorld");
  const Vector sensor = { matrix->GetTuple1(3), matrix->GetTuple1(7), matrix->GetTuple1(11) };
  vtkDataArray* ranges = noisy->GetPointData()->GetArray("Range");
  for (vtkIdType i = 0; i < noisy->GetNumberOfPoints(); ++i)
  {
    Vector point;
    noisy->GetPoint(i, point.data());
    const double range = ranges->GetTuple1(i);
    const double maximum = std::min(4.0 * sigma, 0.5 * range);
    const double moved = range + std::clamp(sigma * GetNormal(random), -maximum, maximum);
    const Vector to = sensor + moved / range * (point - sensor);
    noisy->GetPoints()->SetPoint(i, to.data());
    ranges->SetTuple1(i, moved);
  }
  return noisy;
}

namespace
{
int CountAngles(vtkPolyData* scan, const char* name)
{
  return static_cast<int>(scan->GetFieldData()->GetArray(name)->GetNumberOfTuples());
}

vtkSmartPointer<vtkPolyData> Renumber(vtkPolyData* scan, const char* anglesName,
  const std::function<int(int turn, int number)>& getBeamId)
{
  auto reversed = vtkSmartPointer<vtkPolyData>::New();
  reversed->DeepCopy(scan);
  vtkDataArray* from = scan->GetFieldData()->GetArray(anglesName);
  const vtkIdType count = from->GetNumberOfTuples();
  for (vtkIdType i = 0; i < count; ++i)
  {
    reversed->GetFieldData()->GetArray(anglesName)->SetTuple1(i, from->GetTuple1(count - 1 - i));
  }
  const int beams = CountAngles(scan, "AlphaAngles");
  vtkDataArray* beamIds = reversed->GetPointData()->GetArray("BeamId");
  for (vtkIdType i = 0; i < beamIds->GetNumberOfTuples(); ++i)
  {
    const auto id = static_cast<int>(beamIds->GetTuple1(i));
    beamIds->SetTuple1(i, getBeamId(id / beams, id % beams));
  }
  return reversed;
}
} // namespace

vtkSmartPointer<vtkPolyData> ReverseTurns(vtkPolyData* scan)
{
  const int beams = CountAngles(scan, "AlphaAngles");
  const int turns = CountAngles(scan, "BetaAngles");
  return Renumber(
    scan, "BetaAngles", [&](int turn, int number) { return (turns - 1 - turn) * beams + number; });
}

vtkSmartPointer<vtkPolyData> ReverseFan(vtkPolyData* scan)
{
  const int beams = CountAngles(scan, "AlphaAngles");
  return Renumber(
    scan, "AlphaAngles", [&](int turn, int number) { return turn * beams + beams - 1 - number; });
}

vtkSmartPointer<vtkPolyData> MakeMap(
  vtkPolyData* scan, double maximumError, int threads, double depthStep)
{
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> filter;
  filter->SetInputDataObject(scan);
  filter->SetMaximumError(maximumError);
  filter->SetDepthStep(depthStep);
  filter->SetNumberOfThreads(threads);
  EXPECT_EQ(UpdateAndGetError(filter), "");
  return filter->GetOutput();
}

std::uint64_t HashMap(vtkPolyData* map)
{
  std::vector<std::uint64_t> hashes = { Hash(static_cast<vtkDataSet*>(map)) };
  MixIn(map->GetCellData(), hashes);
  MixIn(map->GetFieldData(), hashes);
  std::uint64_t hash = 0;
  for (std::uint64_t one : hashes)
  {
    hash = hash * 1099511628211u ^ one;
  }
  return hash;
}

MapVerdict ExpectLawful(vtkPolyData* scan, vtkPolyData* map, const MapPromise& promise)
{
  MapVerdict verdict = JudgeMap(scan, map, promise);
  EXPECT_TRUE(verdict.IsLawful()) << verdict;
  return verdict;
}

MapVerdict ExpectLawful(vtkPolyData* scan, const MapPromise& promise)
{
  return ExpectLawful(scan, MakeMap(scan, promise.MaximumError, 0, promise.DepthStep), promise);
}

void ExpectClosed(const MapVerdict& verdict)
{
  EXPECT_EQ(verdict.NumberOfBoundaryEdges, 0) << verdict;
  EXPECT_EQ(verdict.EulerCharacteristic, 2) << verdict;
}
