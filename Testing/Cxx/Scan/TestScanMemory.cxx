// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/SceneFixtures.h"
#include "Scan/ThreadProcesses.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <vector>

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

const double* GetRanges(vtkDataSet* output)
{
  return vtkDoubleArray::SafeDownCast(output->GetPointData()->GetArray("Range"))->GetPointer(0);
}

void ExpectSharedRanges(vtkLMS3DScanFilter* scan)
{
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 91 * 90);
  EXPECT_EQ(GetRanges(scan->GetOutput()), GetRanges(scan->GetRangeImage()));
}

void ExpectSomeReturns(vtkLMS3DScanFilter* scan)
{
  const vtkIdType returns = scan->GetOutput()->GetNumberOfPoints();
  EXPECT_GT(returns, 0);
  EXPECT_LT(returns, 91 * 90);
  EXPECT_NE(GetRanges(scan->GetOutput()), GetRanges(scan->GetRangeImage()));
  EXPECT_EQ(GetArray(scan, "Range")->GetNumberOfTuples(), returns);
}
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
  scan->Update();
  ExpectSharedRanges(scan);
  scan->SurfaceAttributesOn();
  scan->Update();
  ExpectSharedRanges(scan);
  scan->SetAxisOffset(0.02, 0.0, 0.01);
  scan->Update();
  ExpectSharedRanges(scan);
}

TEST(ScanMemory, HoldsTheRangesOfReturnsApartIfABeamGivesNone)
{
  auto scan = MakeScan(MakeBall(1.0));
  SetGrid(scan, 91, 90);
  scan->SetMaximumRange(0.999);
  scan->Update();
  ExpectSomeReturns(scan);

  scan->SetMaximumRange(80.0);
  scan->SetPosition(0.5, 0.0, 0.0);
  scan->SetRangeAtTenPercent(0.316);
  scan->Update();
  ExpectSomeReturns(scan);
}

TEST(ScanMemory, HoldsTheRangesOfEachOutputApartInSeveralProcesses)
{
  const auto processes = MakeProcesses(2);
  std::vector<vtkSmartPointer<vtkLMS3DScanFilter>> scans;
  for (int rank = 0; rank < 2; ++rank)
  {
    scans.push_back(MakeScan(MakeBall(1.0 + rank)));
    SetGrid(scans[rank], 91, 90);
    scans[rank]->SetController(processes[rank]);
  }
  RunProcesses(2, [&](int rank) { scans[rank]->UpdatePiece(rank, 2, 0); });
  EXPECT_EQ(scans[0]->GetOutput()->GetNumberOfPoints(), 91 * 90);
  EXPECT_NE(GetRanges(scans[0]->GetOutput()), GetRanges(scans[0]->GetRangeImage()));
}

TEST(ScanMemory, LeavesEachOutputItsName)
{
  auto scan = MakeScan(MakeBall(1.0));
  SetGrid(scan, 91, 90);
  scan->Update();
  scan->GetOutput()->GetPointData()->GetArray("Range")->SetName("Renamed");
  EXPECT_NE(scan->GetRangeImage()->GetPointData()->GetArray("Range"), nullptr);
  EXPECT_EQ(scan->GetRangeImage()->GetPointData()->GetArray("Renamed"), nullptr);
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
