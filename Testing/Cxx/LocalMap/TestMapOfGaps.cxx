// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which gaps between returns the map closes, and what it says about them.
 */
#include "LocalMap/GapFixtures.h"

#include <vtkFieldData.h>
#include <vtkMath.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>

namespace
{
constexpr int Middle = WallScan::Middle;

// Whether the map of a scan with lost beams has surface at one of them.
bool IsClosed(vtkPolyData* scan, const GapBeam& beam, int maximumGapSize)
{
  return CountHits(MakeMap(scan, GapProperties{ maximumGapSize }), beam) > 0;
}

std::vector<int> GetBeamIds(const std::vector<GapBeam>& beams)
{
  std::vector<int> ids(beams.size());
  std::transform(beams.begin(), beams.end(), ids.begin(), WallScan::GetBeamId);
  std::sort(ids.begin(), ids.end());
  return ids;
}
} // namespace

TEST(MapOfGaps, ClosesALostBeamOfAWall)
{
  const GapBeam lost = { Middle + 4, Middle - 7 };
  const vtkIdType whole = MakeMap(WallScan().Make(), GapProperties())->GetNumberOfCells();
  vtkSmartPointer<vtkPolyData> scan = WallScan().Lose({ lost }).Make();

  vtkSmartPointer<vtkPolyData> open = MakeMap(scan, GapProperties());
  EXPECT_EQ(CountHits(open, lost), 0);
  EXPECT_FALSE(open->GetFieldData()->HasArray("NumberOfClosedGaps"));

  vtkSmartPointer<vtkPolyData> closed = MakeMap(scan, GapProperties{ 1 });
  EXPECT_EQ(CountHits(closed, lost), 1);
  EXPECT_EQ(closed->GetNumberOfCells(), whole);
  EXPECT_EQ(GetField(closed, "NumberOfClosedGaps"), 1.0);
  EXPECT_EQ(GetFieldValues(closed, "ClosedBeamIds"), GetBeamIds({ lost }));
  EXPECT_EQ(GetField(closed, "NumberOfReturnsOnPatches"), scan->GetNumberOfPoints());
  // The beam has a square degree, less at its elevation, and meets the wall at an angle.
  const double range = WallScan().GetRange(lost);
  const double degree = vtkMath::RadiansFromDegrees(1.0);
  const double expected = degree * degree * std::cos(7.0 * degree) * std::pow(range, 3.0) / 3.0;
  EXPECT_NEAR(GetField(closed, "ClosedGapArea"), expected, 1e-6 * expected);
}

TEST(MapOfGaps, ClosesGroupsUpToTheMaximumSize)
{
  const std::vector<GapBeam> lost = GetSquare({ Middle, Middle }, 3);
  vtkSmartPointer<vtkPolyData> scan = WallScan().Lose(lost).Make();
  EXPECT_FALSE(IsClosed(scan, lost[4], 8));
  EXPECT_TRUE(IsClosed(scan, lost[4], 9));
  EXPECT_EQ(GetFieldValues(MakeMap(scan, GapProperties{ 9 }), "ClosedBeamIds"), GetBeamIds(lost));
}

TEST(MapOfGaps, StayOpenAtTheEdgeOfTheScan)
{
  for (const GapBeam& lost :
    { GapBeam{ 0, Middle }, GapBeam{ WallScan::Size - 1, Middle }, GapBeam{ Middle, 0 } })
  {
    EXPECT_FALSE(IsClosed(WallScan().Lose({ lost }).Make(), lost, 25));
  }
}

TEST(MapOfGaps, StayOpenWhereABeamMetNothing)
{
  const std::vector<GapBeam> lost = GetSquare({ Middle, Middle }, 3);
  vtkSmartPointer<vtkPolyData> scan = WallScan().Lose(lost).Make();
  // Even if a device knows it from one beam only.
  const int corner = WallScan::GetBeamId(lost.back());
  const std::map<int, bool> closes = { { vtkLMS3DScanFilter::NOTHING_MET, false },
    { vtkLMS3DScanFilter::BEYOND_RANGE, false }, { vtkLMS3DScanFilter::TOO_WEAK, true },
    { vtkLMS3DScanFilter::TOO_NEAR, true } };
  for (const auto& [status, isClosed] : closes)
  {
    AddStatus(scan, { corner }, status);
    for (int maximumGapSize : { -1, 25 })
    {
      EXPECT_EQ(IsClosed(scan, lost.front(), maximumGapSize), isClosed) << "status " << status;
    }
  }
}

TEST(MapOfGaps, AreOpenByDefaultWithoutStatus)
{
  vtkSmartPointer<vtkPolyData> scan = WallScan().Lose({ { Middle, Middle } }).Make();
  const std::uint64_t open = HashMap(MakeMap(scan, GapProperties{ 0 }));
  EXPECT_EQ(HashMap(MakeMap(scan, GapProperties{ -1 })), open);
  EXPECT_EQ(HashMap(MakeMap(scan, 0.01)), open);
  // With Status, 25 beams are the most.
  AddStatus(scan, {}, 0);
  EXPECT_NE(HashMap(MakeMap(scan, 0.01)), open);
  const GapBeam first = { 5, 5 };
  for (int size : { 5, 6 })
  {
    vtkSmartPointer<vtkPolyData> square = WallScan().Lose(GetSquare(first, size)).Make();
    AddStatus(square, {}, 0);
    EXPECT_EQ(IsClosed(square, first, -1), size == 5);
  }
}

TEST(MapOfGaps, StayOpenBetweenPatches)
{
  // Two walls meet at a right angle ahead of the middle turn.
  WallScan scan;
  const std::vector<GapBeam> square = GetSquare({ 0, 0 }, WallScan::Size);
  for (const GapBeam& beam : square)
  {
    const double degrees = beam.Turn - Middle;
    const double beta = vtkMath::RadiansFromDegrees(degrees);
    const double toWall = std::cos(beta) / (std::cos(beta) + std::abs(std::sin(beta)));
    scan.Set(beam, scan.GetRange(beam) * toWall);
  }
  const GapBeam lost = { Middle, Middle };
  scan.Lose({ lost });
  EXPECT_FALSE(IsClosed(scan.Make(), lost, 25));
}

TEST(MapOfGaps, StayOpenAtADepthStep)
{
  // A plate one metre before the wall, and a window through which something is seen one metre
  // behind it.
  for (double step : { -1.0, 1.0 })
  {
    WallScan scan;
    for (const GapBeam& beam : GetSquare({ Middle, Middle }, 6))
    {
      scan.Set(beam, scan.GetRange(beam) * (1.0 + step / WallScan::Distance));
    }
    const std::vector<GapBeam> lost = { { Middle, Middle + 2 }, { Middle + 5, Middle + 5 } };
    scan.Lose(lost);
    for (const GapBeam& beam : lost)
    {
      EXPECT_FALSE(IsClosed(scan.Make(), beam, 25)) << step;
    }
  }
}

TEST(MapOfGaps, StayOpenInThePlainGrid)
{
  // Ranges without any surface.
  Random random(3);
  WallScan scan;
  for (const GapBeam& beam : GetSquare({ 0, 0 }, WallScan::Size))
  {
    scan.Set(beam, random.Get() < 0.1 ? 0.0 : random.Get(1.0, 1.06));
  }
  vtkSmartPointer<vtkPolyData> open = MakeMap(scan.Make(), GapProperties{ 0 });
  vtkSmartPointer<vtkPolyData> closed = MakeMap(scan.Make(), GapProperties{ 25 });
  ASSERT_GT(GetField(open, "NumberOfReturnsOnGrid"), 0.0);
  EXPECT_EQ(GetField(closed, "NumberOfClosedGaps"), 0.0);
  EXPECT_EQ(closed->GetNumberOfCells(), open->GetNumberOfCells());
  // A MaximumError of 0 asks for it.
  vtkSmartPointer<vtkPolyData> lost = WallScan().Lose({ { Middle, Middle } }).Make();
  EXPECT_EQ(HashMap(MakeMap(lost, GapProperties{ 25, 4, true, 0.0 })), HashMap(MakeMap(lost, 0.0)));
}

TEST(MapOfGaps, GivesTheSameBitsForAnyNumberOfThreads)
{
  Random random(7);
  vtkSmartPointer<vtkPolyData> room = MakeScan(MakeMapScene("FurnishedRoom"));
  room = Keep(room, [&](vtkIdType) { return random.Get() >= 0.05; });
  const std::uint64_t expected = HashMap(MakeMap(room, GapProperties{ 25, 4, true, 0.01, 1 }));
  for (int threads : { 2, 3, 0 })
  {
    EXPECT_EQ(HashMap(MakeMap(room, GapProperties{ 25, 4, true, 0.01, threads })), expected);
  }
}

TEST(MapOfGaps, IsSmallIfManyBeamsAreLost)
{
  MapScene scene = MakeMapScene("FurnishedRoom");
  scene.AlphaResolution = 181;
  scene.BetaResolution = 180;
  vtkSmartPointer<vtkPolyData> ideal = MakeScan(scene);
  const auto whole = static_cast<double>(MakeMap(ideal, GapProperties())->GetNumberOfCells());
  const std::map<double, double> factors = { { 0.01, 1.5 }, { 0.05, 3.0 } };
  for (const auto& [share, factor] : factors)
  {
    Random random(5);
    const double lost = share;
    vtkSmartPointer<vtkPolyData> scan =
      Keep(ideal, [&](vtkIdType) { return random.Get() >= lost; });
    vtkSmartPointer<vtkPolyData> map = MakeMap(scan, GapProperties{ 25 });
    EXPECT_LE(static_cast<double>(map->GetNumberOfCells()), factor * whole);
    EXPECT_GT(GetField(map, "NumberOfClosedGaps"), 0.6 * lost * 181 * 180);
    EXPECT_EQ(CountReturnsOnAll(map), static_cast<double>(scan->GetNumberOfPoints()));
    EXPECT_LE(GetLargestDistance(scan, map), 0.01 + 1e-9);
  }
}

TEST(MapOfGaps, KeepsTheBoundForMountingsAndOffsets)
{
  // Every third one, since maps of mirrors beside the axis take long: each mounting and each offset
  // occur.
  const std::vector<TestPlatform> platforms = GetTestPlatforms();
  for (std::size_t i = 0; i < platforms.size(); i += 3)
  {
    const TestPlatform& platform = platforms[i];
    SCOPED_TRACE(platform.Name);
    Random random(11);
    vtkSmartPointer<vtkPolyData> ideal = MakeScan(MakeMapScene("ClosedRoom"), platform);
    vtkSmartPointer<vtkPolyData> scan =
      Keep(ideal, [&](vtkIdType) { return random.Get() >= 0.05; });
    vtkSmartPointer<vtkPolyData> open = MakeMap(scan, GapProperties{ 0 });
    vtkSmartPointer<vtkPolyData> map = MakeMap(scan, GapProperties{ 25 });
    EXPECT_LT(map->GetNumberOfCells(), open->GetNumberOfCells());
    EXPECT_GT(GetField(map, "NumberOfClosedGaps"), 0.0);
    EXPECT_LE(GetLargestDistance(scan, map), 0.01 + 1e-9);
    EXPECT_EQ(CountReturnsOnAll(map), static_cast<double>(scan->GetNumberOfPoints()));
    // ClosedBeamIds number the beams of the scan: the ideal scan has returns there, on the surface.
    const std::vector<int> closed = GetFieldValues(map, "ClosedBeamIds");
    vtkDataArray* ids = ideal->GetPointData()->GetArray("BeamId");
    vtkSmartPointer<vtkPolyData> lost = Keep(ideal,
      [&](vtkIdType number)
      {
        return std::binary_search(
          closed.begin(), closed.end(), static_cast<int>(ids->GetTuple1(number)));
      });
    EXPECT_EQ(lost->GetNumberOfPoints(), static_cast<vtkIdType>(closed.size()));
    EXPECT_LE(GetLargestDistance(lost, map), 0.02);
  }
}
