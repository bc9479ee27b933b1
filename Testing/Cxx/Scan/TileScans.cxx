// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scan/TileScans.h"

#include "Fixtures/CasterFixtures.h"

#include "Casting/lms3dExactView.h"
#include "Casting/lms3dTileSearch.h"
#include "Device/lms3dScanGeometry.h"
#include "Scan/lms3dScanner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace
{
struct Grid
{
  std::string Name;
  double Alpha[2];
  int Beams;
  double Beta[2];
  int Turns;

  lms3dScanGeometry GetGeometry() const
  {
    return { this->Alpha, this->Beams, this->Beta, this->Turns };
  }
};

const Grid Grids[] = {
  { "whole", { -90.0, 90.0 }, 91, { 0.0, 360.0 }, 360 },
  { "part", { -31.0, 77.5 }, 83, { 20.0, 211.0 }, 197 },
  { "one beam", { 12.0, 12.5 }, 1, { 0.0, 360.0 }, 720 },
  { "one turn", { -90.0, 90.0 }, 1441, { 45.0, 46.0 }, 1 },
  { "a quarter of a degree", { -20.0, 0.0 }, 81, { 0.0, 60.0 }, 241 },
  { "from pole to pole in a block", { -90.0, 90.0 }, 46, { 0.0, 360.0 }, 257 },
  { "nearly from pole to pole in a block", { -89.99, 89.99 }, 60, { 0.0, 360.0 }, 512 },
  { "the widest blocks", { -90.0, 90.0 }, 130, { 0.0, 360.0 }, 256 },
  { "two turns", { -90.0, 90.0 }, 1200, { 10.0, 11.0 }, 2 },
};

const Vector Orientations[] = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 30.0 }, { 33.0, -71.0, 123.0 } };

/// The hits of all beams.
struct Hits
{
  explicit Hits(std::size_t beams)
    : Ranges(beams)
    , Triangles(beams)
    , NearestRanges(beams)
    , NearestTriangles(beams)
  {
  }

  void RemoveNearer(double minimumRange)
  {
    for (std::size_t i = 0; i < this->Ranges.size(); ++i)
    {
      if (this->Ranges[i] < minimumRange)
      {
        this->Ranges[i] = NAN;
        this->Triangles[i] = lms3dBeamPacket::NoTriangle;
      }
    }
  }

  std::vector<double> Ranges;
  std::vector<std::int32_t> Triangles;
  std::vector<double> NearestRanges;
  std::vector<std::int32_t> NearestTriangles;
};

template <typename T>
int CountDifferences(const std::vector<T>& a, const std::vector<T>& b)
{
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    count += a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])) ? 0 : 1;
  }
  return count;
}

struct Situation
{
  const lms3dRayCaster& Caster;
  lms3dScanGeometry Geometry;
  lms3dPose Pose;
  double MaximumRange;

  std::size_t CountBeams() const
  {
    return static_cast<std::size_t>(this->Geometry.GetNumberOfBeams()) *
      this->Geometry.GetNumberOfTurns();
  }

  lms3dRayOrigin GetOrigin() const
  {
    const Vector& position = this->Pose.Position;
    return { { position[0], position[1], position[2] }, this->MaximumRange };
  }

  Hits Scan() const
  {
    Hits hits(this->CountBeams());
    EXPECT_TRUE(lms3dScan({ this->Caster, this->Geometry, this->Pose, { 0.0, this->MaximumRange },
                            { hits.Ranges.data(), hits.Triangles.data() },
                            { hits.NearestRanges.data(), hits.NearestTriangles.data() } },
      [](double) { return true; }));
    return hits;
  }

  // Without the hits that processes compare, whole tiles need no packets.
  Hits ScanAlone(double minimumRange) const
  {
    Hits hits(this->CountBeams());
    EXPECT_TRUE(
      lms3dScan({ this->Caster, this->Geometry, this->Pose, { minimumRange, this->MaximumRange },
                  { hits.Ranges.data(), hits.Triangles.data() } },
        [](double) { return true; }));
    return hits;
  }

  // Sixteen beams of a turn in one packet, which no tile has.
  Hits CastPackets() const
  {
    const lms3dBeamDirections directions(this->Geometry, this->Pose);
    const lms3dRayOrigin origin = this->GetOrigin();
    const int beams = this->Geometry.GetNumberOfBeams();
    Hits hits(this->CountBeams());
    for (std::size_t first = 0; first < hits.Ranges.size(); first += lms3dBeamPacket::Size)
    {
      Beams aims;
      for (int i = 0; i < lms3dBeamPacket::Size; ++i)
      {
        const std::size_t beam = std::min(first + i, hits.Ranges.size() - 1);
        aims[i] =
          directions.GetDirection(static_cast<int>(beam / beams), static_cast<int>(beam % beams));
      }
      lms3dBeamPacket packet = MakePacket(aims);
      this->Caster.FindNearest(origin, &packet, 1);
      this->Caster.ComputeRanges(origin, &packet, 1);
      Keep(first, packet, hits.NearestRanges, hits.NearestTriangles);
      this->Caster.RefineRanges(origin, &packet, 1);
      Keep(first, packet, hits.Ranges, hits.Triangles);
    }
    for (std::size_t i = 0; i < hits.Ranges.size(); ++i)
    {
      hits.Ranges[i] = hits.Triangles[i] == lms3dBeamPacket::NoTriangle ? NAN : hits.Ranges[i];
    }
    return hits;
  }

  static void Keep(std::size_t first, const lms3dBeamPacket& packet, std::vector<double>& ranges,
    std::vector<std::int32_t>& triangles)
  {
    for (std::size_t i = 0; i < lms3dBeamPacket::Size && first + i < ranges.size(); ++i)
    {
      ranges[first + i] = packet.Range[i];
      triangles[first + i] = packet.Triangle[i];
    }
  }

  bool HasTiles() const
  {
    const lms3dBeamDirections directions(this->Geometry, this->Pose);
    return this->Caster
             .NewGridCaster(this->GetOrigin(),
               { this->Geometry.GetNumberOfTurns(), this->Geometry.GetNumberOfBeams(),
                 &directions.GetFanAxis(0), this->Geometry.GetBetaStep(),
                 this->Geometry.GetAlphaCosines().data(), this->Geometry.GetAlphaSines().data(),
                 directions.GetUp() })
             ->GetColumnsAtOnce() == lms3dTileSearch::PacketsPerSide;
  }

  void ExpectEqual() const
  {
    const Hits tiles = this->Scan();
    const Hits packets = this->CastPackets();
    EXPECT_EQ(CountDifferences(tiles.Ranges, packets.Ranges), 0);
    EXPECT_EQ(CountDifferences(tiles.Triangles, packets.Triangles), 0);
    EXPECT_EQ(CountDifferences(tiles.NearestRanges, packets.NearestRanges), 0);
    EXPECT_EQ(CountDifferences(tiles.NearestTriangles, packets.NearestTriangles), 0);
    this->ExpectEqualAlone(packets);
  }

  // With two minimum ranges. A beam has the second one exactly.
  void ExpectEqualAlone(Hits packets) const
  {
    double minimumRange = 0.0;
    for (int i = 0; i < 2; ++i)
    {
      const Hits tiles = this->ScanAlone(minimumRange);
      EXPECT_EQ(CountDifferences(tiles.Ranges, packets.Ranges), 0);
      EXPECT_EQ(CountDifferences(tiles.Triangles, packets.Triangles), 0);
      const auto middle =
        packets.Ranges.begin() + static_cast<std::ptrdiff_t>(packets.Ranges.size() / 2);
      const auto hit =
        std::find_if(middle, packets.Ranges.end(), [](double range) { return range > 0.0; });
      minimumRange = hit == packets.Ranges.end() ? 0.0 : *hit;
      packets.RemoveNearer(minimumRange);
    }
  }
};

} // namespace

int ExpectEqualScans(const lms3dTriangleMesh& mesh, const std::vector<Vector>& sensors,
  const std::vector<double>& maximumRanges)
{
  const std::unique_ptr<lms3dRayCaster> caster = lms3dRayCaster::New(lms3dRayCaster::EXACT, mesh);
  int withTiles = 0;
  for (const Vector& sensor : sensors)
  {
    for (const Vector& orientation : Orientations)
    {
      for (const Grid& grid : Grids)
      {
        for (double maximumRange : maximumRanges)
        {
          SCOPED_TRACE(testing::Message()
            << grid.Name << " from " << sensor[0] << " " << sensor[1] << " " << sensor[2]
            << " turned by " << orientation[0] << " " << orientation[1] << " " << orientation[2]
            << ", up to " << maximumRange);
          const Situation situation = { *caster, grid.GetGeometry(),
            lms3dPose::FromOrientation(sensor.data(), orientation.data()), maximumRange };
          situation.ExpectEqual();
          withTiles += situation.HasTiles() ? 1 : 0;
        }
      }
    }
  }
  return withTiles;
}

bool ExpectEqualScan(const lms3dTriangleMesh& mesh, const Vector& sensor, double maximumRange)
{
  const std::unique_ptr<lms3dRayCaster> caster = lms3dRayCaster::New(lms3dRayCaster::EXACT, mesh);
  const Situation situation = { *caster, Grids[0].GetGeometry(),
    lms3dPose::FromOrientation(sensor.data(), Orientations[0].data()), maximumRange };
  situation.ExpectEqual();
  return situation.HasTiles();
}
