// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that the regions of a fused map leave no gaps between them, and that they close a room
 * that was seen wholly.
 */
#include "Fixtures/ScanDamage.h"
#include "Fixtures/SceneBuilder.h"
#include "Fusion/SeamFixtures.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkNew.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace
{
/// A tile of a plane is 3.4 m wide with a bound of 1 cm, so walls have several.
vtkSmartPointer<vtkPolyData> MakeHall()
{
  SceneBuilder scene;
  scene.AddBox({ -5.0, -3.0, 0.0 }, { 5.0, 3.0, 2.5 });
  return scene.GetSurface();
}

/// A place in the hall.
const Vector Inside = { 0.5, 0.5, 1.2 };

const std::vector<Point> Poses = { { -2.0, -1.2, 1.0 }, { 2.0, -1.0, 1.4 }, { 0.0, 0.3, 1.2 } };

void Record(const std::string& name, const Seams& seams, double sheets)
{
  testing::Test::RecordProperty(name + "Samples", seams.Samples);
  testing::Test::RecordProperty(name + "Open", seams.Open);
  testing::Test::RecordProperty(name + "Loose", seams.Loose);
  testing::Test::RecordProperty(name + "Sheets", std::to_string(sheets));
}

/// Seams must be closed, unless some are expected to be open, and the hall must be around `Inside`
/// once, within the tolerance.
void ExpectClosed(
  std::size_t pose, double bound, double tolerance, bool isOpen, vtkLMS3DMapFusion* fusion)
{
  fusion->Update();
  const Seams seams = FindSeams(fusion->GetOutput(), MakeHall(), bound);
  const double sheets = CountSheetsAround(fusion->GetOutput(), Inside);
  Record("Poses" + std::to_string(pose + 1), seams, sheets);
  EXPECT_GT(seams.Samples, 0);
  EXPECT_EQ(seams.Open > 0, isOpen) << seams.Open;
  EXPECT_NEAR(sheets, 1.0, tolerance);
}
} // namespace

// The beams of one pose leave gaps along creases that they meet at grazing angles.
TEST(LMS3DFusedSeams, CloseAHall)
{
  constexpr double Bound = 0.01;
  vtkNew<vtkLMS3DMapFusion> fusion;
  for (std::size_t i = 0; i < Poses.size(); ++i)
  {
    AddAll({ MakeMappedScan(MakeHall(), Poses[i], false) }, fusion);
    ExpectClosed(i, Bound, i == 0 ? 1e-3 : 1e-4, i == 0, fusion);
  }
}

// Two poses see the whole hall, so its map is closed, and has the Euler number of a sphere; a third
// one leaves it so. One pose does not see it wholly, and its map has holes.
TEST(LMS3DFusedSeams, HaveTheEulerNumberOfASphere)
{
  vtkNew<vtkLMS3DMapFusion> fusion;
  AddAll({ MakeMappedScan(MakeHall(), Poses[0], false) }, fusion);
  fusion->Update();
  EXPECT_GT(JoinedMap(fusion->GetOutput()).CountOpenEdges(), 0);
  for (std::size_t i = 1; i < Poses.size(); ++i)
  {
    AddAll({ MakeMappedScan(MakeHall(), Poses[i], false) }, fusion);
    fusion->Update();
    const JoinedMap joined(fusion->GetOutput());
    EXPECT_EQ(joined.CountOpenEdges(), 0) << i;
    EXPECT_EQ(joined.GetEulerNumber(), 2) << i;
  }
}

// Strays get facets in free space. They pass no wall. With a bound of 30 mm, borders move outwards
// far enough to close the gaps of lost beams, which Status calls too weak, from the first pose on.
// The local maps have these gaps.
TEST(LMS3DFusedSeams, HoldWithDropoutsAndStrays)
{
  constexpr double Bound = 0.03;
  vtkNew<vtkLMS3DMapFusion> fusion;
  fusion->SetMaximumError(Bound);
  for (std::size_t i = 0; i < Poses.size(); ++i)
  {
    ScanDamage damage;
    damage.Seed = static_cast<int>(i);
    damage.Dropouts = 0.02;
    damage.Strays = 0.002;
    damage.Noise = 0.002;
    const auto scanner = MakeScan(MakeHall());
    scanner->SetPosition(Poses[i][0], Poses[i][1], Poses[i][2]);
    scanner->SetComputeStatus(true);
    scanner->Update();
    vtkNew<vtkLMS3DSurfaceReconstructionFilter> mapper;
    mapper->SetInputData(Damage(scanner->GetOutput(), damage));
    mapper->SetMaximumError(Bound);
    mapper->SetMaximumGapSize(0);
    mapper->Update();
    AddAll({ { mapper->GetPolyDataInput(0), mapper->GetOutput() } }, fusion);
    ExpectClosed(i, Bound, i == 0 ? 1e-2 : 1e-3, false, fusion);
  }
}
