// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Client/lms3dRemoteCheck.h"
#include "ClientORB.h"
#include "Common/lms3dChecksum.h"
#include "ServerProcess.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

lms3dRemoteScan FetchReal()
{
  ServerProcess server;
  const LMS3D::LaserScanner_var scanner = Connect(server.GetCorbaloc());
  const CORBA::ULongLong generation = scanner->setConfiguration(GetCoarseGrid());
  return lms3dFetchScan(scanner, WaitFor(scanner, generation));
}

void Check(lms3dRemoteScan& scan)
{
  lms3dCheckHeader(scan.Header);
  lms3dCheckArrays(scan);
}

/// A malicious server adapts its checksums.
void CheckWithNewChecksums(lms3dRemoteScan& scan)
{
  scan.Header.rangesChecksum = lms3dGetRangesChecksum(scan.Ranges);
  scan.Header.mapChecksum = lms3dGetMapChecksum(scan.MapPoints, scan.MapTriangles);
  Check(scan);
}

using Change = std::function<void(lms3dRemoteScan&)>;
} // namespace

TEST(RemoteCheck, RealScansAreGood)
{
  lms3dRemoteScan scan = FetchReal();
  EXPECT_NO_THROW(Check(scan));
}

TEST(RemoteCheck, ABitThatChangedIsNoticed)
{
  const lms3dRemoteScan real = FetchReal();
  for (const Change& change : { Change([](auto& s) { s.Ranges[7] += 1e-6f; }),
         Change([](auto& s) { s.MapPoints[7] += 1e-15; }),
         Change([](auto& s) { std::swap(s.MapTriangles[0], s.MapTriangles[1]); }) })
  {
    lms3dRemoteScan scan = real;
    change(scan);
    EXPECT_THROW(Check(scan), std::runtime_error);
  }
}

TEST(RemoteCheck, HeadersThatLie)
{
  const lms3dRemoteScan real = FetchReal();
  const std::vector<Change> changes = {
    [](auto& s) { s.Header.beams += 1; },
    [](auto& s) { s.Header.settings.alpha.count = 0; },
    [](auto& s) { s.Header.settings.beta.count = 4294967295u; },
    // 2^32 + 468 beams.
    [](auto& s) { s.Header.settings.alpha.count = 330382138; },
    [](auto& s)
    {
      s.Header.settings.alpha.count = 65536;
      s.Header.settings.beta.count = 65536;
      s.Header.beams = 0;
    },
    [](auto& s) { s.Header.settings.alpha.start = NaN; },
    [](auto& s) { s.Header.settings.alpha.stop = Infinity; },
    [](auto& s) { s.Header.settings.beta.stop = s.Header.settings.beta.start; },
    [](auto& s) { s.Header.returns = s.Header.beams + 1; },
    [](auto& s) { s.Header.sensorPose.position.y = NaN; },
    [](auto& s) { s.Header.sensorPose.orientation.z = Infinity; },
    [](auto& s) { s.Header.mapPoints = 4294967295u; },
    [](auto& s) { s.Header.mapTriangles = 4294967295u; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    lms3dRemoteScan scan = real;
    changes[i](scan);
    EXPECT_THROW(lms3dCheckHeader(scan.Header), std::runtime_error) << "change " << i;
  }
}

TEST(RemoteCheck, ArraysThatLie)
{
  const lms3dRemoteScan real = FetchReal();
  const std::vector<Change> changes = {
    [](auto& s) { s.Ranges[3] = -1.0f; },
    [](auto& s) { s.Ranges[3] = static_cast<float>(NaN); },
    [](auto& s) { s.Ranges[3] = static_cast<float>(Infinity); },
    [](auto& s) { s.Ranges[3] = 0.0f; },
    [](auto& s) { s.MapPoints[4] = NaN; },
    [](auto& s) { s.MapTriangles[5] = s.Header.mapPoints; },
    [](auto& s) { s.MapTriangles[5] = 4294967295u; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    lms3dRemoteScan scan = real;
    changes[i](scan);
    EXPECT_THROW(CheckWithNewChecksums(scan), std::runtime_error) << "change " << i;
  }
}
