// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that a map is fitted to the returns of a ball around the sensor.
 */
#include "LocalMap/Bounded/lms3dSurfaceFit.h"
#include "LocalMap/Patches/lms3dPatches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace
{
constexpr double Radius = 2.0;
constexpr int Beams = 91;
constexpr int Turns = 90;

/// The metres by which borders at a depth step may be away from their returns.
constexpr double Tolerance = 0.045;

/// The scan of a ball.
struct BallScan
{
  /// `getRange` takes the numbers of the beam and the turn, and returns metres.
  explicit BallScan(
    const std::function<double(int, int)>& getRange = [](int, int) { return Radius; },
    int beams = Beams)
    : Geometry(Alpha, beams, Beta, Turns)
  {
    std::vector<double> ranges(static_cast<std::size_t>(beams) * Turns);
    for (std::size_t i = 0; i < ranges.size(); ++i)
    {
      ranges[i] = getRange(static_cast<int>(i) % beams, static_cast<int>(i) / beams);
    }
    std::vector<int> ids(ranges.size());
    std::iota(ids.begin(), ids.end(), 0);
    this->Grid.Build(this->Geometry, ranges.data(), ids.data(), beams * Turns);
    this->Joins.Find(this->Grid, 0.1);
  }

  static constexpr double Alpha[2] = { -90.0, 90.0 };
  static constexpr double Beta[2] = { 0.0, 360.0 };
  const lms3dScanGeometry Geometry;
  lms3dRangeGrid Grid;
  lms3dRangeJoins Joins;
};

/// An octahedron whose faces are divided into four twice, with all vertices on a sphere. The
/// triangles face the sensor.
class RoundMap
{
public:
  /// Starts with an octant; those from 4 on are below the sensor.
  explicit RoundMap(double radius, int firstOctant = 0)
    : Size(radius)
  {
    const lms3dVector x = { 1, 0, 0 };
    const lms3dVector y = { 0, 1, 0 };
    const lms3dVector z = { 0, 0, 1 };
    for (int octant = firstOctant; octant < 8; ++octant)
    {
      lms3dVector a = lms3dScale(x, octant & 1 ? -1.0 : 1.0);
      lms3dVector b = lms3dScale(y, octant & 2 ? -1.0 : 1.0);
      const lms3dVector c = lms3dScale(z, octant & 4 ? -1.0 : 1.0);
      if (lms3dDot(lms3dCross(a, b), c) > 0.0)
      {
        std::swap(a, b);
      }
      this->Divide(a, b, c, 2);
    }
    this->Map.PatchIds.assign(this->Map.Triangles.size(), 0);
    this->Map.NumberOfPatches = 1;
  }

  const lms3dBoundedMap& Get() const { return this->Map; }

private:
  void Divide(const lms3dVector& a, const lms3dVector& b, const lms3dVector& c, int times)
  {
    if (times == 0)
    {
      this->Map.Triangles.push_back({ this->Add(a), this->Add(b), this->Add(c) });
      return;
    }
    const lms3dVector ab = lms3dNormalize(lms3dAdd(a, b));
    const lms3dVector bc = lms3dNormalize(lms3dAdd(b, c));
    const lms3dVector ca = lms3dNormalize(lms3dAdd(c, a));
    this->Divide(a, ab, ca, times - 1);
    this->Divide(ab, b, bc, times - 1);
    this->Divide(ca, bc, c, times - 1);
    this->Divide(ab, bc, ca, times - 1);
  }

  std::int32_t Add(const lms3dVector& direction)
  {
    const auto [entry, isNew] =
      this->Numbers.insert({ direction, static_cast<std::int32_t>(this->Map.Points.size()) });
    if (isNew)
    {
      this->Map.Points.push_back(lms3dScale(direction, this->Size));
    }
    return entry->second;
  }

  const double Size;
  std::map<lms3dVector, std::int32_t> Numbers;
  lms3dBoundedMap Map;
};

/// The distances of the returns from a map along their beams, metres.
struct Distances
{
  double Largest = 0.0;
  double SumOfSquares = 0.0;
};

std::int32_t FindVertex(const lms3dVertexStars& stars, const lms3dVector& direction)
{
  std::int32_t vertex = 0;
  while (lms3dDot(stars.GetVertex(vertex).Corner.Position, direction) < 1.0 - 1e-9)
  {
    ++vertex;
  }
  return vertex;
}

std::vector<lms3dTriangleSums> GetSums(
  const lms3dBeamDemands& demands, const lms3dVertexStars& stars)
{
  std::vector<lms3dTriangleSums> sums;
  for (const lms3dVertexStars::Triangle& triangle : stars.GetTriangles())
  {
    const lms3dVertexStars::Vertex& a = stars.GetVertex(triangle.Corners[0]);
    const lms3dVertexStars::Vertex& b = stars.GetVertex(triangle.Corners[1]);
    const lms3dVertexStars::Vertex& c = stars.GetVertex(triangle.Corners[2]);
    sums.emplace_back(demands,
      lms3dTriangleSums::Triangle{
        { &a.Corner, &b.Corner, &c.Corner }, { a.Inverse, b.Inverse, c.Inverse } });
  }
  return sums;
}

double GetSum(const std::vector<lms3dTriangleSums>& sums, const lms3dVertexStars& stars)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    const auto& [a, b, c] = stars.GetTriangles()[i].Corners;
    sum += sums[i].GetSum(
      { stars.GetVertex(a).Inverse, stars.GetVertex(b).Inverse, stars.GetVertex(c).Inverse });
  }
  return sum;
}

/// The number of edges at the height of the sensor with a support.
int CountBorders(const lms3dVertexStars& stars, const lms3dBorderShortcuts& borders,
  lms3dBorderShortcuts::Support support)
{
  int count = 0;
  for (const lms3dVertexStars::Triangle& triangle : stars.GetTriangles())
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const lms3dVertexStars::Vertex& from = stars.GetVertex(triangle.Corners[corner]);
      const lms3dVertexStars::Vertex& to = stars.GetVertex(triangle.Corners[(corner + 1) % 3]);
      const bool isBorder =
        std::abs(from.Corner.Position[2]) < 1e-9 && std::abs(to.Corner.Position[2]) < 1e-9;
      count += isBorder && borders.GetSupportAtDepthSteps(from, to) == support ? 1 : 0;
    }
  }
  return count;
}

class SurfaceFit : public testing::Test
{
protected:
  SurfaceFit()
    : Sphere(this->Scan.Grid, this->Scan.Joins)
  {
    this->Patches.Patches.resize(1);
    this->Patches.Labels.assign(this->Sphere.GetSize(), 0);
  }

  void Fit(double bound, const std::vector<std::uint8_t>& isChosen, lms3dVertexStars& stars) const
  {
    const lms3dBeamDemands demands(this->Sphere, this->Patches, bound);
    const lms3dBorderShortcuts borders(this->Sphere, this->Patches, bound);
    lms3dSurfaceFit(demands, borders, bound, isChosen, stars).Run();
  }

  void FitAll(double bound, lms3dVertexStars& stars) const
  {
    this->Fit(bound, std::vector<std::uint8_t>(stars.GetNumberOfVertices(), 1), stars);
  }

  Distances Measure(const lms3dVertexStars& stars) const
  {
    Distances distances;
    for (const lms3dVertexStars::Triangle& triangle : stars.GetTriangles())
    {
      const auto& [a, b, c] = triangle.Corners;
      const lms3dTriangleRasterizer beams(this->Sphere, lms3dTriangleCorner(stars.GetPosition(a)),
        lms3dTriangleCorner(stars.GetPosition(b)), lms3dTriangleCorner(stars.GetPosition(c)));
      beams.ForEachColumn(
        [&](int column, int first, int last)
        {
          const lms3dTriangleRasterizer::ColumnRanges ranges(beams, column);
          for (int row = first; row <= last; ++row)
          {
            const double distance = std::abs(ranges.GetRange(row) - Radius);
            distances.Largest = std::max(distances.Largest, distance);
            distances.SumOfSquares += distance * distance;
          }
        });
    }
    return distances;
  }

  const BallScan Scan;
  const lms3dBeamSphere Sphere;
  lms3dPatches Patches;
};
} // namespace

// With its vertices on the ball, the map lies inside of the ball everywhere else.
TEST_F(SurfaceFit, PassesBetweenTheReturns)
{
  const RoundMap map(Radius);
  lms3dVertexStars stars(map.Get());
  const Distances before = this->Measure(stars);
  this->FitAll(0.2, stars);
  const Distances after = this->Measure(stars);
  EXPECT_LT(after.SumOfSquares, 0.2 * before.SumOfSquares);
  EXPECT_LT(after.Largest, before.Largest);
  for (std::int32_t vertex = 0; vertex < stars.GetNumberOfVertices(); ++vertex)
  {
    EXPECT_GT(1.0 / stars.GetVertex(vertex).Inverse, Radius);
    EXPECT_TRUE(stars.GetVertex(vertex).HasMoved);
  }
}

TEST_F(SurfaceFit, KeepsTheBound)
{
  const RoundMap map(Radius);
  const double distance = this->Measure(lms3dVertexStars(map.Get())).Largest;
  // The bound is larger than needed, just enough for the map before the fit, or too small for it.
  for (double share : { 1.5, 1.0001, 0.9, 0.5 })
  {
    // The second map lies on both sides of the ball, and its vertices are nearer to the bound.
    for (double size : { Radius, Radius + 0.9 * distance })
    {
      const RoundMap other(size);
      lms3dVertexStars stars(other.Get());
      const Distances before = this->Measure(stars);
      this->FitAll(share * distance, stars);
      const Distances after = this->Measure(stars);
      EXPECT_LE(after.Largest, std::max(before.Largest, share * distance) + 1e-9) << share;
      EXPECT_LE(after.SumOfSquares, 1.0001 * before.SumOfSquares) << share;
    }
  }
}

// A return in the direction of a vertex is nearly the bound nearer than the ball. So the vertex may
// not move as far as without it.
TEST_F(SurfaceFit, KeepsTheBoundOfASingleReturn)
{
  constexpr double Bound = 0.2;
  const RoundMap map(Radius);
  lms3dVertexStars free(map.Get());
  this->FitAll(Bound, free);
  const std::int32_t vertex = FindVertex(free, { 1.0, 0.0, 0.0 });
  EXPECT_GT(1.0 / free.GetVertex(vertex).Inverse, Radius + 0.1 * Bound);

  const BallScan scan(
    [](int beam, int turn) { return beam == 45 && turn == 0 ? Radius - 0.95 * Bound : Radius; });
  const lms3dBeamSphere sphere(scan.Grid, scan.Joins);
  const lms3dBeamDemands demands(sphere, this->Patches, Bound);
  const lms3dBorderShortcuts borders(sphere, this->Patches, Bound);
  lms3dVertexStars stars(map.Get());
  const std::vector<std::uint8_t> isChosen(stars.GetNumberOfVertices(), 1);
  lms3dSurfaceFit(demands, borders, Bound, isChosen, stars).Run();
  EXPECT_LE(1.0 / stars.GetVertex(vertex).Inverse, Radius + 0.05 * Bound + 1e-9);
}

// The lower half of a ball ends before a wider one. With its vertices on the ball, its border runs
// a bit inside; vertices that fit the returns lie too far outside for a border at a depth step.
TEST_F(SurfaceFit, KeepsBordersAtDepthStepsSupported)
{
  using Support = lms3dBorderShortcuts::Support;
  constexpr double Bound = 0.2;
  constexpr int EvenBeams = 90;
  const BallScan scan(
    [](int beam, int) { return beam < EvenBeams / 2 ? Radius : 2.0 * Radius; }, EvenBeams);
  const lms3dBeamSphere sphere(scan.Grid, scan.Joins);
  lms3dPatches patches;
  patches.Patches.resize(2);
  patches.Labels.assign(sphere.GetSize(), 0);
  lms3dPatches onlyLower = patches;
  for (int turn = 0; turn < Turns; ++turn)
  {
    for (int row = EvenBeams / 2; row < EvenBeams; ++row)
    {
      patches.Labels[sphere.GetIndex(turn, row)] = 1;
      onlyLower.Labels[sphere.GetIndex(turn, row)] = -1;
    }
  }
  const RoundMap map(Radius, 4);
  const lms3dBorderShortcuts judge(sphere, patches, Tolerance);
  int unsupported[2] = { 0, 0 };
  for (bool hasStep : { false, true })
  {
    const lms3dPatches& used = hasStep ? patches : onlyLower;
    const lms3dBeamDemands demands(sphere, used, Bound);
    const lms3dBorderShortcuts borders(sphere, used, Tolerance);
    lms3dVertexStars stars(map.Get());
    const std::vector<std::uint8_t> isChosen(stars.GetNumberOfVertices(), 1);
    EXPECT_EQ(CountBorders(stars, judge, Support::Supported), 16);
    lms3dSurfaceFit(demands, borders, Bound, isChosen, stars).Run();
    EXPECT_TRUE(stars.GetVertex(FindVertex(stars, { 0.0, 0.0, -1.0 })).HasMoved);
    unsupported[hasStep] = CountBorders(stars, judge, Support::Unsupported);
  }
  EXPECT_GT(unsupported[0], 0);
  EXPECT_EQ(unsupported[1], 0);
}

// Its corners lie in one plane with the sensor.
TEST_F(SurfaceFit, CountsNoBeamOfAFlatTriangle)
{
  const lms3dBeamDemands demands(this->Sphere, this->Patches, 0.2);
  const lms3dTriangleCorner a({ 1.0, 0.0, 0.0 });
  const lms3dTriangleCorner b({ 0.8, 0.6, 0.0 });
  const lms3dTriangleCorner c({ 0.6, 0.8, 0.0 });
  const lms3dTriangleSums sums(demands, { { &a, &b, &c }, { 0.5, 0.5, 0.5 } });
  EXPECT_EQ(sums.GetSum({ 1.0, 1.0, 1.0 }), 0.0);
  EXPECT_EQ(sums.GetLargestShare(0), 0.0);
}

// Vertices that move back leave their neighbours where they fitted together. In one of these scans,
// the second fit would enlarge the sum.
TEST_F(SurfaceFit, NeverEnlargesTheSumOfSquares)
{
  constexpr double Bound = 0.06;
  constexpr int FewBeams = 32;
  const RoundMap map(Radius);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-(Bound - 0.025), Bound - 0.025);
  for (int trial = 0; trial < 60; ++trial)
  {
    const BallScan scan([&](int, int) { return Radius - 0.025 + 0.9 * noise(random); }, FewBeams);
    const lms3dBeamSphere sphere(scan.Grid, scan.Joins);
    lms3dPatches patches;
    patches.Patches.resize(1);
    patches.Labels.assign(sphere.GetSize(), 0);
    const lms3dBeamDemands demands(sphere, patches, Bound);
    const lms3dBorderShortcuts borders(sphere, patches, Bound);
    lms3dVertexStars stars(map.Get());
    const std::vector<std::uint8_t> isChosen(stars.GetNumberOfVertices(), 1);
    for (int fit = 0; fit < 2; ++fit)
    {
      const std::vector<lms3dTriangleSums> sums = GetSums(demands, stars);
      const double before = GetSum(sums, stars);
      lms3dSurfaceFit(demands, borders, Bound, isChosen, stars).Run();
      EXPECT_LE(GetSum(sums, stars), before) << trial;
    }
  }
}

TEST_F(SurfaceFit, MovesOnlyChosenVertices)
{
  const RoundMap map(Radius);
  lms3dVertexStars stars(map.Get());
  std::vector<std::uint8_t> isChosen(stars.GetNumberOfVertices(), 0);
  isChosen[7] = 1;
  this->Fit(0.2, isChosen, stars);
  for (std::int32_t vertex = 0; vertex < stars.GetNumberOfVertices(); ++vertex)
  {
    EXPECT_EQ(stars.GetVertex(vertex).HasMoved, vertex == 7) << vertex;
  }
}

TEST_F(SurfaceFit, HardlyMovesAMapThatFits)
{
  const RoundMap map(Radius);
  lms3dVertexStars stars(map.Get());
  this->FitAll(0.2, stars);
  std::vector<double> inverses;
  for (std::int32_t vertex = 0; vertex < stars.GetNumberOfVertices(); ++vertex)
  {
    inverses.push_back(stars.GetVertex(vertex).Inverse);
  }
  this->FitAll(0.2, stars);
  for (std::int32_t vertex = 0; vertex < stars.GetNumberOfVertices(); ++vertex)
  {
    EXPECT_NEAR(1.0 / stars.GetVertex(vertex).Inverse, 1.0 / inverses[vertex], 0.003) << vertex;
  }
}
