// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scans that give no surface, and scans that the reconstruction refuses.
 */
#include "LocalMap/PlainGridFixtures.h"

#include <vtkErrorCode.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <limits>

TEST(LMS3DSurfaceReconstructionFilter, TakesScansWithoutCells)
{
  PlainGridPipeline pipeline(MakeBall(2.0));
  pipeline.Scan->SetBetaResolution(1);
  EXPECT_EQ(pipeline.Run()->GetNumberOfCells(), 0);
  EXPECT_EQ(pipeline.Map->GetErrorCode(), vtkErrorCode::NoError);
  pipeline.Scan->SetBetaResolution(360);
  pipeline.Scan->SetMaximumRange(1.0);
  EXPECT_EQ(UpdateAndGetError(pipeline.Map), "");
  EXPECT_EQ(pipeline.Map->GetOutput()->GetNumberOfPoints(), 0);
  pipeline.Scan->SetMaximumRange(80.0);
  pipeline.Scan->SetAlphaRange(0.0, 10.0);
  pipeline.Scan->SetAlphaResolution(2);
  pipeline.Scan->SetBetaRange(0.0, 10.0);
  pipeline.Scan->SetBetaResolution(2);
  EXPECT_EQ(pipeline.Run()->GetNumberOfCells(), 2);
}

TEST(LMS3DSurfaceReconstructionFilter, RefusesWhatIsNoScan)
{
  PlainGridPipeline pipeline(MakeBall(2.0));
  pipeline.Scan->SetAlphaResolution(9);
  pipeline.Scan->SetBetaResolution(8);
  ExpectRefused(MakeBall(1.0), "Range");

  for (const char* name : { "Range", "BeamId" })
  {
    vtkSmartPointer<vtkPolyData> scan = CopyScan(pipeline.Scan);
    scan->GetPointData()->RemoveArray(name);
    ExpectRefused(scan, name);
  }
  for (const char* name : { "AlphaAngles", "BetaAngles", "SensorToWorld" })
  {
    vtkSmartPointer<vtkPolyData> scan = CopyScan(pipeline.Scan);
    scan->GetFieldData()->RemoveArray(name);
    ExpectRefused(scan, name);
  }
}

TEST(LMS3DSurfaceReconstructionFilter, RefusesBadReturns)
{
  PlainGridPipeline pipeline(MakeBall(2.0));
  pipeline.Scan->SetAlphaResolution(9);
  pipeline.Scan->SetBetaResolution(8);
  for (double bad : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), 0.0, -1.0 })
  {
    vtkSmartPointer<vtkPolyData> scan = CopyScan(pipeline.Scan);
    scan->GetPointData()->GetArray("Range")->SetTuple1(7, bad);
    ExpectRefused(scan, "Return 7 of the scan has the Range");
  }
  for (double bad :
    { std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity() })
  {
    vtkSmartPointer<vtkPolyData> scan = CopyScan(pipeline.Scan);
    scan->GetPoints()->SetPoint(7, 1.0, bad, 2.0);
    ExpectRefused(scan, "Return 7 of the scan has the coordinate");
  }
  for (double bad : { -1.0, 72.0, 3.0 })
  {
    vtkSmartPointer<vtkPolyData> scan = CopyScan(pipeline.Scan);
    scan->GetPointData()->GetArray("BeamId")->SetTuple1(7, bad);
    ExpectRefused(scan, "Return 7 of the scan has the BeamId");
  }
}
