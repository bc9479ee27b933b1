// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Client/lms3dRemoteData.h"
#include "ClientORB.h"
#include "Common/lms3dChecksum.h"
#include "DirectPipeline.h"
#include "ServerProcess.h"

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace
{
// Enough scans that none is dropped during a test, even on a busy machine.
const std::vector<std::string> Patience = { "--keep", "100" };

template <typename Sequence>
auto ToVector(const Sequence& sequence)
{
  using Element = std::decay_t<decltype(sequence[0])>;
  return std::vector<Element>(sequence.get_buffer(), sequence.get_buffer() + sequence.length());
}

DirectPipeline MakeDirect(const LMS3D::ScanHeader& header)
{
  return DirectPipeline(header.scene.in(), header.sensorPose, header.settings);
}

// A grid with misses, a full circle that does not begin at 0, and a rotated sensor.
LMS3D::Configuration GetUnusualGrid()
{
  LMS3D::Configuration configuration = GetCoarseGrid();
  configuration.alpha = { -72.5, 31.0, 47 };
  configuration.beta = { -33.0, 327.0, 91 };
  configuration.minimumRange = 1.5;
  configuration.maximumRange = 4.25;
  return configuration;
}

// A rotated sensor, and beams without a return.
LMS3D::ScanHeader ScanUnusually(LMS3D::LaserScanner_ptr scanner)
{
  LMS3D::Pose pose = At(0.4, -0.3, 0.9);
  pose.orientation = { 10.0, -20.0, 30.0 };
  scanner->setPose(pose);
  return WaitFor(scanner, scanner->setConfiguration(GetUnusualGrid()));
}
} // namespace

TEST(ServerValues, FetchGivesTheDirectPipelinesTriples)
{
  ServerProcess server(Patience);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::Data_var triples = scanner->fetch();
  ASSERT_EQ(triples->length(), 389880u);
  const DirectPipeline direct = MakeDirect(WaitFor(scanner));
  EXPECT_EQ(ToVector(triples.in()), direct.Triples);
  EXPECT_EQ(server.Terminate(SIGTERM), 0);
}

TEST(ServerValues, FetchKeepsMissesInPlace)
{
  ServerProcess server(Patience);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::ScanHeader header = ScanUnusually(scanner);
  const LMS3D::Data_var triples = scanner->fetch();
  const DirectPipeline direct = MakeDirect(header);
  EXPECT_EQ(ToVector(triples.in()), direct.Triples);
  EXPECT_EQ(header.beams, 47u * 91u);
  EXPECT_GT(header.returns, 100u);
  EXPECT_LT(header.returns, header.beams - 100u);
  EXPECT_EQ(3 * std::size_t(header.returns), direct.ReturnPoints.size());
}

TEST(ServerValues, WholeScanAndPartsAreTheDirectPipelines)
{
  ServerProcess server(Patience);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  WaitFor(scanner);
  const LMS3D::Scan_var scan = scanner->getScan();
  const DirectPipeline direct = MakeDirect(scan->header);
  EXPECT_EQ(ToVector(scan->beamRanges), direct.Ranges);
  EXPECT_EQ(scan->header.rangesChecksum, lms3dGetRangesChecksum(direct.Ranges));

  const LMS3D::ScanHeader header = WaitFor(scanner);
  const LMS3D::Ranges_var middle = scanner->getRanges(header.number, 1000, 361);
  EXPECT_EQ(ToVector(middle.in()),
    std::vector<float>(direct.Ranges.begin() + 1000, direct.Ranges.begin() + 1361));
  const LMS3D::Ranges_var nothing = scanner->getRanges(header.number, header.beams, 0);
  EXPECT_EQ(nothing->length(), 0u);
}

TEST(ServerValues, MapIsTheDirectPipelines)
{
  ServerProcess server(Patience);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::ScanHeader header = WaitFor(scanner);
  const lms3dRemoteScan remote = lms3dFetchScan(scanner, header);
  const DirectPipeline direct = MakeDirect(header);
  EXPECT_GT(header.mapTriangles, 1000u);
  EXPECT_EQ(remote.Ranges, direct.Ranges);
  EXPECT_EQ(remote.MapPoints, direct.MapPoints);
  EXPECT_EQ(remote.MapTriangles, direct.MapTriangles);
}

TEST(ServerValues, VTKDataOfTheClientAreTheDirectPipelines)
{
  ServerProcess server(Patience);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::ScanHeader header = ScanUnusually(scanner);
  const DirectPipeline direct = MakeDirect(header);

  vtkNew<vtkPolyData> scan;
  lms3dFillScan(lms3dFetchScan(scanner, header), scan);
  ASSERT_EQ(3 * std::size_t(scan->GetNumberOfPoints()), direct.ReturnPoints.size());
  ASSERT_EQ(scan->GetNumberOfVerts(), scan->GetNumberOfPoints());
  for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
  {
    // Half a unit in the last place of a float of up to 4.25 m.
    constexpr double FloatRounding = 2.4e-7;
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(scan->GetPoint(i)[axis], direct.ReturnPoints[3 * i + axis], FloatRounding);
    }
  }
}

TEST(ServerValues, AScanWithoutReturnsIsAScan)
{
  ServerProcess server(Patience);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::ScanHeader header = WaitFor(scanner, scanner->setPose(At(1e6, 0.0, 0.0)));
  EXPECT_EQ(header.returns, 0u);
  EXPECT_EQ(header.mapPoints, 0u);
  EXPECT_EQ(header.mapTriangles, 0u);
  const lms3dRemoteScan remote = lms3dFetchScan(scanner, header);
  EXPECT_EQ(remote.Ranges, std::vector<float>(header.beams, 0.0f));
  const LMS3D::Status_var status = scanner->getStatus();
  EXPECT_STREQ(status->problem, "");
  EXPECT_EQ(server.Terminate(SIGTERM), 0);
}

// As floats such ranges would be 0, which means that nothing was hit.
TEST(ServerValues, ReturnsBelowTheSmallestFloatAreReturns)
{
  const std::filesystem::path folder =
    std::filesystem::path(testing::TempDir()) / ("lms3d-floor-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "floor.wrl")
    << "#VRML V2.0 utf8\nShape { geometry IndexedFaceSet { coord Coordinate { point [ -9 -9 0,"
       " 9 -9 0, 9 9 0, -9 9 0 ] } coordIndex [ 0, 1, 2, 3, -1 ] } }\n";
  {
    ServerProcess server({ "--scenes", folder.string(), "--scene", "floor.wrl", "--keep", "50" });
    const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
    for (const double height : { 1.0, 1e-46, 1e-310 })
    {
      const LMS3D::ScanHeader header = WaitFor(scanner, scanner->setPose(At(0.0, 0.0, height)));
      EXPECT_GT(header.returns, 10000u) << height;
      const lms3dRemoteScan remote = lms3dFetchScan(scanner, header);
      const auto returns = std::count_if(
        remote.Ranges.begin(), remote.Ranges.end(), [](float range) { return range > 0.0f; });
      EXPECT_EQ(returns, header.returns) << height;
    }
  }
  std::filesystem::remove_all(folder);
}

TEST(ServerValues, ChoosesScenes)
{
  ServerProcess server(Patience);
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  LMS3D::SceneNames_var names = scanner->listScenes();
  ASSERT_EQ(names->length(), 3u);
  EXPECT_STREQ(names[0u], "building.wrl");
  EXPECT_STREQ(names[1u], "room.wrl");
  EXPECT_STREQ(names[2u], "teapot.wrl");

  scanner->setPose(At(0.0, 0.0, 8.0));
  const LMS3D::ScanHeader header = WaitFor(scanner, scanner->selectScene("teapot.wrl"));
  EXPECT_STREQ(header.scene.in(), "teapot.wrl");
  EXPECT_GT(header.returns, 0u);
  const lms3dRemoteScan remote = lms3dFetchScan(scanner, header);
  EXPECT_EQ(remote.Ranges, MakeDirect(header).Ranges);
  const LMS3D::Scene_var scene = scanner->getScene();
  EXPECT_STREQ(scene->name, "teapot.wrl");
  EXPECT_EQ(scene->triangles, 3080u);
  EXPECT_LT(scene->lowest.x, scene->highest.x);
}

TEST(ServerValues, AnswersByEveryKindOfReference)
{
  ServerProcess server(Patience);
  const std::string address = server.GetCorbaloc().substr(server.GetCorbaloc().find('@') + 1);
  for (const std::string& reference : { server.GetCorbaloc(), server.GetIOR(),
         "corbaloc:iiop:1.1@" + address, "corbaloc::" + address })
  {
    const CORBA::Object_var object = GetClientORB()->string_to_object(reference.c_str());
    const LMS3D::DataExchange_var exchange = LMS3D::DataExchange::_narrow(object);
    ASSERT_FALSE(CORBA::is_nil(exchange)) << reference;
    const LMS3D::Data_var triples = exchange->fetch();
    EXPECT_EQ(triples->length(), 389880u) << reference;
  }
}
