// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// The third output of vtkLMS3DRemoteSource: the server's map of many scans.
#include "ClientORB.h"
#include "NetworkLine.h"
#include "ServerProcess.h"
#include "WatchingSource.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

TEST(RemoteFusedSource, FollowsTheFusedMap)
{
  ServerProcess server({ "--fused-map", "0.02" });
  WatchingSource source(server.GetCorbaloc());
  source->Update();
  EXPECT_EQ(source->GetFusedMap()->GetNumberOfCells(), 0);
  source->FetchFusedMapOn();
  const auto countScans = [&source]
  {
    vtkDataArray* const scans = source->GetFusedMap()->GetFieldData()->GetArray("NumberOfScans");
    return scans ? scans->GetTuple1(0) : 0.0;
  };
  EXPECT_TRUE(source.UpdateUntil([&] { return countScans() == 1.0; }));
  const vtkIdType triangles = source->GetFusedMap()->GetNumberOfCells();
  source->SetPosition(1.25, 0.5, 1.5);
  source->SendPose();
  EXPECT_TRUE(source.UpdateUntil([&] { return countScans() == 2.0; }));
  EXPECT_NE(source->GetFusedMap()->GetNumberOfCells(), triangles);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::FusedMapHeader_var header = scanner->getFusedMapHeader(0);
  EXPECT_EQ(source->GetFusedMap()->GetNumberOfCells(), header->triangles);
  EXPECT_EQ(source->GetProblem(), "");
}

TEST(RemoteFusedSource, TheFusedMapComesBackWithoutANewPose)
{
  ServerProcess server({ "--fused-map", "0.02" });
  WatchingSource source(server.GetCorbaloc());
  source->FetchFusedMapOn();
  const auto isThere = [&source] { return source->GetFusedMap()->GetNumberOfCells() > 0; };
  source->Update();
  ASSERT_TRUE(source.UpdateUntil(isThere));
  const vtkIdType triangles = source->GetFusedMap()->GetNumberOfCells();
  source->FetchFusedMapOff();
  source->Update();
  EXPECT_EQ(source->GetFusedMap()->GetNumberOfCells(), 0);
  // Some scans later, the source has dropped the map.
  const std::uint64_t before = source.GetNumber("ScanNumber");
  ASSERT_TRUE(source.UpdateUntil([&] { return source.GetNumber("ScanNumber") > before + 2; }));
  source->FetchFusedMapOn();
  EXPECT_TRUE(source.UpdateUntil(isThere));
  EXPECT_EQ(source->GetFusedMap()->GetNumberOfCells(), triangles);
}

// The next scan of the server would come after the test.
TEST(RemoteFusedSource, TheFusedMapComesWithTheSameScanAfterReconnecting)
{
  ServerProcess server({ "--fused-map", "0.02", "--rate", "0.01" });
  NetworkLine line(server.GetCorbaloc());
  WatchingSource source(line.GetCorbaloc());
  // With sanitizers, the first scan and its map take more than the default.
  source->SetTimeout(10.0);
  source->Update();
  ASSERT_EQ(source.GetNumber("ScanNumber"), 1U);
  source->FetchFusedMapOn();
  source->Update();
  EXPECT_EQ(source->GetFusedMap()->GetNumberOfCells(), 0);
  line.BreakAt("waitForScan");
  EXPECT_TRUE(source.UpdateUntil([&] { return source->GetFusedMap()->GetNumberOfCells() > 0; }));
  EXPECT_TRUE(line.IsBroken());
  EXPECT_EQ(source.GetNumber("ScanNumber"), 1U);
}

TEST(RemoteFusedSource, ScansComeAlsoIfTheFusedMapDoesNot)
{
  ServerProcess server({ "--fused-map", "0.02" });
  NetworkLine line(server.GetCorbaloc());
  line.Lose("getFusedMap");
  WatchingSource source(line.GetCorbaloc());
  source->SetTimeout(1.0);
  source->FetchFusedMapOn();
  source->Update();
  ASSERT_TRUE(source.UpdateUntil([&] { return source.GetNumber("ScanNumber") > 0; }));
  const std::uint64_t first = source.GetNumber("ScanNumber");
  EXPECT_TRUE(source.UpdateUntil([&] { return source.GetNumber("ScanNumber") >= first + 3; }));
  EXPECT_NE(
    source->GetProblem().find("fused map cannot be fetched within the Timeout"), std::string::npos)
    << source->GetProblem();
  line.Lose("");
  EXPECT_TRUE(source.UpdateUntil([&] { return source->GetFusedMap()->GetNumberOfCells() > 0; }));
  EXPECT_EQ(source->GetProblem(), "");
}

TEST(RemoteFusedSource, WarnsIfThereIsNoFusedMap)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  source->FetchFusedMapOn();
  source->Update();
  EXPECT_TRUE(source.UpdateUntil([&] { return !source->GetProblem().empty(); }));
  EXPECT_NE(source->GetProblem().find("--fused-map"), std::string::npos) << source->GetProblem();
  EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 129960);
  EXPECT_EQ(source->GetFusedMap()->GetNumberOfCells(), 0);
}
