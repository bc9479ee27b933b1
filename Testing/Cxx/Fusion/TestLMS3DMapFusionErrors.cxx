// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks what a fusion refuses, and in which words.
 */
#include "Fusion/FusionFixtures.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace
{
MappedScan MakeInput()
{
  return MakeMappedScan(MakeBall(2.0), { 0.1, 0.2, 0.3 });
}

void ExpectRefused(const MappedScan& scan, const std::string& words, double maximumError = 0.01)
{
  vtkNew<vtkLMS3DMapFusion> fusion;
  fusion->SetMaximumError(maximumError);
  fusion->SetInputData(scan.Map);
  fusion->SetScanData(scan.Scan);
  EXPECT_NE(UpdateAndGetError(fusion).find(words), std::string::npos) << words;
  EXPECT_EQ(fusion->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_EQ(fusion->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(fusion->GetNumberOfScans(), 0);
}
} // namespace

TEST(LMS3DMapFusionErrors, RefusesMapsWithoutScans)
{
  vtkNew<vtkLMS3DMapFusion> fusion;
  fusion->SetInputData(MakeInput().Map);
  EXPECT_NE(UpdateAndGetError(fusion).find("1 local maps and 0 scans"), std::string::npos);
  EXPECT_EQ(fusion->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(LMS3DMapFusionErrors, RefusesOtherBounds)
{
  ExpectRefused(MakeInput(), "Give both filters the same MaximumError", 1e-6);
  for (double bad : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    ExpectRefused(MakeInput(), "MaximumError is", bad);
  }
}

TEST(LMS3DMapFusionErrors, RefusesWhatLiesTooFarAway)
{
  MappedScan scan = MakeInput();
  Move({ 5e6, -3e6, 0.0 }, scan);
  vtkNew<vtkLMS3DMapFusion> fusion;
  EXPECT_TRUE(fusion->AddScan(scan.Map, scan.Scan));
  Move({ 0.0, -1e6, 0.0 }, scan);
  ExpectRefused(scan, "the map reaches 6e+06 m");
  scan = MakeInput();
  scan.Map->GetPoints()->SetPoint(3, 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  ExpectRefused(scan, "The local map lies up to nan m");
  scan = MakeInput();
  vtkNew<vtkDoubleArray> offset;
  offset->SetName("AxisOffset");
  offset->SetNumberOfComponents(3);
  offset->InsertNextTuple3(1e9, 0.0, 0.0);
  scan.Scan->GetFieldData()->AddArray(offset);
  ExpectRefused(scan, "The beams of the scan reach up to 1e+09 m");
}

TEST(LMS3DMapFusionErrors, RefusesPosesThatScale)
{
  for (double factor : { 2.0, -1.0, 0.0 })
  {
    const MappedScan scan = MakeInput();
    vtkDataArray* const pose = scan.Scan->GetFieldData()->GetArray("SensorToWorld");
    for (int i : { 0, 4, 8 })
    {
      pose->SetTuple1(i, factor * pose->GetTuple1(i));
    }
    ExpectRefused(scan, "A pose is a rotation and a translation");
  }
}

TEST(LMS3DMapFusionErrors, RefusesMapsThatAreNoLocalMaps)
{
  MappedScan scan = MakeInput();
  scan.Map->GetCellData()->RemoveArray("PatchId");
  ExpectRefused(scan, "has no PatchId");
  scan = MakeInput();
  scan.Map->GetFieldData()->RemoveArray("LargestDeviation");
  ExpectRefused(scan, "no LargestDeviation");
  scan = MakeInput();
  scan.Scan->Initialize();
  ExpectRefused(scan, "its scan has no returns");
}

TEST(LMS3DMapFusionErrors, RefusesMapsThatAreDamaged)
{
  for (vtkIdType bad : { -3, 1000000 })
  {
    const MappedScan scan = MakeInput();
    const vtkIdType corners[] = { 0, 1, bad };
    scan.Map->GetPolys()->ReplaceCellAtId(5, 3, corners);
    ExpectRefused(scan, "Cell 5 of the local map is no triangle");
  }
  for (double bad : { -2.0, 1e9 })
  {
    const MappedScan scan = MakeInput();
    scan.Map->GetCellData()->GetArray("PatchId")->SetTuple1(5, bad);
    ExpectRefused(scan, "Triangle 5 of the local map has the PatchId");
  }
  const MappedScan scan = MakeInput();
  scan.Map->Initialize();
  ExpectRefused(scan, "The filter that makes the map has failed, or was aborted");
}

TEST(LMS3DMapFusionErrors, ChecksTheBoundIfItChangesAfterAScan)
{
  const MappedScan scan = MakeInput();
  vtkNew<vtkLMS3DMapFusion> fusion;
  EXPECT_TRUE(fusion->AddScan(scan.Map, scan.Scan));
  fusion->SetMaximumError(0.02);
  fusion->Update();
  EXPECT_EQ(fusion->GetNumberOfScans(), 0);
  EXPECT_EQ(fusion->GetOutput()->GetNumberOfCells(), 0);
  fusion->SetMaximumError(-1.0);
  EXPECT_NE(UpdateAndGetError(fusion).find("MaximumError is"), std::string::npos);
}

TEST(LMS3DMapFusionErrors, ChangesNeedAPlace)
{
  vtkNew<vtkLMS3DMapFusion> fusion;
  vtkNew<vtkTest::ErrorObserver> observer;
  fusion->AddObserver(vtkCommand::ErrorEvent, observer);
  fusion->GetChanges(0, nullptr);
  EXPECT_NE(observer->GetErrorMessage().find("needs a vtkPolyData"), std::string::npos);
}

TEST(LMS3DMapFusionErrors, RefusesBadScans)
{
  MappedScan scan = MakeInput();
  scan.Scan->GetPointData()->RemoveArray("Range");
  ExpectRefused(scan, "Range");
  scan = MakeInput();
  scan.Scan->GetPointData()->GetArray("Range")->SetTuple1(7, 0.0);
  ExpectRefused(scan, "Return 7 of the scan has the Range");
  scan = MakeInput();
  scan.Scan->GetPointData()->GetArray("BeamId")->SetTuple1(7, 1e9);
  ExpectRefused(scan, "Return 7 of the scan has the BeamId");
  scan = MakeInput();
  vtkNew<vtkUnsignedCharArray> status;
  status->SetName("Status");
  status->SetNumberOfValues(7);
  status->FillValue(0);
  scan.Scan->GetFieldData()->AddArray(status);
  ExpectRefused(scan, "Status of the scan has 7 tuples of 1 components");
}

TEST(LMS3DMapFusionErrors, AddScanNeedsAFilterWithoutConnections)
{
  const MappedScan scan = MakeInput();
  vtkNew<vtkLMS3DMapFusion> fusion;
  vtkNew<vtkTest::ErrorObserver> observer;
  fusion->AddObserver(vtkCommand::ErrorEvent, observer);
  fusion->SetInputData(scan.Map);
  EXPECT_FALSE(fusion->AddScan(scan.Map, scan.Scan));
  EXPECT_NE(observer->GetErrorMessage().find("without connections"), std::string::npos);
  EXPECT_EQ(fusion->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
}

TEST(LMS3DMapFusionErrors, KeepsTheMapIfAScanIsRefused)
{
  const MappedScan scan = MakeInput();
  vtkNew<vtkLMS3DMapFusion> fusion;
  EXPECT_TRUE(fusion->AddScan(scan.Map, scan.Scan));
  const MappedScan bad = MakeInput();
  bad.Map->GetCellData()->RemoveArray("PatchId");
  vtkNew<vtkTest::ErrorObserver> observer;
  fusion->AddObserver(vtkCommand::ErrorEvent, observer);
  EXPECT_FALSE(fusion->AddScan(bad.Map, bad.Scan));
  EXPECT_TRUE(observer->GetError());
  EXPECT_EQ(fusion->GetNumberOfScans(), 1);
}

TEST(LMS3DMapFusionErrors, AnEmptyFilterGivesAnEmptyMap)
{
  vtkNew<vtkLMS3DMapFusion> fusion;
  EXPECT_EQ(UpdateAndGetError(fusion), "");
  EXPECT_EQ(fusion->GetOutput()->GetNumberOfPolys(), 0);
}

TEST(LMS3DMapFusionErrors, APoseWithoutReturnsHasAPlace)
{
  const MappedScan scan = MakeMappedScan(MakeBall(2.0), { 50.0, 60.0, 70.0 });
  ASSERT_EQ(scan.Scan->GetNumberOfPoints(), 0);
  vtkNew<vtkLMS3DMapFusion> fusion;
  EXPECT_TRUE(fusion->AddScan(scan.Map, scan.Scan));
  fusion->Update();
  const double* const place =
    fusion->GetOutput()->GetFieldData()->GetArray("SensorPositions")->GetTuple3(0);
  EXPECT_EQ((Point{ place[0], place[1], place[2] }), (Point{ 50.0, 60.0, 70.0 }));
}
