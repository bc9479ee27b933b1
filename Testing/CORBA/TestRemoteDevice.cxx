// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// What a client makes of scans with other mountings, offsets and turn rates.
#include "Client/lms3dRemoteCheck.h"
#include "Client/lms3dRemoteData.h"
#include "ClientORB.h"
#include "DirectPipeline.h"
#include "NetworkLine.h"
#include "ServerProcess.h"
#include "WatchingSource.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <stdexcept>

namespace
{
constexpr LMS3D::ScannerMounting Mountings[] = { LMS3D::MOUNTING_YAWING, LMS3D::MOUNTING_YAWING_TOP,
  LMS3D::MOUNTING_PITCHING, LMS3D::MOUNTING_ROLLING };

// Half a unit in the last place of a float of up to 8 m.
constexpr double FloatRounding = 2.4e-7 * 2;

using Vector = std::array<double, 3>;

LMS3D::Configuration GetGrid()
{
  LMS3D::Configuration configuration = GetCoarseGrid();
  configuration.alpha = { -80.0, 80.0, 17 };
  configuration.beta = { -45.0, 45.0, 31 };
  configuration.makeMap = false;
  return configuration;
}

LMS3D::Device GetDevice(LMS3D::ScannerMounting mounting, const LMS3D::Vector3& offset, double rate)
{
  LMS3D::Device device = lms3dGetIdealDevice();
  device.mounting = mounting;
  device.axisOffset = offset;
  device.turnRate = rate;
  return device;
}

struct Beam
{
  Vector Start;
  Vector Direction;
};

// As LMS3DScanner.idl defines it, in the sensor frame. Degrees.
Beam GetBeam(const LMS3D::Device& device, double alpha, double beta)
{
  const double a = alpha * M_PI / 180.0;
  const double b = beta * M_PI / 180.0;
  const LMS3D::Vector3& o = device.axisOffset;
  const Vector aboutZ = { o.x * cos(b) + o.y * sin(b), o.y * cos(b) - o.x * sin(b), o.z };
  switch (device.mounting)
  {
    case LMS3D::MOUNTING_YAWING:
      return { aboutZ, { cos(a) * cos(b), -cos(a) * sin(b), sin(a) } };
    case LMS3D::MOUNTING_YAWING_TOP:
      return { aboutZ, { sin(a) * cos(b), -sin(a) * sin(b), cos(a) } };
    case LMS3D::MOUNTING_PITCHING:
      return { { o.x * cos(b) - o.z * sin(b), o.y, o.z * cos(b) + o.x * sin(b) },
        { cos(a) * cos(b), sin(a), cos(a) * sin(b) } };
    default:
      return { { o.x, o.y * cos(b) + o.z * sin(b), o.z * cos(b) - o.y * sin(b) },
        { cos(a), sin(a) * cos(b), -sin(a) * sin(b) } };
  }
}

lms3dRemoteScan FetchScan(LMS3D::LaserScanner_ptr scanner, const LMS3D::Device& device)
{
  return lms3dFetchScan(scanner, WaitFor(scanner, scanner->setDevice(device)));
}

double GetNumber(vtkPolyData* scan, const char* name, int component = 0)
{
  vtkDataArray* array = scan->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(component / array->GetNumberOfComponents(),
                   component % array->GetNumberOfComponents())
               : NAN;
}
} // namespace

// The sensor has no rotation, so the sensor frame is parallel to the world's.
TEST(RemoteDevice, PointsLieWhereTheInterfaceSays)
{
  ServerProcess server({ "--keep", "100" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::Configuration grid = GetGrid();
  scanner->setConfiguration(grid);
  for (const LMS3D::ScannerMounting mounting : Mountings)
  {
    const LMS3D::Device device = GetDevice(mounting, { 0.1, -0.05, 0.2 }, 20.0);
    const lms3dRemoteScan remote = FetchScan(scanner, device);
    vtkNew<vtkPolyData> scan;
    lms3dFillScan(remote, scan);
    ASSERT_GT(scan->GetNumberOfPoints(), 100);
    ASSERT_EQ(scan->GetNumberOfPoints(), remote.Header.returns);
    const LMS3D::Vector3& position = remote.Header.sensorPose.position;
    vtkDataArray* ids = scan->GetPointData()->GetArray("BeamId");
    for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
    {
      const int id = static_cast<int>(ids->GetTuple1(i));
      const int turn = id / 17;
      const double alpha = grid.alpha.start + 10.0 * (id % 17);
      const double time = (alpha - grid.alpha.start) / (360.0 * 75.0);
      const double beta = grid.beta.start + 3.0 * turn + device.turnRate * time;
      const Beam beam = GetBeam(device, alpha, beta);
      const Vector sensor = { position.x, position.y, position.z };
      for (int axis = 0; axis < 3; ++axis)
      {
        ASSERT_NEAR(scan->GetPoint(i)[axis],
          sensor[axis] + beam.Start[axis] + remote.Ranges[id] * beam.Direction[axis], 1e-12)
          << "mounting " << mounting << ", beam " << id << ", axis " << axis;
      }
    }
  }
}

TEST(RemoteDevice, PointsAreThoseOfTheFilter)
{
  ServerProcess server({ "--keep", "100" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  scanner->setConfiguration(GetGrid());
  LMS3D::Pose pose = At(0.4, -0.3, 0.9);
  pose.orientation = { 10.0, -20.0, 30.0 };
  scanner->setPose(pose);
  for (int i = 0; i < 8; ++i)
  {
    const LMS3D::Device device = i < 4 ? GetDevice(Mountings[i], { 0.0, 0.0, 0.0 }, 0.0)
                                       : GetDevice(Mountings[i - 4], { 0.1, -0.05, 0.2 }, 20.0);
    const lms3dRemoteScan remote = FetchScan(scanner, device);
    const DirectPipeline direct("room.wrl", pose, remote.Header.settings, device);
    EXPECT_EQ(remote.Ranges, direct.Ranges);
    vtkNew<vtkPolyData> scan;
    lms3dFillScan(remote, scan);
    ASSERT_EQ(3 * std::size_t(scan->GetNumberOfPoints()), direct.ReturnPoints.size());
    for (vtkIdType point = 0; point < scan->GetNumberOfPoints(); ++point)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        ASSERT_NEAR(
          scan->GetPoint(point)[axis], direct.ReturnPoints[3 * point + axis], FloatRounding);
      }
    }
  }
}

TEST(RemoteDevice, TheSourceReportsThePlatformAndTheStatuses)
{
  ServerProcess server({ "--mounting", "pitching", "--axis-offset", "0.1", "0.2", "-0.3",
    "--turn-rate", "-20", "--status", "--no-map" });
  WatchingSource source(server.GetCorbaloc());
  source->SetTimeout(60.0);
  source->Update();
  vtkPolyData* scan = source.GetScan();
  EXPECT_EQ(GetNumber(scan, "Mounting"), 2.0);
  EXPECT_EQ(GetNumber(scan, "AxisOffset", 0), 0.1);
  EXPECT_EQ(GetNumber(scan, "AxisOffset", 1), 0.2);
  EXPECT_EQ(GetNumber(scan, "AxisOffset", 2), -0.3);
  EXPECT_EQ(GetNumber(scan, "TurnRate"), -20.0);
  vtkDataArray* statuses = scan->GetFieldData()->GetArray("Status");
  ASSERT_NE(statuses, nullptr);
  EXPECT_EQ(statuses->GetDataType(), VTK_UNSIGNED_CHAR);
  EXPECT_EQ(statuses->GetNumberOfTuples(), 361 * 360);
}

TEST(RemoteDevice, TheDefaultsAreNotReported)
{
  ServerProcess server;
  WatchingSource source(server.GetCorbaloc());
  source->SetTimeout(60.0);
  source->Update();
  for (const char* name : { "Mounting", "AxisOffset", "TurnRate", "Status" })
  {
    EXPECT_EQ(source.GetScan()->GetFieldData()->GetArray(name), nullptr) << name;
  }
}

// An older server answers with BAD_OPERATION, as this one does if the operation has another name.
TEST(RemoteDevice, OlderServersHaveAnIdealDevice)
{
  ServerProcess server;
  NetworkLine line(server.GetCorbaloc());
  line.Replace("getScanDevice", "getNoSuchName");
  WatchingSource source(line.GetCorbaloc());
  source->SetTimeout(60.0);
  source->Update();
  EXPECT_EQ(source.GetScan()->GetNumberOfPoints(), 129960);
  EXPECT_EQ(source->GetProblem(), "");
  const std::uint64_t first = source.GetNumber("ScanNumber");
  EXPECT_TRUE(source.UpdateUntil([&] { return source.GetNumber("ScanNumber") > first; }));
  EXPECT_EQ(source.TakeWarnings(), "");
}

TEST(RemoteDevice, DevicesThatLie)
{
  lms3dRemoteScan scan;
  scan.Header = {};
  EXPECT_NO_THROW(lms3dCheckDevice(scan));
  for (const double bad : { double(NAN), 1e300, -double(INFINITY) })
  {
    scan.Device = GetDevice(LMS3D::MOUNTING_YAWING, { 0.0, bad, 0.0 }, 0.0);
    EXPECT_THROW(lms3dCheckDevice(scan), std::runtime_error) << bad;
    scan.Device = GetDevice(LMS3D::MOUNTING_YAWING, { 0.0, 0.0, 0.0 }, bad);
    EXPECT_THROW(lms3dCheckDevice(scan), std::runtime_error) << bad;
  }
}
