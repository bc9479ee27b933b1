// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Runs one reconstruction filter many times, with various numbers of threads.
 */
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkDoubleArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

namespace
{
const ScanChange Changes[] = {
  ToSameSize,
  ToLarger,
  ToSmaller,
  { "Open", [](vtkLMS3DScanFilter* scan) { scan->SetBetaRange(0.0, 300.0); } },
  { "WithoutPoles", [](vtkLMS3DScanFilter* scan) { scan->SetAlphaRange(-80.0, 80.0); } },
  { "Misses", [](vtkLMS3DScanFilter* scan) { scan->SetMaximumRange(1.0); } },
  ToNoReturns,
};

class EachMapChange : public testing::TestWithParam<ScanChange>
{
protected:
  void SetUp() override
  {
    this->Scan->SetInputDataObject(MakeBall(1.0));
    this->Scan->SetPosition(0.3, 0.0, 0.1);
    this->Scan->SetAlphaResolution(91);
    this->Scan->SetBetaResolution(90);
    this->Map->SetInputConnection(this->Scan->GetOutputPort());
    this->Map->SetMaximumError(0.0);
    this->Map->Update();
  }

  void RunAgain()
  {
    GetParam().Apply(this->Scan);
    for (int i = 0; i < 3; ++i)
    {
      this->Map->Modified();
      this->Map->Update();
    }
  }

  std::uint64_t HashOfNewFilter()
  {
    vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
    map->SetInputConnection(this->Scan->GetOutputPort());
    map->SetMaximumError(0.0);
    map->Update();
    return map->GetOutput()->GetNumberOfPoints() > 0 ? Hash(map->GetOutput()) : 0;
  }

  vtkNew<vtkLMS3DScanFilter> Scan;
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> Map;
};
} // namespace

TEST_P(EachMapChange, GivesWhatANewFilterGives)
{
  this->RunAgain();
  vtkPolyData* map = this->Map->GetOutput();
  EXPECT_EQ(map->GetNumberOfPoints() > 0 ? Hash(map) : 0, this->HashOfNewFilter());
}

TEST_P(EachMapChange, LeavesAHeldMapAlone)
{
  vtkNew<vtkPolyData> held;
  held->ShallowCopy(this->Map->GetOutput());
  const std::uint64_t before = Hash(held);
  this->RunAgain();
  EXPECT_EQ(Hash(held), before);
}

INSTANTIATE_TEST_SUITE_P(LMS3DSurfaceReconstructionFilter, EachMapChange,
  testing::ValuesIn(Changes), [](const auto& change) { return change.param.Name; });

TEST(MapRuns, GiveTheSameBitsForAnyNumberOfThreads)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputDataObject(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->SetMaximumRange(3.0); // Leaves misses.
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> map;
  map->SetInputConnection(scan->GetOutputPort());
  map->SetMaximumError(0.0);
  map->SetNumberOfThreads(1);
  map->Update();
  ASSERT_GT(map->GetOutput()->GetNumberOfCells(), 10000);
  const std::uint64_t expected = Hash(map->GetOutput());
  for (int threads : { 2, 3, 8, 0 })
  {
    map->SetNumberOfThreads(threads);
    map->Update();
    EXPECT_EQ(Hash(map->GetOutput()), expected) << threads << " threads";
  }
}
