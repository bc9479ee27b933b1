// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Compares the beams that pass through blocks of a plane with a look at all beams of a scan.
 */
#include "Fusion/FusionFixtures.h"
#include "Fusion/Passages/lms3dPassages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <random>
#include <vector>

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
  const lms3dVector point = lms3dAdd(sensor, lms3dScale(normal, distance * any(random)));
  const lms3dVector middle = lms3dAdd(point, { 3.0 * any(random), 3.0 * any(random), 0.0 });
  lms3dFusedPlane plane(lms3dPlaneFrame(point, normal, Bound / 3.0, middle));
  const lms3dPoint2 foot = plane.Frame.ToCells(sensor);
  for (int i = 0; i < 12; ++i)
  {
    plane.Raster.Make(lms3dRaster::GetBlockOf(lms3dGetCellOf(foot[0] + 300.0 * any(random))),
      lms3dRaster::GetBlockOf(lms3dGetCellOf(foot[1] + 300.0 * any(random))));
  }
  return plane;
}

struct PassageCounts
{
  /// Passages through blocks.
  int Through = 0;
  /// Passages of beams in `isFree`.
  int Free = 0;
  /// Passages that a search did not need.
  int Beside = 0;
};

void Compare(const lms3dSeenRanges& ranges, const std::vector<bool>& isFree, unsigned seed,
  lms3dPassages& passages, PassageCounts& counts)
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
      ++counts.Through;
      counts.Free += isFree[beam] ? 1 : 0;
    }
    counts.Beside += passage.IsPassed && place == found.end() ? 1 : 0;
  }
}

/// Compares searches in many planes with a look at all beams.
PassageCounts Compare(const lms3dSeenRanges& ranges, const std::vector<bool>& isFree)
{
  lms3dPassages passages(Bound);
  PassageCounts counts;
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    Compare(ranges, isFree, seed, passages, counts);
  }
  return counts;
}

lms3dSeenRanges MakeRanges(vtkPolyData* scan, const std::vector<bool>& isFree)
{
  const lms3dScanInput input(scan);
  return { input, std::make_shared<lms3dBeamTable>(input.GetGeometry()), isFree };
}
} // namespace

TEST(LMS3DPassages, AreThoseOfAllBeamsThroughBlocks)
{
  const MappedScan scan = MakeMappedScan(ReadRoom(), { 0.3, -0.2, 1.0 });
  const std::vector<bool> isFree(91 * 90);
  const PassageCounts counts = Compare(MakeRanges(scan.Scan, isFree), isFree);
  EXPECT_GT(counts.Through, 1000);
  EXPECT_GT(counts.Beside, 1000);
}

/// A floor under the open sky. Two of three beams without a return are known to be free.
TEST(LMS3DPassages, AreThoseOfFreeBeams)
{
  const MappedScan scan = MakeMappedScan(MakeFloor(2.0, 0.0), { 0.3, -0.2, 1.0 });
  std::vector<bool> isFree(91 * 90, true);
  std::vector<bool> hasReturn(isFree.size());
  double farthest = 0.0;
  const lms3dScanInput input(scan.Scan);
  for (vtkIdType i = 0; i < input.GetNumberOfReturns(); ++i)
  {
    isFree[input.GetBeamIds()[i]] = false;
    hasReturn[input.GetBeamIds()[i]] = true;
    farthest = std::max(farthest, input.GetRanges()[i]);
  }
  for (std::size_t i = 0; i < isFree.size(); i += 3)
  {
    isFree[i] = false;
  }
  const lms3dSeenRanges ranges = MakeRanges(scan.Scan, isFree);
  for (std::size_t i = 0; i < isFree.size(); ++i)
  {
    const double range = ranges.GetRange(static_cast<int>(i));
    if (!hasReturn[i])
    {
      ASSERT_NEAR(range, isFree[i] ? farthest : 0.0, 1e-6 * farthest);
    }
  }
  EXPECT_GT(ranges.GetBox().High[2], 0.9 * farthest);
  EXPECT_GT(Compare(ranges, isFree).Free, 1000);
}
