// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that diagonals of quadrilaterals are flipped where two planes meet, and only there.
 */
#include "LocalMap/Bounded/lms3dEdgeFlipper.h"
#include "LocalMap/SurfaceFitMaps.h"

#include "Geometry/lms3dAngle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace
{
constexpr double Bound = 0.3;
constexpr double Degree = lms3dPi / 180.0;

lms3dVector GetDirection(int beam, int turn)
{
  const double alpha = (2.0 * beam - 90.0) * Degree;
  const double beta = 4.0 * turn * Degree;
  return { std::cos(alpha) * std::cos(beta), -std::cos(alpha) * std::sin(beta), std::sin(alpha) };
}

// Two planes that meet in the plane y = 0, at x = 2.
double GetInverse(const lms3dVector& direction)
{
  return 0.5 * direction[0] + 0.2 * std::abs(direction[1]);
}

double GetRange(int beam, int turn)
{
  const double inverse = GetInverse(GetDirection(beam, turn));
  return inverse > 0.1 ? 1.0 / inverse : 0.0;
}

enum Vertex
{
  Left,
  Right,
  Upper,
  Lower,
  Extra,
  Aside
};

/// A quadrilateral with its corners on the planes.
class Quadrilateral
{
public:
  explicit Quadrilateral(bool isEdgeOnCrease, double left = 0.3)
  {
    for (const lms3dVector& point : { lms3dVector{ 1.0, left, 0.0 }, { 1.0, -0.3, 0.0 },
           { 1.0, 0.0, 0.3 }, { 1.0, 0.0, -0.3 }, { 1.0, 0.5, 0.5 }, { 1.0, 0.5, 0.0 } })
    {
      const lms3dVector direction = lms3dNormalize(point);
      this->Map.Points.push_back(lms3dScale(direction, 1.0 / GetInverse(direction)));
    }
    this->Map.Triangles = isEdgeOnCrease
      ? std::vector<std::array<std::int32_t, 3>>{ { Upper, Left, Lower }, { Lower, Right, Upper } }
      : std::vector<std::array<std::int32_t, 3>>{ { Left, Right, Upper }, { Right, Left, Lower } };
    this->Map.Triangles.push_back({ Left, Upper, Extra });
    for (std::array<std::int32_t, 3>& corners : this->Map.Triangles)
    {
      this->TurnToSensor(corners);
    }
    this->Map.PatchIds.assign(this->Map.Triangles.size(), 0);
    this->Map.NumberOfPatches = 1;
  }

  // Joins the two corners that a flip would join.
  void JoinUpperAndLower()
  {
    this->Map.Triangles.push_back({ Upper, Lower, Aside });
    this->TurnToSensor(this->Map.Triangles.back());
    this->Map.PatchIds.push_back(0);
  }

  // Makes the second triangle a part of a strip between patches.
  void MakeStrip() { this->Map.PatchIds[1] = -1; }

  const lms3dBoundedMap& Get() const { return this->Map; }

private:
  void TurnToSensor(std::array<std::int32_t, 3>& corners) const
  {
    if (!this->Map.IsFacing(corners))
    {
      std::swap(corners[1], corners[2]);
    }
  }

  lms3dBoundedMap Map;
};

class EdgeFlipper : public testing::Test
{
protected:
  // Returns what lms3dEdgeFlipper::Run() returns.
  static std::vector<std::uint8_t> Run(lms3dVertexStars& stars,
    const std::function<double(int, int)>& getRange = GetRange,
    const std::vector<std::int32_t>& patchIds = { 0, 0, 0, 0 })
  {
    const BallScan scan(getRange);
    const lms3dBeamSphere sphere(scan.Grid, scan.Joins);
    lms3dPatches patches;
    patches.Patches.resize(1);
    patches.Labels.assign(sphere.GetSize(), 0);
    const lms3dBeamDemands demands(sphere, patches, Bound);
    return lms3dEdgeFlipper(demands, patchIds, Bound, stars).Run();
  }

  // An edge is looked at only beside a collapse.
  static void CollapseExtra(lms3dVertexStars& stars)
  {
    stars.SetFree({ 0, 0, 0, 0, 1, 0 });
    stars.Collapse(Extra, Left, stars.GetVertex(Left).Corner.Position, 1.0);
  }

  static bool HasEdge(const lms3dVertexStars& stars, std::int32_t a, std::int32_t b)
  {
    const std::vector<std::int32_t> neighbors = stars.GetNeighbors(a);
    return std::find(neighbors.begin(), neighbors.end(), b) != neighbors.end();
  }

  // Expects that the edge stays although edges have collapsed beside it.
  static void ExpectNoFlip(const Quadrilateral& quadrilateral)
  {
    lms3dVertexStars stars(quadrilateral.Get());
    CollapseExtra(stars);
    EXPECT_TRUE(Run(stars).empty());
    EXPECT_TRUE(HasEdge(stars, Left, Right));
  }
};
} // namespace

TEST_F(EdgeFlipper, PutsTheEdgeWhereThePlanesMeet)
{
  lms3dVertexStars stars(Quadrilateral(false).Get());
  CollapseExtra(stars);
  const std::vector<std::uint8_t> isAtFlip = Run(stars);
  EXPECT_EQ(isAtFlip, (std::vector<std::uint8_t>{ 1, 1, 1, 1, 0, 0 }));
  EXPECT_TRUE(HasEdge(stars, Upper, Lower));
  EXPECT_FALSE(HasEdge(stars, Left, Right));
  for (std::int32_t vertex : { Left, Right, Upper, Lower })
  {
    EXPECT_EQ(
      stars.GetVertex(vertex).Triangles.size(), vertex == Left || vertex == Right ? 1U : 2U);
    EXPECT_FALSE(stars.GetVertex(vertex).HasMoved);
  }
  lms3dBoundedMap map = Quadrilateral(false).Get();
  for (int triangle : { 0, 1 })
  {
    EXPECT_TRUE(map.IsFacing(stars.GetTriangles()[triangle].Corners));
  }
}

TEST_F(EdgeFlipper, LeavesAnEdgeThatFits)
{
  lms3dVertexStars stars(Quadrilateral(true).Get());
  CollapseExtra(stars);
  EXPECT_TRUE(Run(stars).empty());
  EXPECT_TRUE(HasEdge(stars, Upper, Lower));
}

TEST_F(EdgeFlipper, LeavesEdgesFarFromCollapses)
{
  lms3dVertexStars stars(Quadrilateral(false).Get());
  EXPECT_TRUE(Run(stars).empty());
  EXPECT_TRUE(HasEdge(stars, Left, Right));
}

// Each triangle keeps its patch, so it has to keep the returns of this patch.
TEST_F(EdgeFlipper, LeavesEdgesBetweenPatches)
{
  lms3dVertexStars stars(Quadrilateral(false).Get());
  CollapseExtra(stars);
  EXPECT_TRUE(Run(stars, GetRange, { 0, 1, 0 }).empty());
  EXPECT_TRUE(HasEdge(stars, Left, Right));
}

TEST_F(EdgeFlipper, LeavesTrianglesThatJoinPatches)
{
  Quadrilateral quadrilateral(false);
  quadrilateral.MakeStrip();
  ExpectNoFlip(quadrilateral);
}

// Two edges between the same vertices would make a surface that cannot be traversed.
TEST_F(EdgeFlipper, JoinsNoVerticesTwice)
{
  Quadrilateral quadrilateral(false);
  quadrilateral.JoinUpperAndLower();
  ExpectNoFlip(quadrilateral);
}

// The sensor sees the left corner to the right of the crease.
TEST_F(EdgeFlipper, LeavesQuadrilateralsThatAreNotConvex)
{
  const Quadrilateral quadrilateral(false, -0.1);
  lms3dVertexStars stars(quadrilateral.Get());
  CollapseExtra(stars);
  EXPECT_TRUE(Run(stars).empty());
}

// A return lies in front of the crease, so within the bound of the map before the flip. Afterwards
// the map is farther behind it.
TEST_F(EdgeFlipper, KeepsTheBound)
{
  constexpr int Middle = 45;
  for (double distance : { 0.9 * Bound, 1.1 * Bound })
  {
    lms3dVertexStars stars(Quadrilateral(false).Get());
    CollapseExtra(stars);
    const bool isFlipped = !Run(stars,
      [&](int beam, int turn) {
        return beam == Middle && turn == 0 ? 2.0 - distance : GetRange(beam, turn);
      }).empty();
    EXPECT_EQ(isFlipped, distance < Bound) << distance;
  }
}
