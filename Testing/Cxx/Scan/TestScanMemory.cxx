// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

namespace
{
const ScanChange Changes[] = {
  ToSameSize,
  ToLarger,
  ToSmaller,
  ToNoReturns,
  { "Error", [](vtkLMS3DScanFilter* scan) { scan->SetBetaResolution(0); } },
};

/// Arrays of a scan that a user still holds must not change when the filter runs again.
class EachChange : public testing::TestWithParam<ScanChange>
{
protected:
  void SetUp() override
  {
    this->Scan->SetInputDataObject(MakeBall(1.0));
    this->Scan->SetAlphaResolution(91);
    this->Scan->SetBetaResolution(90);
    this->Scan->Update();
  }

  void RunAgain()
  {
    for (int i = 0; i < 3; ++i)
    {
      GetParam().Apply(this->Scan);
      this->Scan->Modified();
      UpdateAndGetError(this->Scan);
    }
  }

  vtkNew<vtkLMS3DScanFilter> Scan;
};
} // namespace

TEST_P(EachChange, LeavesAHeldScanAlone)
{
  vtkNew<vtkPolyData> held;
  held->ShallowCopy(this->Scan->GetOutput());
  const std::uint64_t before = Hash(held);
  this->RunAgain();
  EXPECT_EQ(Hash(held), before);
}

TEST_P(EachChange, LeavesAHeldImageAlone)
{
  vtkNew<vtkImageData> held;
  held->ShallowCopy(this->Scan->GetRangeImage());
  const std::uint64_t before = Hash(held);
  this->RunAgain();
  EXPECT_EQ(Hash(held), before);
}

TEST_P(EachChange, LeavesAnArrayThatSharesItsMemoryAlone)
{
  vtkNew<vtkDoubleArray> held;
  held->ShallowCopy(this->Scan->GetOutput()->GetPointData()->GetArray("Range"));
  const std::uint64_t before = Hash(held);
  this->RunAgain();
  EXPECT_EQ(Hash(held), before);
}

TEST_P(EachChange, LeavesHeldCellsAlone)
{
  vtkSmartPointer<vtkCellArray> held = this->Scan->GetOutput()->GetVerts();
  const std::uint64_t before = Hash(held->GetConnectivityArray());
  this->RunAgain();
  EXPECT_EQ(Hash(held->GetConnectivityArray()), before);
}

INSTANTIATE_TEST_SUITE_P(LMS3DScanFilter, EachChange, testing::ValuesIn(Changes),
  [](const auto& change) { return change.param.Name; });

TEST(ScanMemory, HoldsTheRangesOnceIfAllBeamsGiveReturns)
{
  auto scan = MakeScan(MakeBall(1.0));
  SetGrid(scan, 91, 90);
  const auto getImageRanges = [&] { return scan->GetRangeImage()->GetPointData()->GetScalars(); };
  const auto getRanges = [&] { return scan->GetOutput()->GetPointData()->GetScalars(); };
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 91 * 90);
  EXPECT_EQ(getRanges(), getImageRanges());

  scan->SetMaximumRange(0.999);
  scan->Update();
  EXPECT_GT(scan->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_LT(scan->GetOutput()->GetNumberOfPoints(), 91 * 90);
  EXPECT_NE(getRanges(), getImageRanges());
  EXPECT_EQ(getRanges()->GetNumberOfTuples(), scan->GetOutput()->GetNumberOfPoints());
}

TEST(ScanMemory, OutlivesItsFilter)
{
  vtkSmartPointer<vtkPolyData> held;
  std::uint64_t before;
  {
    vtkNew<vtkLMS3DScanFilter> scan;
    scan->SetInputDataObject(MakeBall(1.0));
    scan->Update();
    held = scan->GetOutput();
    before = Hash(held);
  }
  EXPECT_EQ(Hash(held), before);
  held->GetPoints()->InsertNextPoint(0.0, 0.0, 0.0);
  EXPECT_EQ(held->GetNumberOfPoints(), 361 * 360 + 1);
}

TEST(ScanMemory, IsNoMoreThanTheScanNeeds)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputDataObject(MakeBall(1.0));
  scan->SetAlphaResolution(1001);
  scan->SetBetaResolution(1000);
  scan->Update();
  scan->SetAlphaResolution(10);
  scan->SetBetaResolution(10);
  scan->Update();
  EXPECT_LT(scan->GetOutput()->GetActualMemorySize(), 100u); // KiB
}

TEST(ScanMemory, IsEmptyAfterAnError)
{
  vtkNew<vtkLMS3DScanFilter> scan;
  scan->SetInputDataObject(MakeBall(1.0));
  scan->Update();
  scan->SetMinimumRange(-1.0);
  UpdateAndGetError(scan);
  EXPECT_EQ(scan->GetRangeImage()->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(scan->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
}
