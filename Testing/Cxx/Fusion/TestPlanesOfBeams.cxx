// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks the planes of the beams of a scan against a search beam by beam.
 */
#include "Fusion/FusionFixtures.h"
#include "Fusion/Passages/lms3dPlanesOfBeams.h"
#include "Fusion/Scans/lms3dPatchFit.h"
#include "Fusion/Scans/lms3dSeenRanges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace
{
constexpr double MaximumError = 0.01;

/// The plane of each patch, -1 for a patch without a plane.
std::vector<int> MakePlanes(const lms3dLocalMap& local, lms3dFusedPlanes& planes)
{
  std::vector<int> planeOfPatch;
  for (const std::vector<int>& returns : lms3dGetReturnsOfPatches(local))
  {
    const std::optional<lms3dFittedPlane> fit = lms3dFitPlane(local, returns, MaximumError);
    planeOfPatch.push_back(fit ? planes.MakePlane(fit->Centre, fit->Normal) : -1);
  }
  return planeOfPatch;
}

/// A coarse scan of the room, its local map, and a plane for each patch.
struct Room
{
  explicit Room(const MappedScan& mapped)
    : Scan(mapped.Scan)
    , Table(std::make_shared<lms3dBeamTable>(Scan.GetGeometry()))
    , Ranges(Scan, Table, std::vector<bool>(static_cast<std::size_t>(Table->GetSize())))
    , Local(mapped.Map, Scan, Ranges, MaximumError)
    , Planes(MaximumError)
    , PlaneOfPatch(MakePlanes(Local, Planes))
    , Beams(Local, Table->GetSize(), PlaneOfPatch, Planes)
  {
  }

  const lms3dScanInput Scan;
  const std::shared_ptr<const lms3dBeamTable> Table;
  const lms3dSeenRanges Ranges;
  const lms3dLocalMap Local;
  lms3dFusedPlanes Planes;
  const std::vector<int> PlaneOfPatch;
  const lms3dPlanesOfBeams Beams;
};
} // namespace

TEST(LMS3DPlanesOfBeams, AreThoseOfTheirReturns)
{
  const Room room(ScanRoom().front());
  std::set<int> beams;
  int withPlane = 0;
  for (std::size_t i = 0; i < room.Local.Returns.size(); ++i)
  {
    const lms3dMappedReturn& mapped = room.Local.Returns[i];
    const int patch = room.Local.PatchIds[mapped.Triangle];
    int plane = patch < 0 ? -1 : room.PlaneOfPatch[patch];
    if (plane >= 0 && std::abs(room.Planes[plane].Frame.GetHeight(mapped.Point)) > MaximumError)
    {
      plane = -1;
    }
    EXPECT_EQ(room.Beams.GetPlane(mapped.BeamId), plane);
    EXPECT_EQ(room.Beams.GetReturn(mapped.BeamId), static_cast<int>(i));
    beams.insert(mapped.BeamId);
    withPlane += plane >= 0 ? 1 : 0;
  }
  EXPECT_GT(withPlane, 0);
  for (int beam = 0; beam < room.Table->GetSize(); ++beam)
  {
    EXPECT_TRUE(beams.count(beam) > 0 || room.Beams.GetReturn(beam) == -1);
  }
}

TEST(LMS3DPlanesOfBeams, AreMixedWhereFourBeamsOfFourTurnsHaveSeveral)
{
  const Room room(ScanRoom().front());
  const int fan = room.Table->GetBeamsOfFan();
  std::size_t mixed = 0;
  std::size_t places = 0;
  for (int first = 0; first + 3 * fan < room.Table->GetSize(); first += fan)
  {
    std::vector<int> expected;
    for (int beam = 0; beam + 3 < fan; ++beam)
    {
      std::set<int> planes;
      for (int i = 0; i < 16; ++i)
      {
        planes.insert(room.Beams.GetPlane(first + i / 4 * fan + beam + i % 4));
      }
      if (planes.size() > 1)
      {
        expected.push_back(beam);
      }
    }
    const std::vector<int> found =
      room.Beams.FindMixed({ first, first + fan, first + 2 * fan, first + 3 * fan }, fan);
    EXPECT_EQ(found, expected) << first;
    mixed += found.size();
    places += static_cast<std::size_t>(fan) - 3;
  }
  EXPECT_GT(mixed, 0U);
  EXPECT_LT(mixed, places);
}
