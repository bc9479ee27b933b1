// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The constrained Delaunay triangulation, and the orientation that it is built on.
 */
#include "Triangulation/lms3dOrientation.h"
#include "Triangulation/lms3dTriangulation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace
{
using Loop = std::vector<std::int32_t>;

double GetSignedArea(const lms3dPoint2& a, const lms3dPoint2& b, const lms3dPoint2& c)
{
  return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

double GetInnerArea(const lms3dTriangulation& mesh, const std::vector<lms3dPoint2>& points)
{
  double area = 0.0;
  for (int i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    const std::array<std::int32_t, 3>& corners = mesh.GetCorners(i);
    if (mesh.IsInside(i))
    {
      const double part = GetSignedArea(points[corners[0]], points[corners[1]], points[corners[2]]);
      EXPECT_GT(part, 0.0);
      area += part;
    }
  }
  return area;
}

/// A square of the side `count` with a hole of the side 0.5 in each of its unit cells.
struct Sieve
{
  explicit Sieve(int count)
  {
    const double side = count;
    this->AddLoop({ { 0, 0 }, { side, 0 }, { side, side }, { 0, side } });
    for (int i = 0; i < count; ++i)
    {
      for (int j = 0; j < count; ++j)
      {
        const double x = i + 0.25;
        const double y = j + 0.25;
        this->AddLoop({ { x, y }, { x, y + 0.5 }, { x + 0.5, y + 0.5 }, { x + 0.5, y } });
      }
    }
  }

  void AddLoop(const std::vector<lms3dPoint2>& corners)
  {
    for (const lms3dPoint2& corner : corners)
    {
      this->Loops.push_back(static_cast<std::int32_t>(this->Points.size()));
      this->Points.push_back(corner);
    }
    this->Ends.push_back(static_cast<std::int32_t>(this->Loops.size()));
  }

  std::vector<lms3dPoint2> Points;
  Loop Loops;
  Loop Ends;
};
} // namespace

TEST(Orientation, IsExactForPointsThatAreNearlyOnALine)
{
  const double tiny = std::ldexp(1.0, -53);
  // Without rounding, c lies off the diagonal by half of the last digit of 1.
  const lms3dPoint2 a = { 0.0, 0.0 };
  const lms3dPoint2 b = { 3.0, 3.0 };
  EXPECT_EQ(lms3dGetOrientation(a, b, { 0.5, 0.5 }), 0);
  EXPECT_EQ(lms3dGetOrientation(a, b, { 0.5, 0.5 + tiny }), 1);
  EXPECT_EQ(lms3dGetOrientation(a, b, { 0.5 + tiny, 0.5 }), -1);
  EXPECT_EQ(lms3dGetOrientation(b, a, { 0.5, 0.5 + tiny }), -1);
}

TEST(Orientation, IsExactForWholeNumbers)
{
  std::mt19937 random(1);
  for (const int largest : { 3, 1000, 1 << 25, 1 << 30 })
  {
    std::uniform_int_distribution<std::int64_t> place(-largest, largest);
    for (int i = 0; i < 3000; ++i)
    {
      const std::int64_t u = place(random);
      const std::int64_t v = place(random);
      const std::int64_t share = place(random) % 3;
      // On the line through the origin and the first point, or one beside it.
      const std::int64_t beside = place(random) % 2;
      const lms3dPoint2 a = { 0.0, 0.0 };
      const lms3dPoint2 b = { 1.0 * u, 1.0 * v };
      const lms3dPoint2 c = { 1.0 * (share * u), 1.0 * (share * v + beside) };
      const std::int64_t cross = u * beside;
      EXPECT_EQ(lms3dGetOrientation(a, b, c), cross > 0 ? 1 : (cross < 0 ? -1 : 0));
      EXPECT_EQ(lms3dGetOrientation(b, c, a), lms3dGetOrientation(a, b, c));
      EXPECT_EQ(lms3dGetOrientation(b, a, c), -lms3dGetOrientation(a, b, c));
    }
  }
}

TEST(Triangulation, FillsARegionWithManyHoles)
{
  const int count = 40;
  const Sieve sieve(count);
  const lms3dTriangulation mesh(sieve.Points, sieve.Loops, sieve.Ends);
  ASSERT_TRUE(mesh.IsValid());
  EXPECT_NEAR(GetInnerArea(mesh, sieve.Points), 0.75 * count * count, 1e-9);
}

TEST(Triangulation, KeepsEveryEdgeOfItsOutline)
{
  // A comb of thin teeth, whose edges no Delaunay triangulation has by itself.
  Sieve comb(1);
  comb.Points.clear();
  comb.Loops.clear();
  comb.Ends.clear();
  std::vector<lms3dPoint2> outline = { { 0.0, -1.0 }, { 20.0, -1.0 } };
  for (int tooth = 19; tooth >= 0; --tooth)
  {
    outline.push_back({ tooth + 0.9, 5.0 });
    outline.push_back({ tooth + 0.5, 0.0 });
  }
  comb.AddLoop(outline);
  const lms3dTriangulation mesh(comb.Points, comb.Loops, comb.Ends);
  ASSERT_TRUE(mesh.IsValid());
  std::set<std::array<std::int32_t, 2>> edges;
  for (int i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    for (int j = 0; mesh.IsInside(i) && j < 3; ++j)
    {
      edges.insert({ mesh.GetCorners(i)[j], mesh.GetCorners(i)[(j + 1) % 3] });
    }
  }
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const std::int32_t next = static_cast<std::int32_t>((i + 1) % outline.size());
    EXPECT_EQ(edges.count({ static_cast<std::int32_t>(i), next }), 1u) << i;
  }
}

TEST(Triangulation, TakesPointsIn)
{
  Sieve sieve(8);
  const double area = 0.75 * 64.0;
  lms3dTriangulation mesh(sieve.Points, sieve.Loops, sieve.Ends);
  ASSERT_TRUE(mesh.IsValid());
  sieve.Points.resize(sieve.Points.size() + 3); // The super-triangle's.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0.01, 7.99);
  int taken = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const lms3dPoint2 point = { anywhere(random), anywhere(random) };
    const double x = point[0] - std::floor(point[0]);
    const double y = point[1] - std::floor(point[1]);
    const bool isInHole = x > 0.25 && x < 0.75 && y > 0.25 && y < 0.75;
    const std::int32_t number = mesh.Insert(point, 0);
    EXPECT_EQ(number == lms3dTriangulation::None, isInHole);
    if (number != lms3dTriangulation::None)
    {
      EXPECT_EQ(number, static_cast<std::int32_t>(sieve.Points.size()));
      sieve.Points.push_back(point);
      ++taken;
      EXPECT_EQ(mesh.Insert(point, 0), lms3dTriangulation::None) << "there is a point already";
    }
  }
  EXPECT_GT(taken, 1000);
  EXPECT_NEAR(GetInnerArea(mesh, sieve.Points), area, 1e-9);
}

TEST(Triangulation, RefusesOutlinesThatCross)
{
  const std::vector<lms3dPoint2> points = { { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } };
  EXPECT_FALSE(lms3dTriangulation(points, { 0, 1, 2, 3 }, { 4 }).IsValid());
  // Clockwise: all of the plane would be inside.
  EXPECT_FALSE(lms3dTriangulation(points, { 0, 3, 1, 2 }, { 4 }).IsValid());
  EXPECT_TRUE(lms3dTriangulation(points, { 0, 2, 1, 3 }, { 4 }).IsValid());
}
