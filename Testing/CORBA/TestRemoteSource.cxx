// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClientORB.h"
#include "DirectPipeline.h"
#include "ServerProcess.h"
#include "WatchingSource.h"
#include "vtkLMS3DSurfaceReconstructionFilter.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
// Misses, a rotated sensor, and a grid that does not begin at 0.
void MakeUnusual(LMS3D::LaserScanner_ptr scanner)
{
  LMS3D::Configuration configuration = GetCoarseGrid();
  configuration.alpha = { -72.5, 31.0, 47 };
  configuration.beta = { -33.0, 327.0, 91 };
  configuration.minimumRange = 1.5;
  configuration.maximumRange = 4.25;
  scanner->setConfiguration(configuration);
  LMS3D::Pose pose = At(0.4, -0.3, 0.9);
  pose.orientation = { 10.0, -20.0, 30.0 };
  scanner->setPose(pose);
}

void ExpectRanges(vtkPolyData* scan, const DirectPipeline& direct)
{
  vtkDataArray* ranges = scan->GetPointData()->GetArray("Range");
  vtkDataArray* beamIds = scan->GetPointData()->GetArray("BeamId");
  ASSERT_EQ(3 * scan->GetNumberOfPoints(), static_cast<vtkIdType>(direct.ReturnPoints.size()));
  constexpr double rounding = std::numeric_limits<float>::epsilon() / 2;
  for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
  {
    const double range = ranges->GetTuple1(i);
    ASSERT_EQ(range, direct.Ranges[static_cast<std::size_t>(beamIds->GetTuple1(i))]);
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_NEAR(scan->GetPoint(i)[axis], direct.ReturnPoints[3 * i + axis], rounding * range);
    }
  }
}

void ExpectMap(vtkPolyData* map, const DirectPipeline& direct)
{
  ASSERT_EQ(3 * map->GetNumberOfPoints(), static_cast<vtkIdType>(direct.MapPoints.size()));
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_EQ(map->GetPoint(i)[axis], direct.MapPoints[3 * i + axis]);
    }
  }
  ASSERT_EQ(3 * map->GetNumberOfPolys(), static_cast<vtkIdType>(direct.MapTriangles.size()));
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < map->GetNumberOfPolys(); ++i)
  {
    map->GetPolys()->GetCellAtId(i, corners);
    ASSERT_EQ(corners->GetNumberOfIds(), 3);
    for (int corner = 0; corner < 3; ++corner)
    {
      ASSERT_EQ(corners->GetId(corner), direct.MapTriangles[3 * i + corner]);
    }
  }
}
} // namespace

TEST(RemoteSource, OutputsAreThoseOfTheDirectPipeline)
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  for (const bool isUnusual : { false, true })
  {
    if (isUnusual)
    {
      MakeUnusual(scanner);
    }
    const LMS3D::ScanHeader header = WaitFor(scanner, isUnusual ? 3 : 1);
    WatchingSource source(server.GetCorbaloc());
    source->Update();
    ASSERT_GE(source.GetNumber("Generation"), header.generation);
    const DirectPipeline direct("room.wrl", header.sensorPose, header.settings);
    ExpectRanges(source.GetScan(), direct);
    ExpectMap(source.GetMap(), direct);
  }
}

TEST(RemoteSource, ScanIsTakenByTheReconstruction)
{
  ServerProcess server;
  WatchingSource source(server.GetIOR());
  vtkNew<vtkLMS3DSurfaceReconstructionFilter> reconstruction;
  reconstruction->SetNumberOfThreads(FilterThreads);
  reconstruction->SetInputConnection(source->GetOutputPort());
  reconstruction->Update();
  const vtkIdType made = reconstruction->GetOutput()->GetNumberOfPolys();
  // The server makes its map from ranges in double precision.
  EXPECT_NEAR(static_cast<double>(made), static_cast<double>(source.GetMap()->GetNumberOfPolys()),
    0.02 * static_cast<double>(made));
  EXPECT_GT(made, 1000);
}

TEST(RemoteSource, FollowsTheScansAndReportsTheirOrigin)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  EXPECT_FALSE(source->GetNeedsUpdate());
  source->Update();
  const std::uint64_t first = source.GetNumber("ScanNumber");
  EXPECT_TRUE(source.UpdateUntil([&] { return source.GetNumber("ScanNumber") >= first + 3; }));
  EXPECT_GT(source.GetNumber("EndTime"), source.GetNumber("StartTime"));
  EXPECT_GT(source.GetNumber("Incarnation"), 0u);
  EXPECT_EQ(
    source.GetScan()->GetFieldData()->GetAbstractArray("Scene")->GetVariantValue(0), "room.wrl");
  EXPECT_EQ(source->GetProblem(), "");
  EXPECT_EQ(source.TakeWarnings(), "");
}

TEST(RemoteSource, SendsThePose)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  source->SetPosition(1.25, 0.5, 1.5);
  source->Update();
  EXPECT_EQ(source.GetSensorX(), 0.3) << "the pose was sent by itself";
  source->SendPose();
  EXPECT_TRUE(source.UpdateUntil([&] { return source.GetSensorX() == 1.25; }));
  EXPECT_EQ(source->GetProblem(), "");
}

TEST(RemoteSource, WarnsOfAPoseThatIsRefused)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  source->SetPosition(2e6, 0.0, 0.0);
  source->Update();
  source->SendPose();
  std::string warnings;
  EXPECT_TRUE(source.UpdateUntil([&] { return !(warnings += source.TakeWarnings()).empty(); }));
  EXPECT_NE(warnings.find("1e6 m"), std::string::npos) << warnings;
  EXPECT_EQ(source.GetSensorX(), 0.3);
}

TEST(RemoteSource, ForgetsARefusalWithTheNextPose)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  source->SetPosition(2e6, 0.0, 0.0);
  source->Update();
  source->SendPose();
  EXPECT_TRUE(source.UpdateUntil([&] { return !source->IsPosePending(); }));
  EXPECT_NE(source->GetProblem(), "");
  source->SetPosition(1.25, 0.5, 1.5);
  source->SendPose();
  EXPECT_EQ(source->GetProblem(), "");
  EXPECT_TRUE(source.UpdateUntil([&] { return !source->IsPosePending(); }));
  EXPECT_EQ(source.GetSensorX(), 1.25);
  EXPECT_EQ(source->GetProblem(), "");
}

TEST(RemoteSource, APoseIsPendingUntilAScanIsFromThere)
{
  ServerProcess server({ "--rate", "0.5" });
  WatchingSource source(server.GetCorbaloc());
  source->Update();
  EXPECT_FALSE(source->IsPosePending());
  source->SetPosition(1.25, 0.5, 1.5);
  source->SendPose();
  EXPECT_TRUE(source.UpdateUntil([&] { return !source->IsPosePending(); }));
  EXPECT_EQ(source.GetSensorX(), 1.25);
}

TEST(RemoteSource, WaitsForTheFirstScanAfterAPoseToo)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  EXPECT_FALSE(source->GetNeedsUpdate());
  source->SetPosition(0.3, -0.2, 1.0);
  source->SendPose();
  EXPECT_TRUE(source->GetNeedsUpdate());
  source->Update();
  EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 129960);
}

TEST(RemoteSource, WarnsWhereTheServerIsReadOnly)
{
  ServerProcess server({ "--read-only" });
  WatchingSource source(server.GetCorbaloc());
  source->Update();
  source->SendPose();
  EXPECT_TRUE(source.UpdateUntil([&] { return !source->GetProblem().empty(); }));
  EXPECT_NE(source->GetProblem().find("not permit"), std::string::npos) << source->GetProblem();
}

TEST(RemoteSource, ServersMayMakeNoMaps)
{
  ServerProcess server({ "--no-map" });
  WatchingSource source(server.GetCorbaloc());
  source->Update();
  EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 129960);
  EXPECT_EQ(source.GetMap()->GetNumberOfPolys(), 0);
  EXPECT_EQ(source->GetProblem(), "");
}

TEST(RemoteSource, OnlyTheFirstOfSeveralProcessesHasTheScan)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  source->UpdatePiece(1, 2, 0);
  EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 0);
  source->UpdatePiece(0, 2, 0);
  EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 129960);
}
