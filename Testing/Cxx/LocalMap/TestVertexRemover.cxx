// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks which vertices are removed from a map, and which shortcuts a border may take.
 */
#include "LocalMap/Bounded/lms3dBorderShortcuts.h"
#include "LocalMap/Bounded/lms3dVertexRemover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Near = 2.0;
constexpr double Tolerance = 0.0085;
constexpr int Beams = 41;
constexpr int Turns = 41;

/// Beams in steps of a degree, to 20 degrees on all sides. The surface to the left of the middle is
/// near, the surface to the right is farther by `step`; 0 means that there is none.
struct Wall
{
  explicit Wall(double step)
    : Geometry(MakeGeometry())
  {
    std::vector<double> ranges;
    std::vector<int> ids;
    for (int i = 0; i < Beams * Turns; ++i)
    {
      const bool isLeft = i / Beams < Turns / 2;
      if (isLeft || step > 0.0)
      {
        ranges.push_back(isLeft ? Near : Near + step);
        ids.push_back(i);
      }
    }
    this->Grid.Build(this->Geometry, ranges.data(), ids.data(), static_cast<int>(ids.size()));
    this->Joins.Find(this->Grid, 0.1);
    this->Sphere = std::make_unique<lms3dBeamSphere>(this->Grid, this->Joins);
    this->FillPatches();
  }

  static lms3dScanGeometry MakeGeometry()
  {
    const double angles[2] = { -20.0, 20.0 };
    return { angles, Beams, angles, Turns };
  }

  // Each side is a patch. The planes do not matter as long as the ranges do not change.
  void FillPatches()
  {
    this->Patches.Labels.assign(this->Sphere->GetSize(), lms3dPatches::None);
    this->Patches.Patches.resize(2);
    for (lms3dBeamSphere::GridIndex index = 0; index < this->Sphere->GetSize(); ++index)
    {
      if (this->Sphere->HasReturn(index))
      {
        const int patch = this->Sphere->GetRange(index) == Near ? 0 : 1;
        this->Patches.Labels[index] = patch;
        this->Patches.Patches[patch].Fit.Add(*this->Sphere, index);
      }
    }
    for (lms3dPatches::Patch& patch : this->Patches.Patches)
    {
      patch.Plane = patch.Fit.GetPlane();
    }
  }

  /// Whether the border of the near surface may leave out the middle one of three vertices, each
  /// given by its angles in degrees, to the right and upwards, and by its range.
  bool IsAllowed(const std::array<lms3dVector, 3>& vertices) const
  {
    const lms3dBorderShortcuts shortcuts(*this->Sphere, this->Patches, Tolerance);
    std::vector<lms3dVertexStars::Vertex> corners;
    for (const auto& [right, up, range] : vertices)
    {
      const double azimuth = right * Pi / 180.0;
      const double elevation = up * Pi / 180.0;
      corners.push_back({ lms3dTriangleCorner({ std::cos(elevation) * std::cos(azimuth),
                            -std::cos(elevation) * std::sin(azimuth), std::sin(elevation) }),
        1.0 / range, false, false, false, {} });
    }
    return shortcuts.IsAllowed(corners[0], corners[1], corners[2]);
  }

  const lms3dScanGeometry Geometry;
  lms3dRangeGrid Grid;
  lms3dRangeJoins Joins;
  std::unique_ptr<lms3dBeamSphere> Sphere;
  lms3dPatches Patches;
};

/// Allows what a test says.
struct Rules : lms3dVertexMoves
{
  bool MayLeaveBorder(
    const lms3dVertexStars&, std::int32_t, std::int32_t, std::int32_t) const override
  {
    return this->BorderMoves;
  }
  bool MayLeaveOffset(
    const lms3dVertexStars&, std::int32_t, std::int32_t, std::int32_t) const override
  {
    return this->OffsetMoves;
  }
  bool KeepsBound(const lms3dVertexStars&, std::int32_t from, std::int32_t) const override
  {
    return from != this->Needed;
  }

  bool BorderMoves = false;
  bool OffsetMoves = false;
  std::int32_t Needed = -1;
};

/// A square of two rings: a vertex in the middle (0), and eight around it.
lms3dBoundedMap MakeSquare()
{
  lms3dBoundedMap map;
  constexpr double Across[9] = { 0.0, 1.0, 1.0, 0.0, -1.0, -1.0, -1.0, 0.0, 1.0 };
  constexpr double Up[9] = { 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, -1.0, -1.0, -1.0 };
  for (int i = 0; i < 9; ++i)
  {
    map.Points.push_back({ 10.0, -Across[i], Up[i] });
  }
  for (std::int32_t i = 1; i <= 8; ++i)
  {
    map.Triangles.push_back({ 0, i, i % 8 + 1 });
    map.PatchIds.push_back(0);
  }
  map.NumberOfPatches = 1;
  return map;
}

int CountTriangles(const Rules& rules, const lms3dBoundedMap& map = MakeSquare())
{
  lms3dVertexStars stars(map);
  lms3dVertexRemover(rules, stars).Run();
  return static_cast<int>(std::count_if(stars.GetTriangles().begin(), stars.GetTriangles().end(),
    [](const lms3dVertexStars::Triangle& triangle) { return !triangle.IsRemoved; }));
}
} // namespace

TEST(VertexRemover, RemovesWhatTheRulesAllow)
{
  EXPECT_TRUE(MakeSquare().IsFacing({ 0, 1, 2 }));
  EXPECT_EQ(CountTriangles({}), 6) << "without the middle";
  Rules middle;
  middle.Needed = 0;
  EXPECT_EQ(CountTriangles(middle), 8);
  middle.BorderMoves = true;
  EXPECT_EQ(CountTriangles(middle), 4) << "the corners of a square cannot go around the middle";
}

TEST(VertexRemover, MovesTheVerticesOfStripsAlongTheirLine)
{
  lms3dBoundedMap map = MakeSquare();
  std::fill_n(map.PatchIds.begin(), 4, lms3dBoundedMap::NoPatch);
  Rules line;
  EXPECT_EQ(CountTriangles(line, map), 8);
  line.OffsetMoves = true;
  EXPECT_EQ(CountTriangles(line, map), 6);
  map.PatchIds[6] = lms3dBoundedMap::NoPatch;
  EXPECT_EQ(CountTriangles(line, map), 8) << "two lines meet in the middle";
}

// The border lies half a degree to the right of the last beams on the left, at -1 degree.
TEST(BorderShortcuts, PassTheSameGates)
{
  const Wall wall(1.0);
  EXPECT_TRUE(
    wall.IsAllowed({ { { -0.5, -3.4, Near }, { -0.4, 0.5, Near }, { -0.5, 4.6, Near } } }));
  EXPECT_TRUE(
    wall.IsAllowed({ { { -0.5, -3.4, Near }, { -0.6, 0.5, Near }, { -0.5, 4.6, Near } } }));
  EXPECT_FALSE(
    wall.IsAllowed({ { { -0.5, -3.4, Near }, { -1.5, 0.0, Near }, { -0.5, 4.6, Near } } }))
    << "a beam lies between";
  EXPECT_FALSE(
    wall.IsAllowed({ { { -0.5, 4.6, Near }, { -0.4, 0.5, Near }, { -0.5, -3.4, Near } } }))
    << "the surface would lie to the right";
}

TEST(BorderShortcuts, StayInTheRangesThatReturnsSupport)
{
  const auto isAllowed = [](double step, double change)
  {
    return Wall(step).IsAllowed(
      { { { -0.5, -1.4, Near + change }, { -0.4, 0.5, Near }, { -0.5, 2.6, Near + change } } });
  };
  for (double step : { 0.2, 1.0 })
  {
    EXPECT_TRUE(isAllowed(step, -0.006)) << step;
    EXPECT_TRUE(isAllowed(step, 0.006)) << step;
    EXPECT_FALSE(isAllowed(step, -0.012)) << step;
    EXPECT_FALSE(isAllowed(step, 0.012)) << step;
  }
  // Beside a miss, the tilt of the plane counts, too.
  EXPECT_FALSE(isAllowed(0.0, -0.5));
  EXPECT_FALSE(isAllowed(0.0, 0.5));
}

// Where a depth step ends inside of a surface, its two sides must not be joined across it.
TEST(BorderShortcuts, DoNotCloseASlit)
{
  const Wall wall(1.0);
  EXPECT_FALSE(
    wall.IsAllowed({ { { -0.7, 0.0, Near }, { -0.5, 1.3, Near }, { -0.3, 0.0, Near } } }));
  EXPECT_FALSE(
    wall.IsAllowed({ { { -0.3, 0.0, Near }, { -0.5, 1.3, Near }, { -0.7, 0.0, Near } } }));
  EXPECT_FALSE(
    wall.IsAllowed({ { { -0.3, 0.2, Near }, { -0.5, 3.3, Near }, { -0.7, 0.2, Near } } }));
}
