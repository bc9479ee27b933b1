// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
// What a client refuses of a server's map of many scans.
#include "Client/lms3dRemoteFusedMap.h"
#include "Client/lms3dRemoteFusedMapCheck.h"
#include "Common/lms3dChecksum.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

namespace
{
constexpr CORBA::ULongLong Since = 5;

lms3dFusedMapChanges MakeChanges()
{
  lms3dFusedMapChanges changes;
  changes.Regions = { { 2, 3, 1 }, { 4, 0, 0 }, { 7, 4, 2 } };
  changes.Points = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2, 1, 0, 2, 0, 1, 2, 1, 1, 2 };
  changes.Triangles = { 0, 1, 2, 0, 1, 3, 0, 3, 2 };
  changes.Header.number = 8;
  changes.Header.since = Since;
  changes.Header.firstNumber = 1;
  changes.Header.regions = 3;
  changes.Header.points = 7;
  changes.Header.triangles = 3;
  changes.Header.allTriangles = 3;
  return changes;
}

template <typename Element>
void Continue(const std::vector<Element>& elements, CORBA::ULong& checksum)
{
  checksum = lms3dContinueChecksum(checksum, elements.data(), elements.size() * sizeof(Element));
}

/// A malicious server adapts its checksum.
void Check(lms3dFusedMapChanges changes)
{
  changes.Header.checksum = 0;
  Continue(changes.Regions, changes.Header.checksum);
  Continue(changes.Points, changes.Header.checksum);
  Continue(changes.Triangles, changes.Header.checksum);
  lms3dCheckFusedMapHeader(changes.Header, Since);
  lms3dCheckFusedMapChanges(changes);
}

using Changes = std::vector<std::function<void(lms3dFusedMapChanges&)>>;
} // namespace

TEST(RemoteFusedMap, GoodChangesPass)
{
  EXPECT_NO_THROW(Check(MakeChanges()));
}

// The clock of the server was set back before it was started anew.
TEST(RemoteFusedMap, AWholeMapMayHaveALowerNumber)
{
  lms3dFusedMapChanges changes = MakeChanges();
  changes.Header.number = Since - 1;
  changes.Header.isWhole = true;
  EXPECT_NO_THROW(Check(changes));
}

TEST(RemoteFusedMap, AWrongChecksumIsNoticed)
{
  EXPECT_THROW(lms3dCheckFusedMapChanges(MakeChanges()), std::runtime_error);
}

TEST(RemoteFusedMap, ChangesThatLie)
{
  const Changes lies = {
    [](auto& c) { c.Header.since = Since + 1; },
    [](auto& c) { c.Header.number = Since - 1; },
    [](auto& c) { c.Header.firstNumber = 9; },
    [](auto& c) { c.Header.regions = 2; },
    [](auto& c) { c.Header.points = 16000001; },
    [](auto& c) { c.Header.triangles = ~CORBA::ULong(0); },
    [](auto& c) { c.Header.allTriangles = ~CORBA::ULong(0); },
    [](auto& c) { c.Header.origin.y = std::numeric_limits<double>::quiet_NaN(); },
    [](auto& c) { c.Points[4] = std::numeric_limits<float>::infinity(); },
    [](auto& c) { c.Points.pop_back(); },
    [](auto& c) { c.Triangles[2] = 3; },
    [](auto& c) { c.Triangles[8] = 4; },
    [](auto& c) { c.Regions[0].points = 2; },
    [](auto& c) { c.Regions[1].triangles = ~CORBA::ULong(0); },
    [](auto& c) { c.Regions[1].id = 2; },
    [](auto& c) { c.Regions[2].id = 3; },
  };
  for (std::size_t i = 0; i < lies.size(); ++i)
  {
    lms3dFusedMapChanges changes = MakeChanges();
    lies[i](changes);
    EXPECT_THROW(Check(changes), std::runtime_error) << i;
  }
}

TEST(RemoteFusedMap, RegionsMayNotAddUpToTooManyPoints)
{
  constexpr CORBA::ULong Points = 9000000;
  lms3dFusedMapChanges changes;
  changes.Regions = { { 1, Points, 1 } };
  changes.Points.resize(std::size_t(3) * Points);
  changes.Triangles = { 0, 1, 2 };
  changes.Header.number = 1;
  changes.Header.allTriangles = 1;
  lms3dRemoteFusedMap map;
  map.Apply(changes);
  changes.Header.number = 2;
  EXPECT_NO_THROW(map.Apply(changes)) << "the region is replaced";
  changes.Regions[0].id = 2;
  changes.Header.allTriangles = 2;
  EXPECT_THROW(map.Apply(changes), std::runtime_error);
  EXPECT_EQ(map.GetHeader().number, 0U);
  changes.Header.allTriangles = 1;
  EXPECT_NO_THROW(map.Apply(changes)) << "the map began anew";
}
