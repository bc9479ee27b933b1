// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Checks that damaged scans have the errors that they promise.
 */
#include "Fixtures/ScanDamage.h"
#include "Fixtures/SceneFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <vtkFieldData.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace
{
constexpr int NumberOfBeams = 181;
constexpr int NumberOfTurns = 360;

vtkSmartPointer<vtkPolyData> ScanBall()
{
  vtkSmartPointer<vtkLMS3DScanFilter> scan = MakeScan(MakeBall(2.0).Get());
  SetGrid(scan, NumberOfBeams, NumberOfTurns);
  scan->ComputeStatusOn();
  scan->Update();
  return scan->GetOutput();
}

double GetShare(const std::vector<bool>& isLost)
{
  return static_cast<double>(std::count(isLost.begin(), isLost.end(), true)) /
    static_cast<double>(isLost.size());
}
} // namespace

TEST(ScanDamage, LosesAShareOfTheBeams)
{
  for (ScanDamage::Shapes shape :
    { ScanDamage::Shapes::SingleBeams, ScanDamage::Shapes::Stripes, ScanDamage::Shapes::Blobs })
  {
    for (double share : { 0.01, 0.05, 0.2 })
    {
      ScanDamage damage;
      damage.Dropouts = share;
      damage.Shape = shape;
      EXPECT_NEAR(GetShare(damage.FindDropouts(1000, 1000)), share, 0.2 * share)
        << damage.Describe();
    }
  }
}

TEST(ScanDamage, ChangesNothingWithoutErrors)
{
  vtkSmartPointer<vtkPolyData> scan = ScanBall();
  vtkSmartPointer<vtkPolyData> same = Damage(scan, {});
  EXPECT_EQ(Hash(same->GetPoints()->GetData()), Hash(scan->GetPoints()->GetData()));
  EXPECT_EQ(
    Hash(same->GetPointData()->GetArray("Range")), Hash(scan->GetPointData()->GetArray("Range")));
}

TEST(ScanDamage, MarksLostBeamsAsTooWeak)
{
  ScanDamage damage;
  damage.Dropouts = 0.1;
  vtkSmartPointer<vtkPolyData> ball = ScanBall();
  vtkSmartPointer<vtkPolyData> scan = Damage(ball, damage);
  const std::vector<bool> isLost = damage.FindDropouts(NumberOfBeams, NumberOfTurns);
  vtkDataArray* status = scan->GetFieldData()->GetArray("Status");
  for (vtkIdType beam = 0; beam < vtkIdType(NumberOfBeams) * NumberOfTurns; ++beam)
  {
    ASSERT_EQ(status->GetTuple1(beam),
      isLost[beam] ? vtkLMS3DScanFilter::TOO_WEAK : vtkLMS3DScanFilter::RETURN);
    ASSERT_EQ(
      ball->GetFieldData()->GetArray("Status")->GetTuple1(beam), vtkLMS3DScanFilter::RETURN);
  }
  EXPECT_EQ(scan->GetNumberOfPoints(), std::count(isLost.begin(), isLost.end(), false));
}

TEST(ScanDamage, HasStraysBeforeTheSurface)
{
  ScanDamage damage;
  damage.Strays = 0.01;
  vtkSmartPointer<vtkPolyData> scan = Damage(ScanBall(), damage);
  vtkDataArray* ranges = scan->GetPointData()->GetArray("Range");
  vtkDataArray* beams = scan->GetPointData()->GetArray("BeamId");
  int strays = 0;
  for (vtkIdType i = 0; i < scan->GetNumberOfPoints(); ++i)
  {
    const bool isStray = damage.IsStray(static_cast<int>(beams->GetTuple1(i)));
    strays += isStray ? 1 : 0;
    if (!isStray)
    {
      ASSERT_NEAR(ranges->GetTuple1(i), 2.0, 0.02);
    }
    else
    {
      ASSERT_GT(ranges->GetTuple1(i), 0.19);
      ASSERT_LE(ranges->GetTuple1(i), 2.0);
    }
  }
  EXPECT_NEAR(strays, 0.01 * NumberOfBeams * NumberOfTurns, 100);
}

// What happens to a beam does not depend on other errors or on other returns.
TEST(ScanDamage, DependsOnSeedAndBeamAlone)
{
  ScanDamage damage;
  damage.Dropouts = 0.05;
  damage.Strays = 0.01;
  damage.Noise = 0.005;
  damage.Steps = 0.01;
  vtkSmartPointer<vtkPolyData> ball = ScanBall();
  vtkSmartPointer<vtkPolyData> scan = Damage(ball, damage);
  const auto isEven = [](vtkIdType i) { return i % 2 == 0; };
  vtkSmartPointer<vtkPolyData> half = Damage(Keep(ball, isEven), damage);
  vtkDataArray* beams = scan->GetPointData()->GetArray("BeamId");
  vtkSmartPointer<vtkPolyData> halfOfScan =
    Keep(scan, [&](vtkIdType i) { return isEven(static_cast<vtkIdType>(beams->GetTuple1(i))); });
  EXPECT_EQ(Hash(half->GetPointData()->GetArray("Range")),
    Hash(halfOfScan->GetPointData()->GetArray("Range")));

  const std::uint64_t before = Hash(scan->GetPointData()->GetArray("Range"));
  EXPECT_EQ(Hash(Damage(ball, damage)->GetPointData()->GetArray("Range")), before);
  damage.Seed = 1;
  EXPECT_NE(Hash(Damage(ball, damage)->GetPointData()->GetArray("Range")), before);
}
