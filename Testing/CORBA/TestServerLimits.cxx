// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Client/lms3dRemoteScan.h"
#include "ClientORB.h"
#include "DirectPipeline.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <csignal>

namespace
{
// 62,500 beams more than fit into 2 MiB as ranges alone.
LMS3D::Configuration GetLargeGrid()
{
  LMS3D::Configuration configuration = GetCoarseGrid();
  configuration.alpha = { -90.0, 90.0, 750 };
  configuration.beta = { 0.0, 360.0, 782 };
  configuration.makeMap = false;
  return configuration;
}
} // namespace

TEST(ServerLimits, AScanOverTheMessageLimitComesInParts)
{
  ServerProcess server({ "--keep", "50" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::ScanHeader header = WaitFor(scanner, scanner->setConfiguration(GetLargeGrid()));
  ASSERT_EQ(header.beams, 586500u);
  EXPECT_THROW(scanner->fetch(), CORBA::IMP_LIMIT);
  EXPECT_THROW(scanner->getScan(), LMS3D::LimitExceeded);

  scanner->setPose(At(0.3, -0.2, 1.0));
  const lms3dRemoteScan remote = lms3dFetchScan(scanner, WaitFor(scanner));
  const DirectPipeline direct("room.wrl", remote.Header.sensorPose, remote.Header.settings);
  EXPECT_EQ(remote.Ranges, direct.Ranges);
}

// The largest part that the server names fits into a message.
TEST(ServerLimits, AMapOverTheMessageLimitComesInParts)
{
  ServerProcess server({ "--map-error", "0", "--rate", "2", "--keep", "50" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::ScanHeader header = WaitFor(scanner);
  ASSERT_GT(header.mapPoints * 24u, 2097152u);
  ASSERT_GT(header.mapTriangles * 12u, 2097152u);
  CORBA::ULong most = 0;
  try
  {
    scanner->getMapPoints(header.number, 0, header.mapPoints);
    ADD_FAILURE() << "more than a message was sent";
  }
  catch (const LMS3D::LimitExceeded& problem)
  {
    most = static_cast<CORBA::ULong>(problem.limit);
  }
  const LMS3D::Coordinates_var part = scanner->getMapPoints(header.number, 0, most);
  EXPECT_EQ(part->length(), 3 * most);
  EXPECT_THROW(
    scanner->getMapTriangles(header.number, 0, header.mapTriangles), LMS3D::LimitExceeded);

  const lms3dRemoteScan remote = lms3dFetchScan(scanner, WaitFor(scanner));
  const DirectPipeline direct("room.wrl", remote.Header.sensorPose, remote.Header.settings);
  EXPECT_EQ(remote.MapPoints, direct.MapPoints);
  EXPECT_EQ(remote.MapTriangles, direct.MapTriangles);
}

TEST(ServerLimits, PartsBeyondTheEndAreRefused)
{
  ServerProcess server({ "--rate", "1", "--keep", "50" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const LMS3D::ScanHeader header = WaitFor(scanner);
  const CORBA::ULongLong number = header.number;
  EXPECT_THROW(scanner->getRanges(number, header.beams, 1), LMS3D::InvalidArgument);
  EXPECT_THROW(scanner->getRanges(number, 4294967295u, 4294967295u), LMS3D::InvalidArgument);
  EXPECT_THROW(scanner->getMapPoints(number, 1, header.mapPoints), LMS3D::InvalidArgument);
  EXPECT_THROW(
    scanner->getMapTriangles(number, header.mapTriangles + 1, 0), LMS3D::InvalidArgument);
}

TEST(ServerLimits, TheAdministratorsMessageLimitHolds)
{
  ServerProcess server({ "-ORBgiopMaxMsgSize", "100000", "--keep", "50" });
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  EXPECT_THROW(scanner->fetch(), CORBA::IMP_LIMIT);
  const lms3dRemoteScan remote = lms3dFetchScan(scanner, WaitFor(scanner));
  EXPECT_EQ(remote.Ranges.size(), 129960u);
}
