// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/MeshFixtures.h"
#include "Geometry/PolygonFixtures.h"
#include "Geometry/lms3dAngle.h"
#include "Geometry/lms3dTriangulator.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace
{
double GetArea(const Corners& corners, const std::vector<lms3dTriangulator::Triangle>& triangles)
{
  std::vector<std::array<Vector, 3>> ofCorners;
  ofCorners.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles)
  {
    ofCorners.push_back({ corners[a], corners[b], corners[c] });
  }
  return ::GetArea(ofCorners);
}

/// Returns the area that the outline encloses. Requires a polygon in a plane z.
double GetAreaOfOutline(const Corners& corners)
{
  double area = 0.0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    area += 0.5 *
      lms3dCross(
        lms3dSubtract(corners[i], corners[0]), lms3dSubtract(corners[i + 1], corners[0]))[2];
  }
  return area;
}

/// Triangulates a polygon that does not cross itself. The number of calls measures the work.
void ExpectExactCover(const Corners& corners)
{
  lms3dTriangulator triangulator;
  std::size_t calls = 0;
  EXPECT_TRUE(triangulator.Cut(corners, [&calls] { return ++calls > 0; }));
  const double area = GetAreaOfOutline(corners);
  EXPECT_NEAR(GetArea(corners, triangulator.GetTriangles()), area, 1e-5 * area);
  EXPECT_LE(calls, (2000 * corners.size() + 1000000) / 100000);
}
} // namespace

TEST(Triangulator, CutsConvexAndConcavePolygons)
{
  lms3dTriangulator triangulator;
  const Corners square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  EXPECT_TRUE(triangulator.Cut(square));
  EXPECT_EQ(triangulator.GetTriangles().size(), 2u);
  const Corners u = { { 0, 0, 5 }, { 3, 0, 5 }, { 3, 3, 5 }, { 2, 3, 5 }, { 2, 1, 5 }, { 1, 1, 5 },
    { 1, 3, 5 }, { 0, 3, 5 } };
  EXPECT_TRUE(triangulator.Cut(u));
  EXPECT_EQ(triangulator.GetTriangles().size(), 6u);
  EXPECT_DOUBLE_EQ(GetArea(u, triangulator.GetTriangles()), 7.0);
}

TEST(Triangulator, KeepsTheSideThatFacesTheViewer)
{
  lms3dTriangulator triangulator;
  for (bool isReversed : { false, true })
  {
    Corners l = { { 0, 0, 0 }, { 0, 2, 0 }, { 0, 2, 1 }, { 0, 1, 1 }, { 0, 1, 2 }, { 0, 0, 2 } };
    if (isReversed)
    {
      l = Corners(l.rbegin(), l.rend());
    }
    EXPECT_TRUE(triangulator.Cut(l));
    for (const auto& [a, b, c] : triangulator.GetTriangles())
    {
      const double x = lms3dCross(lms3dSubtract(l[b], l[a]), lms3dSubtract(l[c], l[a]))[0];
      EXPECT_GT(isReversed ? -x : x, 0.0);
    }
  }
}

TEST(Triangulator, CutsAHoleThatABridgeJoins)
{
  const Corners wall = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 3, 0 }, { 0, 3, 0 }, { 0, 0, 0 },
    { 1, 1, 0 }, { 1, 2, 0 }, { 3, 2, 0 }, { 3, 1, 0 }, { 1, 1, 0 } };
  lms3dTriangulator triangulator;
  EXPECT_TRUE(triangulator.Cut(wall));
  EXPECT_DOUBLE_EQ(GetArea(wall, triangulator.GetTriangles()), 10.0);
}

TEST(Triangulator, CutsFarAway)
{
  const double far = 1e9;
  const Corners l = { { far, far, 0 }, { far + 2, far, 0 }, { far + 2, far + 1, 0 },
    { far + 1, far + 1, 0 }, { far + 1, far + 2, 0 }, { far, far + 2, 0 } };
  lms3dTriangulator triangulator;
  EXPECT_TRUE(triangulator.Cut(l));
  EXPECT_DOUBLE_EQ(GetArea(l, triangulator.GetTriangles()), 3.0);
}

TEST(Triangulator, MakesNoTrianglesOfALine)
{
  lms3dTriangulator triangulator;
  for (const Corners& corners : { Corners(), Corners(2), Corners(5, { 1, 2, 3 }),
         Corners{ { 0, 0, 0 }, { 1, 1, 1 }, { 3, 3, 3 }, { 2, 2, 2 } } })
  {
    EXPECT_TRUE(triangulator.Cut(corners));
    EXPECT_TRUE(triangulator.GetTriangles().empty());
  }
}

TEST(Triangulator, ReportsPolygonsThatCrossThemselves)
{
  lms3dTriangulator triangulator;
  const Corners bow = { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  EXPECT_FALSE(triangulator.Cut(bow));
  EXPECT_FALSE(triangulator.GetTriangles().empty());
  Corners pentagram;
  for (int i = 0; i < 5; ++i)
  {
    pentagram.push_back({ std::cos(0.8 * lms3dPi * i), std::sin(0.8 * lms3dPi * i), 0 });
  }
  EXPECT_FALSE(triangulator.Cut(pentagram));
  EXPECT_FALSE(triangulator.GetTriangles().empty());
}

TEST(Triangulator, CutsPolygonsOfManyThousandCorners)
{
  lms3dTriangulator triangulator;
  const Corners comb = MakeComb(20000);
  EXPECT_TRUE(triangulator.Cut(comb));
  EXPECT_NEAR(GetArea(comb, triangulator.GetTriangles()), 2.0 * 20000 + 2.0 * 20000, 1e-6);
  const Corners star = MakeStar(20000);
  EXPECT_TRUE(triangulator.Cut(star));
  EXPECT_NEAR(
    GetArea(star, triangulator.GetTriangles()), 20000 * 2.0 * std::sin(lms3dPi / 20000), 1e-9);
}

TEST(Triangulator, SharesTheFirstOrTheLastCornerOfAQuadrilateral)
{
  // Not in one plane: each diagonal gives another surface.
  const Corners quadrilateral = { { 0, 0, 0 }, { 1, 0, 0.5 }, { 1, 1, 0 }, { 0, 1, 0.5 } };
  using Triangles = std::vector<lms3dTriangulator::Triangle>;
  lms3dTriangulator first;
  EXPECT_TRUE(first.Cut(quadrilateral));
  EXPECT_EQ(first.GetTriangles(), (Triangles{ { 0, 1, 2 }, { 0, 2, 3 } }));
  lms3dTriangulator last(lms3dTriangulator::LAST_CORNER);
  EXPECT_TRUE(last.Cut(quadrilateral));
  EXPECT_EQ(last.GetTriangles(), (Triangles{ { 3, 0, 1 }, { 3, 1, 2 } }));
}

TEST(Triangulator, KeepsAStraightCornerOfAConvexPolygonAsAVertex)
{
  const Corners square = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  for (std::size_t side = 0; side < 4; ++side)
  {
    Corners corners;
    for (std::size_t i = 0; i < 4; ++i)
    {
      corners.push_back(square[i]);
      if (i == side)
      {
        corners.push_back(lms3dScale(lms3dAdd(square[i], square[(i + 1) % 4]), 0.5));
      }
    }
    for (auto shared : { lms3dTriangulator::FIRST_CORNER, lms3dTriangulator::LAST_CORNER })
    {
      lms3dTriangulator triangulator(shared);
      EXPECT_TRUE(triangulator.Cut(corners));
      EXPECT_EQ(triangulator.GetTriangles().size(), 3u);
      EXPECT_DOUBLE_EQ(GetArea(corners, triangulator.GetTriangles()), 1.0);
    }
  }
}

TEST(Triangulator, CutsConvexPolygonsOfAnySize)
{
  for (int sides : { 16000, 1000000 })
  {
    lms3dTriangulator triangulator;
    const Corners corners = MakeRegularPolygon(sides, 2.0);
    EXPECT_TRUE(triangulator.Cut(corners));
    EXPECT_EQ(triangulator.GetTriangles().size(), static_cast<std::size_t>(sides) - 2);
    EXPECT_NEAR(GetArea(corners, triangulator.GetTriangles()),
      2.0 * sides * std::sin(2.0 * lms3dPi / sides), 1e-9);
  }
}

// The turns at single corners of a smooth outline are small, in particular far from the origin.
TEST(Triangulator, CutsSmoothConcavePolygons)
{
  for (double far : { 0.0, 5e6 })
  {
    for (double radius : { 1.0, 10.0 })
    {
      for (int count : { 2000, 4000, 50000 })
      {
        SCOPED_TRACE(::testing::Message() << count << " corners, " << radius << " m, at " << far);
        ExpectExactCover(MakeCrescent(count, radius, far));
      }
    }
  }
}

// At first the tips are the only ears.
TEST(Triangulator, CutsPolygonsWithFewConvexCorners)
{
  for (int cornersPerSide : { 2000, 5000 })
  {
    SCOPED_TRACE(cornersPerSide);
    ExpectExactCover(MakeBowedTriangle(cornersPerSide));
  }
}

TEST(Triangulator, CutsTinyPolygons)
{
  lms3dTriangulator triangulator;
  for (double size : { 1e-3, 1e-60, 1e-120 })
  {
    const Corners square = { { 0, 0, 0 }, { size, 0, 0 }, { size, size, 0 }, { 0, size, 0 } };
    EXPECT_TRUE(triangulator.Cut(square));
    EXPECT_EQ(triangulator.GetTriangles().size(), 2u) << size;
  }
}

TEST(Triangulator, StopsWithinAPolygon)
{
  lms3dTriangulator triangulator;
  const Corners star = MakeStar(100000);
  int calls = 0;
  EXPECT_FALSE(triangulator.Cut(star, [&calls] { return ++calls < 3; }));
  EXPECT_EQ(calls, 3);
  EXPECT_TRUE(triangulator.GetTriangles().empty());
  EXPECT_TRUE(triangulator.Cut(star, [] { return true; }));
  EXPECT_EQ(triangulator.GetTriangles().size(), star.size() - 2);
}

// The small loop of an eight turns the other way: at last all of its corners are reflex.
TEST(Triangulator, BoundsTheWorkOnAPolygonThatCrossesItself)
{
  constexpr int sides = 20000;
  Corners eight = MakeRegularPolygon(sides, 2.0);
  for (const lms3dVector& corner : MakeRegularPolygon(sides, 1.0))
  {
    eight.push_back({ 3.0 - corner[0], corner[1], 1.0 });
  }
  lms3dTriangulator triangulator;
  std::size_t calls = 0;
  EXPECT_FALSE(triangulator.Cut(eight, [&calls] { return ++calls > 0; }));
  EXPECT_LE(calls, 2 * (2000 * eight.size() + 1000000) / 100000);
  EXPECT_FALSE(triangulator.GetTriangles().empty());
}
