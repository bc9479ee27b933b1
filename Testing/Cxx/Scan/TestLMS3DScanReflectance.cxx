// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which surfaces RangeAtTenPercent hides, in closed form.
 */
#include "Scan/DetectionFixtures.h"

#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace
{
// A range just within the limit, and one just beyond, relative to it.
constexpr double Within = 1.0 - 1e-9;
constexpr double Beyond = 1.0 + 1e-9;

constexpr double MinimumReflectance = 0.018;

// The largest range at which a device that sees 10 percent at 10 m sees a reflectance at right
// angles.
double GetLimit(double reflectance)
{
  return reflectance < MinimumReflectance ? 0.0 : 10.0 * std::sqrt(reflectance / 0.1);
}
} // namespace

TEST(LMS3DScanReflectance, IsOffAndChangesNothing)
{
  auto room = ReadRoom();
  auto plain = MakeScan(room);
  plain->SetPosition(0.3, -0.2, 1.0);
  EXPECT_EQ(plain->GetRangeAtTenPercent(), 0.0);
  EXPECT_EQ(plain->GetReflectanceArray(), nullptr);
  plain->Update();
  // Without an effect that uses it, the array need not exist.
  auto named = MakeScan(room);
  named->SetPosition(0.3, -0.2, 1.0);
  named->SetReflectanceArray("None");
  EXPECT_EQ(UpdateAndGetError(named), "");
  EXPECT_EQ(Hash(named->GetOutput()), Hash(plain->GetOutput()));
  EXPECT_EQ(Hash(named->GetRangeImage()), Hash(plain->GetRangeImage()));
}

TEST(LMS3DScanReflectance, AWallVanishesAtTheRangeThatItsReflectanceAllows)
{
  for (double reflectance : { 0.018, 0.02, 0.05, 0.1, 0.4, 1.0, 1.2, 20.0 })
  {
    const double limit = GetLimit(reflectance);
    for (const auto& [distance, isSeen] : { std::pair(0.01, true), std::pair(Within * limit, true),
           std::pair(Beyond * limit, false), std::pair(100.0 * limit, false) })
    {
      auto scan = MakeBeam(Paint(MakeWall(distance), reflectance));
      SeeTenPercentAtTenMetres(scan);
      EXPECT_EQ(HasReturn(scan), isSeen) << reflectance << " at " << distance << " m";
    }
  }
}

TEST(LMS3DScanReflectance, RangeAtTenPercentScalesAllRanges)
{
  for (double atTenPercent : { 0.5, 10.0, 30.0, 1e6 })
  {
    for (const auto& [factor, isSeen] : { std::pair(Within, true), std::pair(Beyond, false) })
    {
      auto scan = MakeBeam(Paint(MakeWall(2.0 * factor * atTenPercent), 0.4));
      SeeTenPercentAtTenMetres(scan);
      scan->SetRangeAtTenPercent(atTenPercent);
      EXPECT_EQ(HasReturn(scan), isSeen) << atTenPercent;
    }
  }
}

TEST(LMS3DScanReflectance, BelowTheMinimumNothingIsSeenAtAnyRange)
{
  for (double distance : { 1e-3, 1.0, 5.0 })
  {
    for (double reflectance : { 0.0, 1e-300, 0.01, Within * MinimumReflectance })
    {
      auto scan = MakeBeam(Paint(MakeWall(distance), reflectance));
      EXPECT_TRUE(HasReturn(scan));
      SeeTenPercentAtTenMetres(scan);
      EXPECT_FALSE(HasReturn(scan)) << reflectance;
    }
  }
}

TEST(LMS3DScanReflectance, ASlantedWallVanishesByTheCosineOfItsIncidence)
{
  constexpr double Reflectance = 0.8;
  for (double degrees : { -75.0, -30.0, 5.0, 45.0, 60.0, 80.0, 88.0 })
  {
    const double limit = GetLimit(Reflectance * std::cos(vtkMath::RadiansFromDegrees(degrees)));
    for (const auto& [factor, isSeen] : { std::pair(Within, true), std::pair(Beyond, false) })
    {
      auto scan = MakeBeam(Paint(MakeWall(factor * limit, degrees), Reflectance));
      SeeTenPercentAtTenMetres(scan);
      EXPECT_EQ(HasReturn(scan), isSeen) << degrees << " degrees";
    }
  }
  // A cosine below the minimum.
  auto scan = MakeBeam(Paint(MakeWall(1.0, 89.0), 1.0));
  SeeTenPercentAtTenMetres(scan);
  EXPECT_FALSE(HasReturn(scan));
}

TEST(LMS3DScanReflectance, BothSidesOfASurfaceCount)
{
  auto wall = MakeWall(11.0, 30.0);
  for (bool isReversed : { false, true })
  {
    if (isReversed)
    {
      wall->ReverseCell(0);
    }
    auto scan = MakeBeam(Paint(wall, 0.15));
    SeeTenPercentAtTenMetres(scan);
    EXPECT_TRUE(HasReturn(scan));
    scan->SetRangeAtTenPercent(9.0);
    EXPECT_FALSE(HasReturn(scan));
  }
}

TEST(LMS3DScanReflectance, AFloorEndsOnACircle)
{
  constexpr double Height = 1.5;
  // The first floor ends by its range, the second by its incidence.
  for (double reflectance : { 0.5, 0.05 })
  {
    // At the range R, the cosine is Height / R: rho Height / R against 0.1 (R / 10)^2, and 0.018.
    const double limit = std::min(
      std::cbrt(reflectance * Height * 100.0 / 0.1), reflectance * Height / MinimumReflectance);
    auto scan = MakeScan(Paint(MakeFloor(1000.0, -Height), reflectance));
    scan->SetAlphaRange(-90.0, -1.0);
    SetGrid(scan, 357, 30);
    scan->SetMaximumRange(std::numeric_limits<double>::infinity());
    ASSERT_TRUE(HasReturn(scan));
    vtkIdType expected = 0;
    const vtkIdType all = scan->GetOutput()->GetNumberOfPoints();
    ASSERT_EQ(all, 357 * 30);
    for (vtkIdType i = 0; i < all; ++i)
    {
      ASSERT_GT(std::abs(GetRange(scan, i) - limit), 1e-6);
      expected += GetRange(scan, i) < limit ? 1 : 0;
    }
    SeeTenPercentAtTenMetres(scan);
    ASSERT_TRUE(HasReturn(scan));
    ASSERT_EQ(scan->GetOutput()->GetNumberOfPoints(), expected);
    ASSERT_LT(expected, all);
    for (vtkIdType i = 0; i < expected; ++i)
    {
      ASSERT_LT(GetRange(scan, i), limit);
    }
  }
}

TEST(LMS3DScanReflectance, AWeakSurfaceHidesWhatLiesBehind)
{
  auto scene = Join(MakeWall(2.0), MakeWall(4.0));
  SetReflectances(scene, { 0.0, 1.0 });
  auto scan = MakeBeam(scene);
  SeeTenPercentAtTenMetres(scan);
  EXPECT_FALSE(HasReturn(scan));
  SetReflectances(scene, { 1.0, 0.0 });
  EXPECT_TRUE(HasReturn(scan));
  EXPECT_EQ(GetRange(scan, 0), 2.0);
}

TEST(LMS3DScanReflectance, WithoutAnArrayAllSurfacesReflectAllLight)
{
  for (const auto& [factor, isSeen] : { std::pair(Within, true), std::pair(Beyond, false) })
  {
    auto scan = MakeBeam(MakeWall(factor * GetLimit(1.0)));
    SeeTenPercentAtTenMetres(scan);
    scan->SetReflectanceArray(nullptr);
    EXPECT_EQ(HasReturn(scan), isSeen);
  }
}

TEST(LMS3DScanReflectance, RemovesReturnsAndChangesNoOther)
{
  for (int method = 0; method < vtkLMS3DScanFilter::GetNumberOfIntersectionMethods(); ++method)
  {
    auto room = ReadRoom();
    auto plain = MakeScan(room);
    auto weak = MakeScan(room);
    for (vtkLMS3DScanFilter* scan : { plain.Get(), weak.Get() })
    {
      scan->SetPosition(0.3, -0.2, 1.0);
      scan->SetIntersectionMethod(method);
      scan->SurfaceAttributesOn();
      scan->ComputeIntensityOn();
      scan->SetReflectanceArray("Color");
      SetGrid(scan, 31, 30);
    }
    constexpr double AtTenPercent = 2.0;
    weak->SetRangeAtTenPercent(AtTenPercent);
    ASSERT_TRUE(HasReturn(plain));
    ASSERT_TRUE(HasReturn(weak));
    vtkIdType next = 0;
    for (vtkIdType i = 0; i < plain->GetOutput()->GetNumberOfPoints(); ++i)
    {
      const double needed =
        std::max(MinimumReflectance, 0.1 * std::pow(GetRange(plain, i) / AtTenPercent, 2));
      const double intensity = GetArray(plain, "Intensity")->GetTuple1(i);
      // The array is in single precision.
      ASSERT_GT(std::abs(intensity - needed), 1e-7 * needed);
      if (intensity < needed)
      {
        continue;
      }
      for (const char* name : { "BeamId", "Range", "CellId", "ShapeId", "Incidence" })
      {
        ASSERT_EQ(GetArray(weak, name)->GetTuple1(next), GetArray(plain, name)->GetTuple1(i));
      }
      ++next;
    }
    EXPECT_EQ(weak->GetOutput()->GetNumberOfPoints(), next);
    EXPECT_LT(next, plain->GetOutput()->GetNumberOfPoints());
    EXPECT_GT(next, 0);
  }
}

TEST(LMS3DScanReflectance, IsTheSameBitsForAnyNumberOfThreads)
{
  auto scan = MakeScan(ReadRoom());
  scan->SetPosition(0.3, -0.2, 1.0);
  scan->SetMaximumRange(4.0);
  scan->SetRangeAtTenPercent(2.5);
  scan->SetReflectanceArray("Color");
  scan->ComputeIncidenceOn();
  scan->ComputeIntensityOn();
  scan->ComputeStatusOn();
  scan->SetNumberOfThreads(1);
  ASSERT_TRUE(HasReturn(scan));
  const std::uint64_t points = Hash(scan->GetOutput());
  const std::uint64_t image = Hash(scan->GetRangeImage());
  for (int threads : { 2, 3, 8 })
  {
    scan->SetNumberOfThreads(threads);
    scan->Update();
    EXPECT_EQ(Hash(scan->GetOutput()), points) << threads << " threads";
    EXPECT_EQ(Hash(scan->GetRangeImage()), image) << threads << " threads";
  }
}
