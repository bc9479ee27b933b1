// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What SurfaceAttributes adds to a scan, and what it does not change.
 */
#include "Fixtures/MeshFixtures.h"
#include "Fixtures/SceneBuilder.h"
#include "Fixtures/SceneFixtures.h"
#include "Scan/LabelledScan.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkImageData.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <cstdint>

TEST(LMS3DScanSurfaceAttributes, AreOffAndChangeNothingElse)
{
  auto scan = MakeScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  SetGrid(scan, 61, 72);
  scan->SetMaximumRange(3.0);
  EXPECT_FALSE(scan->GetSurfaceAttributes());
  scan->Update();
  vtkPointData* arrays = scan->GetOutput()->GetPointData();
  ASSERT_EQ(arrays->GetNumberOfArrays(), 5);
  EXPECT_EQ(arrays->GetNormals(), nullptr);
  const vtkMTimeType buildTime = scan->GetBuildTime();
  const std::uint64_t plain = Hash(scan->GetOutput());
  const std::uint64_t image = Hash(scan->GetRangeImage());

  scan->SurfaceAttributesOn();
  scan->Update();
  EXPECT_EQ(scan->GetBuildTime(), buildTime);
  EXPECT_EQ(Hash(scan->GetRangeImage()), image);
  EXPECT_EQ(scan->GetRangeImage()->GetPointData()->GetNumberOfArrays(), 1);
  arrays = scan->GetOutput()->GetPointData();
  EXPECT_EQ(arrays->GetScalars(), arrays->GetArray("Range"));
  EXPECT_EQ(arrays->GetNormals(), arrays->GetArray("Normals"));
  while (arrays->GetNumberOfArrays() > 5)
  {
    arrays->RemoveArray(5);
  }
  EXPECT_EQ(Hash(scan->GetOutput()), plain);

  scan->SurfaceAttributesOff();
  scan->Update();
  EXPECT_EQ(scan->GetOutput()->GetPointData()->GetNumberOfArrays(), 5);
  EXPECT_EQ(Hash(scan->GetOutput()), plain);
}

TEST(LMS3DScanSurfaceAttributes, AreTheSameBitsForAnyNumberOfThreads)
{
  auto scan = MakeLabelledScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->SetNumberOfThreads(1);
  scan->Update();
  const std::uint64_t expected = Hash(scan->GetOutput());
  for (int threads : { 2, 3, 8 })
  {
    scan->SetNumberOfThreads(threads);
    scan->Update();
    EXPECT_EQ(Hash(scan->GetOutput()), expected) << threads << " threads";
  }
}

TEST(LMS3DScanSurfaceAttributes, AreThereWithoutReturns)
{
  auto scan = MakeLabelledScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->SetMaximumRange(0.01);
  scan->Update();
  ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  for (const char* name : { "Normals", "Incidence", "ShapeId", "Color" })
  {
    ASSERT_NE(GetArray(scan, name), nullptr) << name;
    EXPECT_EQ(GetArray(scan, name)->GetNumberOfTuples(), 0);
  }
}
