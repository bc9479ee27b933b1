// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClientORB.h"

#include "Client/lms3dScannerReference.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace
{
// Milliseconds. A call waits no longer. A busy machine may need several calls.
constexpr CORBA::ULong MaximumWait = 10000;
constexpr int MaximumCalls = 6;

const char* Options[][2] = { { "clientCallTimeOutPeriod", "60000" },
  { "endPoint", "giop:tcp:127.0.0.1:" }, { nullptr, nullptr } };

// Enough connections for more waiting calls than a server permits. An environment variable, because
// vtkLMS3DRemoteSource may create the ORB first.
const int IsConnectionLimitSet = setenv("ORBmaxGIOPConnectionPerServer", "100", 0);

CORBA::ORB_ptr MakeORB()
{
  int count = 0;
  return CORBA::ORB_init(count, nullptr, "omniORB4", Options);
}
} // namespace

CORBA::ORB_ptr GetClientORB()
{
  static const CORBA::ORB_var orb = MakeORB();
  return orb;
}

LMS3D::LaserScanner_var Connect(const std::string& reference)
{
  return lms3dFindScanner(GetClientORB(), reference);
}

LMS3D::ScanHeader WaitFor(
  LMS3D::LaserScanner_ptr scanner, CORBA::ULongLong generation, CORBA::ULongLong after)
{
  CORBA::ULongLong newest = 0;
  for (int call = 0; call < MaximumCalls; ++call)
  {
    try
    {
      const LMS3D::ScanHeader_var header = scanner->waitForScan(after, generation, MaximumWait);
      return header.in();
    }
    catch (const LMS3D::NoScanYet& problem)
    {
      newest = problem.newest;
    }
  }
  ADD_FAILURE() << "no scan of generation " << generation << " after number " << after
                << "; the newest is " << newest;
  return {};
}

LMS3D::Pose At(double x, double y, double z)
{
  LMS3D::Pose pose;
  pose.position = { x, y, z };
  pose.orientation = { 0.0, 0.0, 0.0 };
  return pose;
}

LMS3D::Configuration GetCoarseGrid()
{
  LMS3D::Configuration configuration;
  configuration.alpha = { -60.0, 60.0, 13 };
  configuration.beta = { 0.0, 360.0, 36 };
  configuration.minimumRange = 0.0;
  configuration.maximumRange = 80.0;
  configuration.method = LMS3D::METHOD_EXACT;
  configuration.makeMap = true;
  configuration.mapError = 0.01;
  return configuration;
}
