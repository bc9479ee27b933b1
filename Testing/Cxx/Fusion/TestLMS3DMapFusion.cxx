// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the map of several scans of the closed room: its bound, its free space, its size, its
 * growth.
 */
#include "Fixtures/ProgressListener.h"
#include "Fixtures/SceneBuilder.h"
#include "Fusion/FusionFixtures.h"

#include "vtkLMS3DScanFilter.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <set>
#include <string>

namespace
{
constexpr double MaximumError = 0.01;

vtkSmartPointer<vtkPolyData> Fuse(const std::vector<MappedScan>& scans, int threads = 0)
{
  vtkNew<vtkLMS3DMapFusion> fusion;
  fusion->SetNumberOfThreads(threads);
  AddAll(scans, fusion);
  fusion->Update();
  return fusion->GetOutput();
}

/// The number of triangles of each region.
std::map<int, int> CountByRegion(vtkPolyData* map)
{
  std::map<int, int> counts;
  vtkDataArray* const regions = map->GetCellData()->GetArray("RegionId");
  for (vtkIdType i = 0; i < map->GetNumberOfPolys(); ++i)
  {
    ++counts[static_cast<int>(regions->GetTuple1(i))];
  }
  return counts;
}
} // namespace

TEST(LMS3DMapFusion, JoinsFivePosesInTheRoom)
{
#ifdef LMS3D_FEWER_BEAMS
  const bool isCoarse = true;
#else
  const bool isCoarse = false;
#endif
  const std::vector<MappedScan> scans = ScanRoom(isCoarse);
  const vtkSmartPointer<vtkPolyData> fused = Fuse(scans);
  const FusionVerdict verdict = JudgeFusion(fused, scans, MaximumError);
  EXPECT_EQ(verdict.Beyond, 0) << verdict.LargestDistance;
  EXPECT_EQ(verdict.Blocked, 0);
  EXPECT_LE(static_cast<double>(verdict.Missed), 1e-3 * static_cast<double>(verdict.Returns));
  if (!isCoarse)
  {
    EXPECT_LT(2 * fused->GetNumberOfPolys(), CountTriangles(scans));
  }
}

/// Few beams meet each surface, so most of the returns lie at borders.
TEST(LMS3DMapFusion, MissesFewReturnsOfCoarseScans)
{
  const std::vector<MappedScan> scans = ScanRoom(true);
  const FusionVerdict verdict = JudgeFusion(Fuse(scans), scans, MaximumError);
  EXPECT_EQ(verdict.Beyond, 0) << verdict.LargestDistance;
  EXPECT_LE(static_cast<double>(verdict.Missed), 1e-3 * static_cast<double>(verdict.Returns));
}

TEST(LMS3DMapFusion, KeepsTheBoundOfNoisyScans)
{
  const std::vector<MappedScan> scans = ScanRoom(true, 0.002);
  const FusionVerdict verdict = JudgeFusion(Fuse(scans), scans, MaximumError);
  EXPECT_GT(verdict.Returns, 0);
  EXPECT_EQ(verdict.Beyond, 0) << verdict.LargestDistance;
}

// Pose errors are not corrected. Each return stays within the bound where its scan reports it, so
// surfaces double as soon as poses differ by more than the bound.
TEST(LMS3DMapFusion, KeepsTheBoundOfScansWithPoseErrors)
{
  std::vector<MappedScan> ideal = ScanRoom();
  ideal.resize(3);
  const vtkIdType expected = Fuse(ideal)->GetNumberOfPolys();
  vtkIdType triangles[3];
  const double errors[3] = { 0.001, 0.005, 0.02 };
  for (int i = 0; i < 3; ++i)
  {
    std::vector<MappedScan> scans = ScanRoom();
    scans.resize(3);
    for (std::size_t scan = 0; scan < scans.size(); ++scan)
    {
      const double shift = scan % 2 == 0 ? errors[i] : -errors[i];
      Move({ shift, 0.5 * shift, -0.5 * shift }, scans[scan]);
    }
    const vtkSmartPointer<vtkPolyData> fused = Fuse(scans);
    const FusionVerdict verdict = JudgeFusion(fused, scans, MaximumError);
    EXPECT_EQ(verdict.Beyond, 0) << errors[i] << ": " << verdict.LargestDistance;
    triangles[i] = fused->GetNumberOfPolys();
    RecordProperty("Triangles" + std::to_string(i), static_cast<int>(triangles[i]));
    RecordProperty("Blocked" + std::to_string(i), static_cast<int>(verdict.Blocked));
  }
  EXPECT_LT(triangles[0], 2 * expected);
  EXPECT_LT(triangles[0], triangles[2]);
}

TEST(LMS3DMapFusion, DoesNotDependOnThreads)
{
  const std::vector<MappedScan> scans = ScanRoom();
  const std::uint64_t expected = Hash(Fuse(scans, 1));
  EXPECT_EQ(Hash(Fuse(scans, 2)), expected);
  EXPECT_EQ(Hash(Fuse(scans, 5)), expected);
}

/// A pose in the open sees nothing.
TEST(LMS3DMapFusion, IsTheSameWithScansWithoutReturns)
{
  const std::vector<MappedScan> scans = ScanRoom();
  SceneBuilder far;
  far.AddTriangle({ 1e4, 0.0, 0.0 }, { 1e4, 1.0, 0.0 }, { 1e4, 0.0, 1.0 });
  const MappedScan empty = MakeMappedScan(far.GetSurface(), { 0.0, 0.0, 1.0 });
  ASSERT_EQ(empty.Scan->GetNumberOfPoints(), 0);
  std::vector<MappedScan> more;
  for (const MappedScan& scan : scans)
  {
    more.push_back(scan);
    more.push_back(empty);
  }
  const vtkSmartPointer<vtkPolyData> expected = Fuse(scans);
  const vtkSmartPointer<vtkPolyData> fused = Fuse(more);
  EXPECT_EQ(Hash(fused->GetPoints()->GetData()), Hash(expected->GetPoints()->GetData()));
  EXPECT_EQ(Hash(fused->GetPolys()->GetConnectivityArray()),
    Hash(expected->GetPolys()->GetConnectivityArray()));
}

TEST(LMS3DMapFusion, TakesASecondScanOfTheSamePlaceWithoutNewSheets)
{
  const vtkSmartPointer<vtkPolyData> room = ReadRoom();
  const MappedScan scan = MakeMappedScan(room, { 0.3, -0.2, 1.0 });
  const MappedScan again = MakeMappedScan(room, { 0.301, -0.2, 1.0 });
  const vtkIdType alone = Fuse({ scan })->GetNumberOfPolys();
  EXPECT_LT(Fuse({ scan, again })->GetNumberOfPolys(), alone + alone / 4);
}

TEST(LMS3DMapFusion, SaysWhichScansSawATriangle)
{
  const std::vector<MappedScan> scans = ScanRoom();
  const vtkSmartPointer<vtkPolyData> fused = Fuse(scans);
  vtkCellData* const data = fused->GetCellData();
  for (vtkIdType i = 0; i < fused->GetNumberOfPolys(); ++i)
  {
    const double best = data->GetArray("BestScan")->GetTuple1(i);
    const double last = data->GetArray("LastScan")->GetTuple1(i);
    const double count = data->GetArray("ScanCount")->GetTuple1(i);
    ASSERT_GE(best, 0.0);
    ASSERT_LE(best, last);
    ASSERT_LE(last, 4.0);
    ASSERT_GE(count, 1.0);
    ASSERT_LE(count, last + 1.0);
  }
  EXPECT_EQ(data->GetArray("ScanCount")->GetRange()[1], 5.0);
}

TEST(LMS3DMapFusion, ConnectionsGiveTheMapOfAddedScans)
{
  const std::vector<MappedScan> scans = ScanRoom();
  vtkNew<vtkLMS3DMapFusion> fusion;
  for (const MappedScan& scan : scans)
  {
    fusion->AddInputData(scan.Map);
    fusion->AddScanData(scan.Scan);
  }
  fusion->Update();
  EXPECT_EQ(fusion->GetNumberOfScans(), 5);
  const std::uint64_t expected = Hash(Fuse(scans));
  EXPECT_EQ(Hash(fusion->GetOutput()), expected);
  fusion->Modified();
  fusion->Update();
  EXPECT_EQ(fusion->GetNumberOfScans(), 5);
  EXPECT_EQ(Hash(fusion->GetOutput()), expected);
}

TEST(LMS3DMapFusion, GrowsWhileATrajectoryPlays)
{
  vtkNew<vtkPolyData> trajectory;
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> times;
  times->SetName("Time");
  for (int i = 0; i < 3; ++i)
  {
    points->InsertNextPoint(0.5 * i, 0.0, 1.0);
    times->InsertNextValue(i);
  }
  trajectory->SetPoints(points);
  trajectory->GetPointData()->AddArray(times);
  trajectory->Allocate(1);
  const vtkIdType ids[3] = { 0, 1, 2 };
  trajectory->InsertNextCell(VTK_POLY_LINE, 3, ids);
  vtkNew<vtkLMS3DScanFilter> scanner;
  scanner->SetInputData(ReadRoom());
  scanner->SetTrajectoryData(trajectory);
  SetGrid(scanner, 46, 45);
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> mapper;
  mapper->SetInputConnection(scanner->GetOutputPort());
  vtkNew<vtkLMS3DMapFusion> fusion;
  fusion->SetInputConnection(mapper->GetOutputPort());
  fusion->SetScanConnection(scanner->GetOutputPort());
  int expected = 0;
  for (double time : { 0.0, 1.0, 2.0 })
  {
    fusion->UpdateTimeStep(time);
    EXPECT_EQ(fusion->GetNumberOfScans(), ++expected);
  }
  fusion->UpdateTimeStep(0.0);
  EXPECT_EQ(fusion->GetNumberOfScans(), 3);
  mapper->SetDepthStep(0.05);
  fusion->UpdateTimeStep(1.0);
  EXPECT_EQ(fusion->GetNumberOfScans(), 1);
}

TEST(LMS3DMapFusion, SendsWhatChanged)
{
  const std::vector<MappedScan> scans = ScanRoom();
  vtkNew<vtkLMS3DMapFusion> fusion;
  fusion->AddScan(scans[0].Map, scans[0].Scan);
  fusion->AddScan(scans[1].Map, scans[1].Scan);
  fusion->Update();
  const int revision = fusion->GetRevision();
  std::map<int, int> known = CountByRegion(fusion->GetOutput());
  fusion->AddScan(scans[2].Map, scans[2].Scan);
  fusion->Update();
  vtkNew<vtkPolyData> delta;
  fusion->GetChanges(revision, delta);
  EXPECT_LT(delta->GetNumberOfPolys(), fusion->GetOutput()->GetNumberOfPolys());
  vtkDataArray* const changed = delta->GetFieldData()->GetArray("ChangedRegions");
  for (vtkIdType i = 0; i < changed->GetNumberOfTuples(); ++i)
  {
    known.erase(static_cast<int>(changed->GetTuple1(i)));
  }
  for (const auto& [region, count] : CountByRegion(delta))
  {
    known[region] += count;
  }
  EXPECT_EQ(known, CountByRegion(fusion->GetOutput()));
  fusion->GetChanges(fusion->GetRevision(), delta);
  EXPECT_EQ(delta->GetNumberOfPolys(), 0);
}

TEST(LMS3DMapFusion, TellsOfAResetAsOfChanges)
{
  const std::vector<MappedScan> scans = ScanRoom();
  vtkNew<vtkLMS3DMapFusion> fusion;
  fusion->AddScan(scans[0].Map, scans[0].Scan);
  fusion->Update();
  const int revision = fusion->GetRevision();
  const std::map<int, int> known = CountByRegion(fusion->GetOutput());
  fusion->Reset();
  EXPECT_GT(fusion->GetRevision(), revision);
  vtkNew<vtkPolyData> delta;
  fusion->GetChanges(revision, delta);
  EXPECT_EQ(delta->GetNumberOfPolys(), 0);
  std::set<int> changed;
  vtkDataArray* const array = delta->GetFieldData()->GetArray("ChangedRegions");
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    changed.insert(static_cast<int>(array->GetTuple1(i)));
  }
  for (const auto& [region, count] : known)
  {
    EXPECT_EQ(changed.count(region), 1U) << region << " of " << count << " triangles";
  }
}

TEST(LMS3DMapFusion, ForgetsWhatLaterScansSeeThrough)
{
  SceneBuilder before;
  SceneBuilder after;
  for (SceneBuilder* scene : { &before, &after })
  {
    scene->AddBox({ -3.0, -3.0, 0.0 }, { 3.0, 3.0, 2.5 });
  }
  before.AddBox({ 1.0, -0.5, 0.0 }, { 2.0, 0.5, 1.5 });
  const MappedScan first = MakeMappedScan(before.GetSurface(), { -1.0, 0.0, 1.2 });
  const MappedScan second = MakeMappedScan(after.GetSurface(), { -0.9, 0.3, 1.2 });
  for (int forgets = 0; forgets < 2; ++forgets)
  {
    vtkNew<vtkLMS3DMapFusion> fusion;
    fusion->SetForgetSeenThrough(forgets == 1);
    AddAll({ first, second }, fusion);
    fusion->Update();
    const FusionVerdict verdict = JudgeFusion(fusion->GetOutput(), second, MaximumError);
    EXPECT_EQ(verdict.Beyond, 0);
    const vtkIdType gone = JudgeFusion(fusion->GetOutput(), first, MaximumError).Beyond;
    if (forgets == 1)
    {
      EXPECT_GT(gone, 50);
      EXPECT_LT(verdict.Blocked, 5);
    }
    else
    {
      EXPECT_EQ(gone, 0);
    }
  }
}

TEST(LMS3DMapFusion, GivesNothingAfterAnAbort)
{
  const std::vector<MappedScan> scans = ScanRoom();
  vtkNew<vtkLMS3DMapFusion> fusion;
  fusion->SetInputData(scans[0].Map);
  fusion->SetScanData(scans[0].Scan);
  {
    const ProgressListener listener(fusion, [&](double) { fusion->SetAbortExecute(1); });
    fusion->Update();
  }
  EXPECT_EQ(fusion->GetOutput()->GetNumberOfPolys(), 0);
  EXPECT_EQ(fusion->GetNumberOfScans(), 0);
  fusion->SetAbortExecute(0);
  fusion->Update();
  EXPECT_EQ(fusion->GetNumberOfScans(), 1);
}

/// Without the ranges of earlier scans, what a later scan guesses may block their beams.
TEST(LMS3DMapFusion, BlocksFewBeamsAndForgetsFewReturns)
{
  const std::vector<MappedScan> scans = ScanRoomAnywhere(10);
  const auto judge = [&](bool keepsReturns, bool forgets)
  {
    vtkNew<vtkLMS3DMapFusion> fusion;
    fusion->SetKeepReturns(keepsReturns);
    fusion->SetForgetSeenThrough(forgets);
    AddAll(scans, fusion);
    fusion->Update();
    return JudgeFusion(fusion->GetOutput(), scans, MaximumError);
  };
  const FusionVerdict kept = judge(true, false);
  EXPECT_EQ(kept.Beyond, 0);
  EXPECT_LE(kept.Blocked, 3);
  const FusionVerdict dropped = judge(false, false);
  EXPECT_EQ(dropped.Beyond, 0);
  EXPECT_GT(dropped.Blocked, 0);
  EXPECT_LT(50 * dropped.Blocked, dropped.Returns);
  const FusionVerdict forgotten = judge(true, true);
  EXPECT_LE(forgotten.Blocked, 3);
  EXPECT_LT(100 * forgotten.Beyond, forgotten.Returns);
}
