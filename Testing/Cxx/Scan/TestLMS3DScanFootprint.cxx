// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vtkLMS3DScanFilter with beams that have a width.
 */
#include "Scan/DeviceFixtures.h"

#include <vtkImageData.h>
#include <vtkMath.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
constexpr double Wall = 4.0;
constexpr double Diameter = 0.012;
constexpr double Divergence = 0.0044;
constexpr double RadiusAtWall = 0.5 * (Diameter + Divergence * Wall);

/// A plate at x = `distance` on the side of an edge. The edge is `offset` from the x axis, across
/// the direction `turn` (degrees from y to z).
vtkSmartPointer<vtkPolyData> MakePlate(double distance, double offset, double turn)
{
  const double c = std::cos(vtkMath::RadiansFromDegrees(turn));
  const double s = std::sin(vtkMath::RadiansFromDegrees(turn));
  const auto at = [&](double across, double along) -> Point {
    return { distance, across * c - along * s, across * s + along * c };
  };
  return MakePolygon({ at(offset, -5), at(10, -5), at(10, 5), at(offset, 5) });
}

vtkSmartPointer<vtkPolyData> MakeWall(double distance)
{
  return MakePlate(distance, -10.0, 0.0);
}

/// A beam along x.
vtkSmartPointer<vtkLMS3DScanFilter> MakeWideBeam(vtkPolyData* scene, int samples)
{
  auto scan = MakeScan(scene);
  scan->SetAlphaRange(0.0, 0.0);
  SetGrid(scan, 1, 1);
  scan->SetBeamDiameter(Diameter);
  scan->SetBeamDivergence(Divergence);
  scan->SetBeamSamples(samples);
  return scan;
}

double UpdateAndGetRange(vtkLMS3DScanFilter* scan)
{
  scan->Update();
  return scan->GetRangeImage()->GetScalarComponentAsDouble(0, 0, 0, 0);
}

double GetSegmentArea(double distance)
{
  const double d = std::max(-1.0, std::min(1.0, distance));
  return (std::acos(d) - d * std::sqrt(1.0 - d * d)) / vtkMath::Pi();
}
} // namespace

TEST(LMS3DScanFootprint, LeavesAWallAtRightAnglesAsItIs)
{
  auto wall = MakeWall(Wall);
  for (int samples : { 1, 7, 19, 37, 100 })
  {
    EXPECT_NEAR(UpdateAndGetRange(MakeWideBeam(wall, samples)), Wall, 1e-12) << samples;
  }
}

TEST(LMS3DScanFootprint, LeavesAWallAtTheMaximumRangeAsItIs)
{
  for (double distance : { 4.0, 0.1, 1.0 / 3.0, 7.7 })
  {
    auto scan = MakeWideBeam(MakeWall(distance), 19);
    scan->SetMaximumRange(distance);
    scan->SetMinimumRange(distance * (1.0 - 1e-12));
    EXPECT_NEAR(UpdateAndGetRange(scan), distance, 1e-12);
    scan->SetMaximumRange(distance * (1.0 - 1e-9));
    scan->SetMinimumRange(0.0);
    EXPECT_TRUE(std::isnan(UpdateAndGetRange(scan)));
  }
}

TEST(LMS3DScanFootprint, MixesBothSidesOfAnEdgeByTheirAreas)
{
  const double step = 0.5;
  auto far = MakeWall(Wall + step);
  for (int samples : { 7, 19, 37 })
  {
    const double bound = 0.55 / std::sqrt(samples);
    for (double turn : { 0.0, 90.0, 30.0, 200.0 })
    {
      for (int tenths = -12; tenths < 12; ++tenths)
      {
        const double share = 0.1 * tenths;
        auto scan = MakeWideBeam(Join(MakePlate(Wall, share * RadiusAtWall, turn), far), samples);
        const double range = UpdateAndGetRange(scan);
        const double near = 1.0 - (range - Wall) / step;
        EXPECT_NEAR(near, GetSegmentArea(share), bound) << samples << ' ' << turn << ' ' << share;
        // A whole number of rays.
        EXPECT_NEAR(near * samples, std::round(near * samples), 1e-9);
      }
    }
  }
}

TEST(LMS3DScanFootprint, ReportsOneSideOfADeepStep)
{
  for (double step : { 1.1, 2.0, 5.0 })
  {
    auto far = MakeWall(Wall + step);
    for (int tenths = -12; tenths < 12; ++tenths)
    {
      const double share = 0.1 * tenths;
      auto scan = MakeWideBeam(Join(MakePlate(Wall, share * RadiusAtWall, 30.0), far), 37);
      const double range = UpdateAndGetRange(scan);
      const bool isNear = std::abs(range - Wall) < 1e-12;
      EXPECT_TRUE(isNear || std::abs(range - (Wall + step)) < 1e-12) << range;
      if (std::abs(share) > 0.2)
      {
        EXPECT_EQ(isNear, share < 0.0) << share;
      }
    }
  }
}

TEST(LMS3DScanFootprint, APulseSetsWhatIsMixed)
{
  auto scan = MakeWideBeam(Join(MakePlate(Wall, 0.0, 45.0), MakeWall(Wall + 0.3)), 19);
  EXPECT_GT(UpdateAndGetRange(scan), Wall + 0.1);
  EXPECT_LT(UpdateAndGetRange(scan), Wall + 0.2);
  scan->SetPulseLength(0.29);
  const double range = UpdateAndGetRange(scan);
  EXPECT_TRUE(std::abs(range - Wall) < 1e-12 || std::abs(range - Wall - 0.3) < 1e-12);
}

TEST(LMS3DScanFootprint, RaysWithoutAReturnAreNoPart)
{
  for (double share : { -0.9, -0.5, 0.0, 0.5, 0.8 })
  {
    auto scan = MakeWideBeam(MakePlate(Wall, share * RadiusAtWall, 0.0), 37);
    EXPECT_NEAR(UpdateAndGetRange(scan), Wall, 1e-12) << share;
  }
  EXPECT_TRUE(
    std::isnan(UpdateAndGetRange(MakeWideBeam(MakePlate(Wall, 1.1 * RadiusAtWall, 0.0), 37))));
}

TEST(LMS3DScanFootprint, NamesTheCellNearestToTheAxis)
{
  // The axis itself meets the wall.
  auto scene = Join(MakePlate(Wall, 0.1 * RadiusAtWall, 0.0), MakeWall(Wall + 0.5));
  auto scan = MakeWideBeam(scene, 37);
  scan->Update();
  EXPECT_EQ(GetArray(scan, "CellId")->GetTuple1(0), 1.0);
  scan->SetPulseLength(0.0);
  scan->Update();
  EXPECT_EQ(GetArray(scan, "CellId")->GetTuple1(0), 1.0);
  scan->SetInputDataObject(Join(MakePlate(Wall, -0.1 * RadiusAtWall, 0.0), MakeWall(Wall + 0.5)));
  scan->Update();
  EXPECT_EQ(GetArray(scan, "CellId")->GetTuple1(0), 0.0);
}

TEST(LMS3DScanFootprint, LimitsHoldForTheReportedRange)
{
  auto scan = MakeWideBeam(Join(MakePlate(Wall, 0.0, 45.0), MakeWall(Wall + 0.5)), 19);
  const double mixed = UpdateAndGetRange(scan);
  scan->SetMinimumRange(mixed - 0.01);
  EXPECT_EQ(UpdateAndGetRange(scan), mixed);
  scan->SetMinimumRange(mixed + 0.01);
  EXPECT_TRUE(std::isnan(UpdateAndGetRange(scan)));
  EXPECT_EQ(scan->GetOutput()->GetNumberOfPoints(), 0);
  // Rays beyond the maximum are no part.
  scan->SetMinimumRange(0.0);
  scan->SetMaximumRange(Wall + 0.4);
  EXPECT_NEAR(UpdateAndGetRange(scan), Wall, 1e-12);
}

TEST(LMS3DScanFootprint, WithoutWidthOrSamplesChangesNoBit)
{
  auto scan = MakeScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  SetGrid(scan, 91, 90);
  scan->Update();
  const std::uint64_t ideal = HashOutputs(scan);
  scan->SetBeamSamples(37);
  scan->Update();
  EXPECT_EQ(HashOutputs(scan), ideal);
  scan->SetBeamSamples(1);
  scan->SetBeamDiameter(Diameter);
  scan->SetBeamDivergence(Divergence);
  scan->Update();
  EXPECT_EQ(HashOutputs(scan), ideal);
  scan->SetBeamSamples(7);
  scan->Update();
  EXPECT_NE(HashOutputs(scan), ideal);
}

// The ray along the axis is the beam itself.
TEST(LMS3DScanFootprint, HasTheBeamItselfAmongItsRays)
{
  auto scan = MakeScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  SetGrid(scan, 91, 90);
  scan->Update();
  const std::vector<double> ideal = GetValues(scan, "Range");
  scan->SetBeamDiameter(1e-15);
  scan->SetBeamSamples(7);
  scan->Update();
  const std::vector<double> wide = GetValues(scan, "Range");
  ASSERT_EQ(wide.size(), ideal.size());
  for (std::size_t i = 0; i < wide.size(); ++i)
  {
    EXPECT_NEAR(wide[i], ideal[i], 1e-9);
  }
}
