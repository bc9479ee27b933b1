// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the map of scans with the errors of a SICK LMS 200: noise, beams that widen, and returns
 * between surfaces.
 */
#include "Fusion/FusionFixtures.h"

#include "vtkLMS3DRangeErrorFilter.h"
#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{
// Metres: six times the noise of the device.
constexpr double MaximumError = 0.03;

std::vector<MappedScan> ScanRoomOften(int poses)
{
  std::vector<MappedScan> scans;
  for (int i = 0; i < poses; ++i)
  {
    vtkNew<vtkLMS3DScanFilter> scanner;
    scanner->SetInputData(ReadRoom());
    scanner->SetDeviceToLMS200();
    scanner->SetAlphaResolution(91);
    scanner->SetBetaResolution(90);
    scanner->SetPosition(-2.0 + 4.0 * i / poses, -0.2, 1.0);
    vtkNew<vtkLMS3DRangeErrorFilter> errors;
    errors->SetInputConnection(scanner->GetOutputPort());
    errors->SetDeviceToLMS200();
    errors->SetNoiseSeed(i);
    vtkNew<vtkLMS3DSurfaceReconstructionFilter> mapper;
    mapper->SetInputConnection(errors->GetOutputPort());
    mapper->SetMaximumError(MaximumError);
    mapper->Update();
    scans.push_back({ mapper->GetPolyDataInput(0), mapper->GetOutput() });
  }
  return scans;
}

/// The area of triangles within 10 cm of the ceiling of the room that face down, square metres.
double GetCeilingArea(vtkPolyData* map)
{
  const TriangleTree tree = MakeTree(map, { 0.0, 0.0, 0.0 });
  double area = 0.0;
  for (std::size_t i = 0; i < tree.GetNumberOfTriangles(); ++i)
  {
    const auto corners = tree.GetCorners(i);
    const Vector cross =
      lms3dCross(lms3dSubtract(corners[1], corners[0]), lms3dSubtract(corners[2], corners[0]));
    const double twice = lms3dGetLength(cross);
    if (std::abs(corners[0][2] - 3.0) < 0.1 && cross[2] < -0.9 * twice)
    {
      area += 0.5 * twice;
    }
  }
  return area;
}
} // namespace

TEST(LMS3DFusedRealScans, ShowASurfaceOnce)
{
  const std::vector<MappedScan> scans = ScanRoomOften(20);
  vtkNew<vtkLMS3DMapFusion> fusion;
  fusion->SetMaximumError(MaximumError);
  AddAll(scans, fusion);
  fusion->Update();
  // The judge takes its time.
  const std::vector<MappedScan> some = { scans[0], scans[7], scans[13], scans[19] };
  const FusionVerdict verdict = JudgeFusion(fusion->GetOutput(), some, MaximumError);
  const double area = GetCeilingArea(fusion->GetOutput());
  RecordProperty("Triangles", static_cast<int>(fusion->GetOutput()->GetNumberOfPolys()));
  RecordProperty("TrianglesOfAllMaps", static_cast<int>(CountTriangles(scans)));
  RecordProperty("Blocked", static_cast<int>(verdict.Blocked));
  RecordProperty("Returns", static_cast<int>(verdict.Returns));
  RecordProperty("CeilingArea", std::to_string(area));
  EXPECT_EQ(verdict.Beyond, 0) << verdict.LargestDistance;
  EXPECT_LT(2 * fusion->GetOutput()->GetNumberOfPolys(), CountTriangles(scans));
  // The room has 48 square metres.
  EXPECT_GT(area, 44.0);
  EXPECT_LT(area, 52.0);
}

// The noise exceeds 0.75 of the bound, so each return is a corner of the local map. At depth steps
// its beam hits or misses the map by rounding, and 90 beams along the axis have returns of their
// own.
TEST(LMS3DFusedRealScans, KeepTheBoundOfPlainGrids)
{
  constexpr double Bound = 0.01;
  const MappedScan scan = MakeMappedScan(ReadRoom(), { 0.3, -0.2, 1.0 }, true, Bound);
  ASSERT_GT(scan.Map->GetFieldData()->GetArray("NumberOfReturnsOnGrid")->GetTuple1(0), 8000);
  vtkNew<vtkLMS3DMapFusion> fusion;
  AddAll({ scan }, fusion);
  fusion->Update();
  const FusionVerdict verdict = JudgeFusion(fusion->GetOutput(), scan, Bound);
  EXPECT_EQ(verdict.Returns, scan.Scan->GetNumberOfPoints());
  EXPECT_EQ(verdict.Beyond, 0) << verdict.LargestDistance;
}
