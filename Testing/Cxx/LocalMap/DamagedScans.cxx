// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/DamagedScans.h"

#include "Fixtures/SceneFixtures.h"
#include "LocalMap/MapFixtures.h"

#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <sstream>
#include <vector>

namespace
{
using Shapes = ScanDamage::Shapes;

template <typename T>
T Pick(Random& random, std::initializer_list<T> values)
{
  return *(values.begin() +
    static_cast<std::ptrdiff_t>(random.Get() * static_cast<double>(values.size())));
}

std::string GetSceneName(int number)
{
  const std::vector<std::string> names = GetMapSceneNames();
  const auto index = static_cast<std::size_t>(number);
  return index < names.size() ? names[index] : "random scene " + std::to_string(number);
}

MapScene MakeScene(int number)
{
  const std::vector<std::string> names = GetMapSceneNames();
  const auto index = static_cast<std::size_t>(number);
  if (index < names.size())
  {
    return MakeMapScene(names[index]);
  }
  Random random(static_cast<std::uint64_t>(number));
  MapScene scene = MakeRandomMapScene(random);
  scene.AlphaResolution = 61;
  scene.BetaResolution = 60;
  return scene;
}

// Every fourth scan has all errors.
ScanDamage MakeErrors(int seed, Random& random)
{
  const bool hasAll = random.Get() < 0.25;
  ScanDamage errors;
  errors.Seed = seed;
  errors.Dropouts = hasAll ? 0.05 : Pick(random, { 0.0, 0.01, 0.05, 0.2 });
  errors.Shape = Pick(random, { Shapes::SingleBeams, Shapes::Stripes, Shapes::Blobs });
  errors.Strays = hasAll ? 0.01 : Pick(random, { 0.0, 0.001, 0.01 });
  errors.Noise = hasAll ? 0.005 : Pick(random, { 0.0, 0.005, 0.02 });
  errors.Steps = hasAll ? 0.01 : Pick(random, { 0.0, 0.001, 0.01 });
  return errors;
}

MapPromise MakePromise(Random& random)
{
  MapPromise promise;
  promise.MaximumError = Pick(random, { 0.01, 0.02, 0.04, 0.1 });
  promise.MaximumGapSize = Pick(random, { -1, -1, 0, 4, 100 });
  promise.MaximumSpeckleSize = Pick(random, { 0, 1, 4 });
  promise.KeepSpeckles = Pick(random, { true, false });
  return promise;
}

std::map<int, double> GetRanges(vtkPolyData* scan)
{
  vtkDataArray* beams = scan->GetPointData()->GetArray("BeamId");
  vtkDataArray* ranges = scan->GetPointData()->GetArray("Range");
  std::map<int, double> ofBeams;
  for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
  {
    ofBeams[static_cast<int>(beams->GetTuple1(i))] = ranges->GetTuple1(i);
  }
  return ofBeams;
}
} // namespace

DamagedScan::DamagedScan(int seed)
  : Seed(seed)
  , SceneName(GetSceneName(seed % NumberOfDamagedScenes))
  , Scene(MakeScene(seed % NumberOfDamagedScenes))
{
  Random random(static_cast<std::uint64_t>(seed));
  this->Errors = MakeErrors(seed, random);
  this->Promise = MakePromise(random);
  this->Ideal = MakeScan(this->Scene, random.Get() < 0.75);
  this->Damaged = Damage(this->Ideal, this->Errors);
}

vtkSmartPointer<vtkPolyData> DamagedScan::MakeMap() const
{
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> filter;
  filter->SetInputDataObject(this->Damaged);
  filter->SetMaximumError(this->Promise.MaximumError);
  filter->SetDepthStep(this->Promise.DepthStep);
  filter->SetMaximumGapSize(this->Promise.MaximumGapSize);
  filter->SetMaximumSpeckleSize(this->Promise.MaximumSpeckleSize);
  filter->SetKeepSpeckles(this->Promise.KeepSpeckles);
  EXPECT_EQ(UpdateAndGetError(filter), "");
  return filter->GetOutput();
}

MapPromise DamagedScan::GetPromise() const
{
  MapPromise promise = this->Promise;
  promise.Scene = this->Scene.Surface;
  promise.Noise = GetLargestMove(this->Ideal, this->Damaged, this->Errors);
  promise.Ideal = this->Ideal;
  return promise;
}

std::string DamagedScan::Describe() const
{
  std::ostringstream words;
  words << "seed " << this->Seed << ", " << this->SceneName << ", " << this->Errors.Describe()
        << ", a bound of " << this->Promise.MaximumError << " m, gaps of "
        << this->Promise.MaximumGapSize << ", speckles of " << this->Promise.MaximumSpeckleSize
        << (this->Promise.KeepSpeckles ? " kept" : " left out")
        << (this->Ideal->GetFieldData()->HasArray("Status") ? ", with Status" : "");
  return words.str();
}

double GetLargestMove(vtkPolyData* ideal, vtkPolyData* damaged, const ScanDamage& errors)
{
  const std::map<int, double> before = GetRanges(ideal);
  double largest = 0.0;
  for (const auto& [beam, range] : GetRanges(damaged))
  {
    if (!errors.IsStray(beam))
    {
      largest = std::max(largest, std::abs(range - before.at(beam)));
    }
  }
  return largest;
}
