// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Compares the beams that pass through blocks of a plane with a look at all beams of a scan.
 */
#include "Fusion/FusionFixtures.h"
#include "Fusion/lms3dPassages.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <memory>
#include <random>

namespace
{
constexpr double Bound = 0.01;

bool HasBlock(const lms3dFusedPlane& plane, const lms3dPoint2& place)
{
  return plane.Raster.Find(lms3dRaster::GetBlockOf(lms3dGetCellOf(place[0])),
           lms3dRaster::GetBlockOf(lms3dGetCellOf(place[1]))) >= 0;
}

/// A plane anywhere in the room, some of them near the sensor or grazed by its beams, with a few
/// blocks.
lms3dFusedPlane MakePlane(const lms3dVector& sensor, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const lms3dVector normal = lms3dNormalize({ any(random), any(random), any(random) });
  const double distance = seed % 3 == 0 ? 1e-4 : 0.7;
  lms3dFusedPlane plane(lms3dPlaneFrame(
    lms3dAdd(sensor, lms3dScale(normal, distance * any(random))), normal, Bound / 3.0));
  const lms3dPoint2 foot = plane.Frame.ToCells(sensor);
  for (int i = 0; i < 12; ++i)
  {
    plane.Raster.Make(lms3dRaster::GetBlockOf(lms3dGetCellOf(foot[0] + 300.0 * any(random))),
      lms3dRaster::GetBlockOf(lms3dGetCellOf(foot[1] + 300.0 * any(random))));
  }
  return plane;
}
} // namespace

TEST(LMS3DPassages, AreThoseOfAllBeamsThroughBlocks)
{
  const MappedScan scan = MakeMappedScan(ReadRoom(), { 0.3, -0.2, 1.0 });
  const lms3dScanInput input(scan.Scan);
  const lms3dSeenRanges ranges(input, std::make_shared<lms3dBeamTable>(input.GetGeometry()));
  lms3dPassages passages(Bound);
  int through = 0;
  int beside = 0;
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    const lms3dFusedPlane plane = MakePlane(ranges.GetPosition(), seed);
    const lms3dBlockGroups groups(plane.Raster, 0);
    passages.Find(ranges, plane, groups);
    std::map<int, lms3dPoint2> found;
    for (std::size_t i = 0; i < passages.GetSize(); ++i)
    {
      found[passages.GetBeam(i)] = passages.GetPlace(i);
    }
    EXPECT_EQ(found.size(), passages.GetSize());
    for (int beam = 0; beam < ranges.GetTable().GetSize(); ++beam)
    {
      const lms3dPassage passage = passages.Get(beam);
      const auto place = found.find(beam);
      ASSERT_TRUE(place == found.end() || (passage.IsPassed && place->second == passage.Place));
      if (passage.IsPassed && HasBlock(plane, passage.Place))
      {
        EXPECT_NE(place, found.end()) << seed << " " << beam;
        ++through;
      }
      beside += passage.IsPassed && place == found.end() ? 1 : 0;
    }
  }
  EXPECT_GT(through, 1000);
  EXPECT_GT(beside, 1000);
}
