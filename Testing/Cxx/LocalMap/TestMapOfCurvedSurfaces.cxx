// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that maps of curved surfaces have few triangles, with and without noise.
 */
#include "LocalMap/MapFixtures.h"

#include <vtkCell.h>

#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace
{
constexpr std::uint64_t Seed = 20090403;

// The triangles of an exact ball of 2 m radius that vtkQuadricDecimation needs for a largest error
// of 1 cm.
constexpr vtkIdType TrianglesOfDecimation = 2012;

/// A ball of 2 m radius around the sensor.
vtkSmartPointer<vtkPolyData> ScanBall()
{
  return MakeScan(
    MakeAngles(-90.0, 90.0, 181), MakeAngles(0.0, 358.0, 180), [](int, int) { return 2.0; });
}

constexpr double ColumnDistance = 2.0;
constexpr double ColumnRadius = 0.5;

/// A round column in front of the sensor. All other beams miss.
vtkSmartPointer<vtkPolyData> ScanColumn()
{
  const std::vector<double> alphas = MakeAngles(-40.0, 40.0, 161);
  const std::vector<double> betas = MakeAngles(-40.0, 40.0, 161);
  return MakeScan(alphas, betas,
    [&](int turn, int number)
    {
      const double azimuth = betas[turn] * std::acos(-1.0) / 180.0;
      const double elevation = alphas[number] * std::acos(-1.0) / 180.0;
      const double across = ColumnDistance * std::sin(azimuth);
      const double square = ColumnRadius * ColumnRadius - across * across;
      return square > 0.0
        ? (ColumnDistance * std::cos(azimuth) - std::sqrt(square)) / std::cos(elevation)
        : 0.0;
    });
}

/// The points of a map at which its surface ends.
std::set<vtkIdType> FindBorderPoints(vtkPolyData* map)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  for (vtkIdType i = 0; i < map->GetNumberOfCells(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const vtkIdType a = map->GetCell(i)->GetPointId(corner);
      const vtkIdType b = map->GetCell(i)->GetPointId((corner + 1) % 3);
      ++edges[{ std::min(a, b), std::max(a, b) }];
    }
  }
  std::set<vtkIdType> points;
  for (const auto& [edge, triangles] : edges)
  {
    if (triangles == 1)
    {
      points.insert({ edge.first, edge.second });
    }
  }
  return points;
}

/// A ball of 0.3 m radius, 1.5 m in front of the sensor, and nothing behind it.
vtkSmartPointer<vtkPolyData> ScanSmallBall()
{
  const std::vector<double> angles = MakeAngles(-30.0, 30.0, 121);
  return MakeScan(angles, angles,
    [&](int turn, int number)
    {
      constexpr double Distance = 1.5;
      constexpr double Radius = 0.3;
      constexpr double Degree = 0.017453292519943295;
      const double ahead = std::cos(angles[turn] * Degree) * std::cos(angles[number] * Degree);
      const double middle = Distance * ahead;
      const double square = middle * middle - Distance * Distance + Radius * Radius;
      return square > 0.0 ? middle - std::sqrt(square) : 0.0;
    });
}
} // namespace

TEST(MapOfCurvedSurfaces, IsAThirdOfADecimatedGrid)
{
  vtkSmartPointer<vtkPolyData> scan = ScanBall();
  vtkSmartPointer<vtkPolyData> map = MakeMap(scan, 0.01);
  EXPECT_LE(3 * map->GetNumberOfCells(), TrianglesOfDecimation);
  ExpectClosed(ExpectLawful(scan, map, { 0.01 }));
}

TEST(MapOfCurvedSurfaces, IsSmallerWithNoise)
{
  Random random(Seed);
  vtkSmartPointer<vtkPolyData> scan = AddNoise(ScanBall(), 0.005, random);
  vtkSmartPointer<vtkPolyData> map = MakeMap(scan, 0.02);
  EXPECT_LE(7 * map->GetNumberOfCells(), 2 * TrianglesOfDecimation);
  ExpectLawful(scan, map, { 0.02, 0.1, nullptr, 0.02 });
}

// All other beams miss it.
TEST(MapOfCurvedSurfaces, IsSmallIfFewBeamsMeetIt)
{
  vtkSmartPointer<vtkPolyData> scan = ScanSmallBall();
  EXPECT_LT(scan->GetNumberOfPoints(), 2000);
  vtkSmartPointer<vtkPolyData> map = MakeMap(scan, 0.001);
  ExpectLawful(scan, map, { 0.001 });
  EXPECT_LT(4 * map->GetNumberOfCells(), MakeMap(scan, 0.0)->GetNumberOfCells());
}

TEST(MapOfCurvedSurfaces, KeepsItsBorders)
{
  vtkSmartPointer<vtkPolyData> scan = ScanColumn();
  vtkSmartPointer<vtkPolyData> map = MakeMap(scan, 0.005);
  EXPECT_GT(map->GetNumberOfCells(), 10);
  ExpectLawful(scan, map, { 0.005 });
}

// Where planes of patches end, vertices at the border take the range of all returns around them.
TEST(MapOfCurvedSurfaces, FitsItsBordersToNoisyReturns)
{
  constexpr double Sigma = 0.01;
  double squares = 0.0;
  std::size_t count = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed)
  {
    Random random(seed);
    vtkSmartPointer<vtkPolyData> map = MakeMap(AddNoise(ScanColumn(), Sigma, random), 4.0 * Sigma);
    const std::set<vtkIdType> border = FindBorderPoints(map);
    for (vtkIdType number : border)
    {
      Vector point;
      map->GetPoint(number, point.data());
      const double error = std::hypot(point[0] - ColumnDistance, point[1]) - ColumnRadius;
      squares += error * error;
    }
    count += border.size();
  }
  EXPECT_GT(count, 100U);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(count)), 1.1 * Sigma);
}

TEST(MapOfCurvedSurfaces, IsTheSameForAnyNumberOfThreads)
{
  Random random(Seed);
  vtkSmartPointer<vtkPolyData> scan = AddNoise(ScanBall(), 0.005, random);
  // More threads than cores.
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 8);
  const std::uint64_t alone = HashMap(MakeMap(scan, 0.02, 1));
  for (int count : { 2, 8 })
  {
    EXPECT_EQ(HashMap(MakeMap(scan, 0.02, count)), alone) << count;
  }
}
