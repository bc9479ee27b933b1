// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Scenes with hidden, duplicate and missing cells.
 */
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkErrorCode.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace
{
/// Marks the first cells of a data set.
void MarkCells(vtkDataSet* data, vtkIdType count, unsigned char mark)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(data->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    ghosts->SetValue(cell, cell < count ? mark : 0);
  }
  data->GetCellData()->AddArray(ghosts);
}

void NumberCells(vtkDataSet* data, const std::function<vtkIdType(vtkIdType)>& getId)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Ids");
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    ids->InsertNextValue(getId(cell));
  }
  data->GetCellData()->SetGlobalIds(ids);
}

/// Two floors below the sensor, cell 0 at 1 m and cell 1 at 2 m.
vtkSmartPointer<vtkPolyData> MakeTwoFloors()
{
  return Join(MakeFloor(10.0, -1.0), MakeFloor(10.0, -2.0));
}

/// Looks straight down.
vtkSmartPointer<vtkLMS3DScanFilter> LookDown(vtkDataObject* scene)
{
  auto scan = MakeScan(scene);
  scan->SetAlphaRange(-90.0, -90.0);
  SetGrid(scan, 1, 1);
  return scan;
}
} // namespace

// --- Hidden and duplicate cells -----------------------------------------------------------------

TEST(LMS3DScanScene, SkipsHiddenPolygons)
{
  auto floors = MakeTwoFloors();
  MarkCells(floors, 1, vtkDataSetAttributes::HIDDENCELL);
  auto scan = LookDown(floors);
  EXPECT_EQ(UpdateAndGetWarning(scan), "");
  EXPECT_EQ(GetRange(scan, 0), 2.0);
  EXPECT_EQ(GetArray(scan, "CellId")->GetTuple1(0), 1.0);
}

TEST(LMS3DScanScene, SkipsHiddenStrips)
{
  auto floors = MakeTwoFloors();
  const vtkIdType corners[4] = { 0, 1, 3, 2 };
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell(4, corners);
  floors->SetStrips(strips);
  // The strip is cell 2.
  MarkCells(floors, 3, vtkDataSetAttributes::HIDDENCELL);
  vtkUnsignedCharArray* ghosts = floors->GetCellGhostArray();
  ghosts->SetValue(1, 0);
  auto scan = LookDown(floors);
  scan->Update();
  EXPECT_EQ(GetRange(scan, 0), 2.0);

  ghosts->SetValue(2, 0);
  ghosts->Modified();
  scan->Modified();
  scan->Update();
  EXPECT_EQ(GetRange(scan, 0), 1.0);
  EXPECT_EQ(GetArray(scan, "CellId")->GetTuple1(0), 2.0);
}

TEST(LMS3DScanScene, SkipsHiddenCellsOfABlock)
{
  auto hidden = MakeFloor(10.0, -1.0);
  MarkCells(hidden, 1, vtkDataSetAttributes::HIDDENCELL);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, hidden);
  blocks->SetBlock(1, MakeFloor(10.0, -2.0));
  auto scan = LookDown(blocks);
  scan->Update();
  EXPECT_EQ(GetRange(scan, 0), 2.0);
  EXPECT_EQ(GetArray(scan, "CellId")->GetTuple1(0), 1.0);
}

TEST(LMS3DScanScene, SeesTheVolumeBehindAHiddenVolumeCell)
{
  // Cells from z = -4 to -2, from -2 to 0 and from 0 to 2; the sensor is above them.
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 4);
  image->SetOrigin(-1.0, -1.0, -4.0);
  image->SetSpacing(2.0, 2.0, 2.0);
  MarkCells(image, 0, 0);
  auto scan = LookDown(image);
  scan->SetPosition(0.1, 0.2, 5.0);
  scan->Update();
  EXPECT_EQ(GetRange(scan, 0), 3.0);

  image->GetCellGhostArray()->SetValue(2, vtkDataSetAttributes::HIDDENCELL);
  image->GetCellGhostArray()->Modified();
  scan->Modified();
  scan->Update();
  EXPECT_EQ(GetRange(scan, 0), 5.0);
}

TEST(LMS3DScanScene, ScansOtherGhostCells)
{
  for (unsigned char mark : { vtkDataSetAttributes::DUPLICATECELL,
         vtkDataSetAttributes::HIGHCONNECTIVITYCELL, vtkDataSetAttributes::EXTERIORCELL })
  {
    auto floors = MakeTwoFloors();
    MarkCells(floors, 1, mark);
    auto scan = LookDown(floors);
    scan->Update();
    EXPECT_EQ(GetRange(scan, 0), 1.0) << static_cast<int>(mark);
  }
}

TEST(LMS3DScanScene, ScansPolygonsAtHiddenPoints)
{
  auto floors = MakeTwoFloors();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(floors->GetNumberOfPoints());
  ghosts->FillValue(vtkDataSetAttributes::HIDDENPOINT);
  floors->GetPointData()->AddArray(ghosts);
  auto scan = LookDown(floors);
  scan->Update();
  EXPECT_EQ(GetRange(scan, 0), 1.0);
}

TEST(LMS3DScanScene, ReportsASceneOfHiddenCells)
{
  auto floors = MakeTwoFloors();
  MarkCells(floors, 2, vtkDataSetAttributes::HIDDENCELL);
  auto scan = LookDown(floors);
  const std::string error = UpdateAndGetError(scan);
  EXPECT_NE(error.find("vtkGhostType hides all polygons, 2 cells"), std::string::npos) << error;
  EXPECT_EQ(scan->GetErrorCode(), vtkErrorCode::UserError);
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(LMS3DScanScene, IgnoresBadPointsOfHiddenCells)
{
  auto floors = MakeTwoFloors();
  floors->GetPoints()->SetPoint(0, VTK_DOUBLE_MAX, 0.0, 0.0);
  MarkCells(floors, 1, vtkDataSetAttributes::HIDDENCELL);
  auto scan = LookDown(floors);
  EXPECT_EQ(UpdateAndGetWarning(scan), "");
  EXPECT_EQ(GetRange(scan, 0), 2.0);
}

// --- Missing cells ------------------------------------------------------------------------------

TEST(LMS3DScanScene, WarnsOnceIfGlobalIdsShowThatCellsAreMissing)
{
  auto ball = MakeBall(1.0, 12);
  const vtkIdType cells = ball->GetNumberOfCells();
  NumberCells(ball, [](vtkIdType cell) { return 2 * cell; });
  auto scan = MakeScan(ball);
  SetGrid(scan, 9, 8);
  const std::string warning = UpdateAndGetWarning(scan);
  EXPECT_NE(warning.find("go up to " + std::to_string(2 * (cells - 1))), std::string::npos)
    << warning;
  EXPECT_NE(warning.find("only " + std::to_string(cells) + " cells"), std::string::npos) << warning;
  EXPECT_EQ(scan->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 72);

  scan->SetPosition(0.1, 0.0, 0.0);
  EXPECT_EQ(UpdateAndGetWarning(scan), "");
}

TEST(LMS3DScanScene, WarnsIfTheLastIdOfABlockIsMissing)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int block = 0; block < 2; ++block)
  {
    auto ball = MakeBall(1.0 + block, 12);
    const vtkIdType first = block * (ball->GetNumberOfCells() + 1);
    NumberCells(ball, [first](vtkIdType cell) { return first + cell; });
    blocks->SetBlock(block, ball);
  }
  auto scan = MakeScan(blocks);
  SetGrid(scan, 9, 8);
  EXPECT_NE(UpdateAndGetWarning(scan).find("global ids"), std::string::npos);
}

TEST(LMS3DScanScene, DoesNotWarnIfAllIdsAreThere)
{
  const std::function<vtkIdType(vtkIdType)> numberings[] = {
    [](vtkIdType cell) { return cell; },
    [](vtkIdType cell) { return cell + 1; }, // as Exodus files number
    [](vtkIdType cell) { return cell / 2; }, // copies of cells
  };
  for (const auto& numbering : numberings)
  {
    auto ball = MakeBall(1.0, 12);
    NumberCells(ball, numbering);
    auto scan = MakeScan(ball);
    SetGrid(scan, 9, 8);
    EXPECT_EQ(UpdateAndGetWarning(scan), "");
  }
}

TEST(LMS3DScanScene, DoesNotWarnIfSomeCellsHaveNoIds)
{
  auto numbered = MakeBall(1.0, 12);
  NumberCells(numbered, [](vtkIdType cell) { return 1000 + cell; });
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, numbered);
  blocks->SetBlock(1, MakeBall(2.0, 12));
  auto scan = MakeScan(blocks);
  SetGrid(scan, 9, 8);
  EXPECT_EQ(UpdateAndGetWarning(scan), "");
}
