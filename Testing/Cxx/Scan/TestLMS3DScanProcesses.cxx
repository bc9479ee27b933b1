// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Several processes with parts of a scene scan it together, with devices of all kinds.
 */
#include "Fixtures/ProgressListener.h"
#include "Scan/DeviceFixtures.h"
#include "Scan/ThreadProcesses.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{
using Scans = std::vector<vtkSmartPointer<vtkLMS3DScanFilter>>;

/// Each `count`th cell of a scene, from number `rank` on, with global ids.
vtkSmartPointer<vtkPolyData> MakePart(vtkPolyData* scene, int rank, int count)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = rank; cell < scene->GetNumberOfCells(); cell += count)
  {
    scene->GetCellPoints(cell, corners);
    polygons->InsertNextCell(corners);
    ids->InsertNextValue(cell);
  }
  ids->SetName("Ids");
  part->SetPoints(scene->GetPoints());
  part->SetPolys(polygons);
  part->GetCellData()->SetGlobalIds(ids);
  return part;
}

Scans MakeScans(vtkPolyData* scene, const Device& device, int count)
{
  const auto processes = MakeProcesses(count);
  Scans scans;
  for (int rank = 0; rank < count; ++rank)
  {
    auto scan = MakeScan(MakePart(scene, rank, count));
    scan->SetPosition(0.3, -0.2, 1.0);
    SetGrid(scan, 61, 36);
    device.Apply(scan);
    scan->SetController(processes[rank]);
    scan->SetNumberOfThreads(2);
    scans.push_back(scan);
  }
  return scans;
}

void Update(const Scans& scans)
{
  const int count = static_cast<int>(scans.size());
  RunProcesses(count, [&scans, count](int rank) { scans[rank]->UpdatePiece(rank, count, 0); });
}

// Each process has its block of the image.
void ExpectBlockOf(vtkImageData* whole, vtkImageData* block)
{
  ASSERT_EQ(block->GetPointData()->GetNumberOfArrays(), whole->GetPointData()->GetNumberOfArrays());
  for (int i = 0; i < whole->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* expected = whole->GetPointData()->GetArray(i);
    vtkDataArray* values = block->GetPointData()->GetArray(expected->GetName());
    ASSERT_NE(values, nullptr) << expected->GetName();
    for (vtkIdType point = 0; point < block->GetNumberOfPoints(); ++point)
    {
      const double value = values->GetTuple1(point);
      const double same = expected->GetTuple1(whole->FindPoint(block->GetPoint(point)));
      ASSERT_TRUE(value == same || (std::isnan(value) && std::isnan(same))) << expected->GetName();
    }
  }
}

void ExpectTheBitsOfOneProcess(const Device& device)
{
  auto room = ReadRoom();
  const Scans alone = MakeScans(room, device, 1);
  Update(alone);
  EXPECT_GT(alone[0]->GetOutput()->GetNumberOfPoints(), 500);
  for (int count : { 2, 4 })
  {
    const Scans scans = MakeScans(room, device, count);
    Update(scans);
    EXPECT_EQ(Hash(scans[0]->GetOutput()), Hash(alone[0]->GetOutput())) << count;
    vtkIdType beams = 0;
    for (int rank = 0; rank < count; ++rank)
    {
      EXPECT_TRUE(rank == 0 || scans[rank]->GetOutput()->GetNumberOfPoints() == 0);
      EXPECT_EQ(scans[rank]->GetOutput()->GetPointData()->GetNumberOfArrays(),
        alone[0]->GetOutput()->GetPointData()->GetNumberOfArrays());
      ExpectBlockOf(alone[0]->GetRangeImage(), scans[rank]->GetRangeImage());
      beams += scans[rank]->GetRangeImage()->GetNumberOfPoints();
    }
    EXPECT_GE(beams, alone[0]->GetRangeImage()->GetNumberOfPoints());
  }
}

class LMS3DScanProcesses : public testing::TestWithParam<Device>
{
};
} // namespace

TEST_P(LMS3DScanProcesses, GiveTheBitsOfOneProcess)
{
  ExpectTheBitsOfOneProcess(GetParam());
}

// For this number of beams, tiles of single triangles pay in the parts of the room, too.
TEST(LMS3DScanProcess, DecidesTilesAsOneDoes)
{
  ExpectTheBitsOfOneProcess({ "Tiles", [](vtkLMS3DScanFilter* scan) { SetGrid(scan, 91, 360); } });
}

TEST(LMS3DScanProcess, DetectsWithWidthAndMotionAsOneDoes)
{
  const Device device = { "Detection",
    [](vtkLMS3DScanFilter* scan)
    {
      scan->SetDeviceToLMS291();
      scan->SetTrajectoryData(MakeShortDrive());
      scan->MotionDuringScanOn();
      scan->SetAxisOffset(0.1, 0.03, -0.05);
      scan->SetMinimumRange(1.2);
      scan->SetMaximumRange(5.0);
      scan->SetRangeAtTenPercent(1.5);
      scan->ComputeStatusOn();
      scan->ComputeIntensityOn();
      scan->SurfaceAttributesOn();
    } };
  ExpectTheBitsOfOneProcess(device);
}

TEST_P(LMS3DScanProcesses, AllStopIfOneDoes)
{
  const Scans scans = MakeScans(ReadRoom(), GetParam(), 2);
  // The calling thread reports. With several threads it may do no part of the cast.
  scans[1]->SetNumberOfThreads(1);
  const ProgressListener abort(scans[1],
    [&scans](double progress)
    {
      if (progress > 0.4)
      {
        scans[1]->AbortExecuteOn();
      }
    });
  Update(scans);
  for (const auto& scan : scans)
  {
    EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(scan->GetRangeImage()->GetNumberOfPoints(), 0);
  }
}

// All processes use the trajectory of the first.
TEST(LMS3DScanProcess, UsesTheMotionOfTheFirst)
{
  auto room = ReadRoom();
  const Device driving = { "Driving",
    [](vtkLMS3DScanFilter* scan)
    {
      scan->SetTrajectoryData(MakeShortDrive());
      scan->MotionDuringScanOn();
    } };
  const Scans alone = MakeScans(room, driving, 1);
  Update(alone);
  const Scans scans = MakeScans(room, driving, 2);
  scans[1]->SetTrajectoryData(nullptr);
  Update(scans);
  EXPECT_EQ(Hash(scans[0]->GetOutput()), Hash(alone[0]->GetOutput()));
}

INSTANTIATE_TEST_SUITE_P(All, LMS3DScanProcesses, testing::ValuesIn(GetDevices()),
  [](const testing::TestParamInfo<Device>& device) { return std::string(device.param.Name); });
