// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the laws of the local map (MapLaws.h) for various bounds, on scenes that are hard to map.
 */
#include "LocalMap/MapFixtures.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>
#include <tuple>

namespace
{
constexpr std::uint64_t Seed = 20090401;

const double Bounds[] = { 0.0, 0.001, 0.01, 0.05, 1.0 };

using Case = std::tuple<std::string, double>;

std::string GetName(const testing::TestParamInfo<Case>& info)
{
  std::ostringstream name;
  name << std::get<0>(info.param) << std::get<1>(info.param) * 1000.0 << "mm";
  return name.str();
}

class MapLaws : public testing::TestWithParam<Case>
{
protected:
  MapScene Scene = MakeMapScene(std::get<0>(GetParam()));
  double MaximumError = std::get<1>(GetParam());
};
} // namespace

TEST_P(MapLaws, HoldWithoutNoise)
{
  vtkSmartPointer<vtkPolyData> scan = MakeScan(this->Scene);
  const MapVerdict verdict = ExpectLawful(scan, { this->MaximumError, 0.1, this->Scene.Surface });
  const bool isFull = this->Scene.AlphaRange[0] == -90.0 && this->Scene.AlphaRange[1] == 90.0;
  if (this->Scene.IsWhole && isFull)
  {
    ExpectClosed(verdict);
  }
  else if (this->Scene.IsWhole)
  {
    EXPECT_EQ(verdict.EulerCharacteristic, 1) << verdict;
  }
}

TEST_P(MapLaws, HoldWithNoise)
{
  constexpr double Sigma = 0.005;
  Random random(Seed);
  vtkSmartPointer<vtkPolyData> scan = AddNoise(MakeScan(this->Scene), Sigma, random);
  ExpectLawful(scan, { this->MaximumError, 0.1, this->Scene.Surface, 4.0 * Sigma });
}

TEST_P(MapLaws, HoldWithMisses)
{
  Random random(Seed);
  vtkSmartPointer<vtkPolyData> scan =
    Keep(MakeScan(this->Scene), [&](vtkIdType) { return random.Get() < 0.8; });
  ExpectLawful(scan, { this->MaximumError, 0.1, this->Scene.Surface });
}

TEST_P(MapLaws, HoldForOtherDepthSteps)
{
  vtkSmartPointer<vtkPolyData> scan = MakeScan(this->Scene);
  for (double depthStep : { 0.0, 0.02, 0.5 })
  {
    SCOPED_TRACE(depthStep);
    ExpectLawful(scan, { this->MaximumError, depthStep, this->Scene.Surface });
  }
}

// Checks that the scenes with thin objects are what their names say.
TEST(MapScenes, HaveThingsOneBeamThin)
{
  constexpr vtkIdType CellsOfTheRoom = 12;
  for (const char* name : { "Pole", "Bar", "Wire" })
  {
    const MapScene scene = MakeMapScene(name);
    vtkSmartPointer<vtkPolyData> scan = MakeScan(scene);
    std::set<int> beams;
    for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
    {
      if (scan->GetPointData()->GetArray("CellId")->GetTuple1(i) >= CellsOfTheRoom)
      {
        beams.insert(static_cast<int>(scan->GetPointData()->GetArray("BeamId")->GetTuple1(i)));
      }
    }
    EXPECT_GT(beams.size(), 10) << name;
    for (int beam : beams)
    {
      const bool hasNext = beams.count(beam + 1) > 0;
      const bool hasAside = beams.count(beam + scene.AlphaResolution) > 0;
      EXPECT_FALSE(hasNext && hasAside) << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, MapLaws,
  testing::Combine(testing::ValuesIn(GetMapSceneNames()), testing::ValuesIn(Bounds)), GetName);
