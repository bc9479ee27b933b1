// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The point arrays Incidence and Intensity without SurfaceAttributes, and beside it.
 */
#include "Scan/DetectionFixtures.h"

#include <vtkMath.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace
{
vtkSmartPointer<vtkLMS3DScanFilter> MakeRoomScan()
{
  auto scan = MakeScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  SetGrid(scan, 61, 72);
  return scan;
}

std::string ListArrays(vtkLMS3DScanFilter* scan)
{
  EXPECT_EQ(UpdateAndGetError(scan), "");
  std::string list;
  for (int i = 0; i < scan->GetOutput()->GetPointData()->GetNumberOfArrays(); ++i)
  {
    list += std::string(i > 0 ? " " : "") + scan->GetOutput()->GetPointData()->GetArrayName(i);
  }
  return list;
}

const std::string Own = "Range Alpha Beta BeamId CellId";
} // namespace

TEST(LMS3DScanIncidence, TheArraysHaveTheDocumentedOrder)
{
  auto scan = MakeRoomScan();
  EXPECT_EQ(ListArrays(scan), Own);
  scan->ComputeIntensityOn();
  EXPECT_EQ(ListArrays(scan), Own + " Intensity");
  scan->ComputeIncidenceOn();
  EXPECT_EQ(ListArrays(scan), Own + " Incidence Intensity");
  scan->SurfaceAttributesOn();
  EXPECT_EQ(ListArrays(scan), Own + " Normals Incidence Intensity ShapeId Color");
  scan->ComputeIntensityOff();
  EXPECT_EQ(ListArrays(scan), Own + " Normals Incidence ShapeId Color");
  scan->ComputeIncidenceOff();
  EXPECT_EQ(ListArrays(scan), Own + " Normals Incidence ShapeId Color");
}

TEST(LMS3DScanIncidence, IsThatOfSurfaceAttributesToTheBitAndChangesNothingElse)
{
  auto scan = MakeRoomScan();
  scan->Update();
  const std::uint64_t plain = Hash(scan->GetOutput());
  scan->SurfaceAttributesOn();
  scan->Update();
  const std::uint64_t attributes = Hash(scan->GetOutput());
  const std::uint64_t incidence = Hash(GetArray(scan, "Incidence"));
  scan->ComputeIncidenceOn();
  scan->Update();
  EXPECT_EQ(Hash(scan->GetOutput()), attributes);
  scan->SurfaceAttributesOff();
  scan->Update();
  EXPECT_EQ(Hash(GetArray(scan, "Incidence")), incidence);
  scan->GetOutput()->GetPointData()->RemoveArray("Incidence");
  EXPECT_EQ(Hash(scan->GetOutput()), plain);
}

TEST(LMS3DScanIncidence, OfASlantedWallIsItsAngle)
{
  for (double degrees : { -89.0, -45.0, 0.0, 1e-3, 12.5, 60.0, 89.9 })
  {
    auto wall = MakeWall(3.0, degrees);
    for (int side = 0; side < 2; ++side, wall->ReverseCell(0))
    {
      auto scan = MakeBeam(wall);
      scan->ComputeIncidenceOn();
      ASSERT_TRUE(HasReturn(scan));
      EXPECT_EQ(GetArray(scan, "Incidence")->GetDataType(), VTK_FLOAT);
      EXPECT_NEAR(GetArray(scan, "Incidence")->GetTuple1(0), std::abs(degrees), 1e-5);
    }
  }
}

TEST(LMS3DScanIncidence, IntensityIsReflectanceTimesTheCosine)
{
  for (double reflectance : { 0.0, 0.3, 1.0, 25.0 })
  {
    for (double degrees : { 0.0, 30.0, 60.0, 89.0 })
    {
      auto scan = MakeBeam(Paint(MakeWall(3.0, degrees), reflectance));
      scan->SetReflectanceArray("Reflectance");
      scan->ComputeIntensityOn();
      ASSERT_TRUE(HasReturn(scan));
      EXPECT_EQ(GetArray(scan, "Intensity")->GetDataType(), VTK_FLOAT);
      EXPECT_FLOAT_EQ(static_cast<float>(GetArray(scan, "Intensity")->GetTuple1(0)),
        static_cast<float>(reflectance * std::cos(vtkMath::RadiansFromDegrees(degrees))));
    }
  }
}

TEST(LMS3DScanIncidence, IntensityInTheRoomIsThatOfItsColours)
{
  auto scan = MakeRoomScan();
  scan->SurfaceAttributesOn();
  scan->ComputeIntensityOn();
  scan->SetReflectanceArray("Color");
  ASSERT_TRUE(HasReturn(scan));
  for (vtkIdType i = 0; i < scan->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const double* color = GetArray(scan, "Color")->GetTuple(i);
    const double luminance = (0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2]) / 255.0;
    const double incidence = vtkMath::RadiansFromDegrees(GetArray(scan, "Incidence")->GetTuple1(i));
    ASSERT_NEAR(GetArray(scan, "Intensity")->GetTuple1(i), luminance * std::cos(incidence), 2e-7);
  }
}

TEST(LMS3DScanIncidence, ArraysOfTheSceneWithTheNamesAreLeftOut)
{
  auto wall = MakeWall(2.0, 60.0);
  SetReflectances(wall, { 7.0 }, "Intensity");
  auto scan = MakeBeam(wall);
  scan->SurfaceAttributesOn();
  ASSERT_TRUE(HasReturn(scan));
  EXPECT_EQ(GetArray(scan, "Intensity")->GetTuple1(0), 7.0);
  scan->ComputeIntensityOn();
  ASSERT_TRUE(HasReturn(scan));
  EXPECT_FLOAT_EQ(static_cast<float>(GetArray(scan, "Intensity")->GetTuple1(0)), 0.5f);
}

TEST(LMS3DScanIncidence, TheArraysAreThereWithoutReturns)
{
  auto scan = MakeRoomScan();
  scan->ComputeIncidenceOn();
  scan->ComputeIntensityOn();
  scan->SetMaximumRange(0.01);
  EXPECT_EQ(ListArrays(scan), Own + " Incidence Intensity");
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
}
