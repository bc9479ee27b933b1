// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A scan that was planned before it runs has the bits of one that was not.
 */
#include "Fixtures/CasterFixtures.h"
#include "Fixtures/SceneFixtures.h"

#include "Scan/lms3dScanPlan.h"
#include "vtkLMS3DScanFilter.h"

#include <vtkImageData.h>

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace
{
constexpr double Alpha[2] = { -90.0, 90.0 };
constexpr double Beta[2] = { 0.0, 360.0 };

const lms3dPose Upright = { { 0.0, 0.0, 0.0 },
  { { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } } };

/// What changes after the threads planned a scan, and before it runs.
struct Change
{
  const char* Name;
  std::function<void(vtkLMS3DScanFilter*)> Apply;
};

const Change Changes[] = {
  { "Nothing", [](vtkLMS3DScanFilter*) {} },
  { "Position", [](vtkLMS3DScanFilter* scan) { scan->SetPosition(0.2, 0.1, -0.3); } },
  { "Orientation", [](vtkLMS3DScanFilter* scan) { scan->SetOrientation(3.0, 4.0, 5.0); } },
  { "Zero",
    [](vtkLMS3DScanFilter* scan)
    {
      // VTK's setters ignore a zero of another sign.
      scan->SetPosition(1.0, 1.0, 1.0);
      scan->SetPosition(-0.0, 0.0, -0.0);
    } },
  { "Resolution", [](vtkLMS3DScanFilter* scan) { SetGrid(scan, 120, 200); } },
  { "SameNumbers", [](vtkLMS3DScanFilter* scan) { scan->SetBetaRange(0.0, 180.0); } },
  { "MaximumRange", [](vtkLMS3DScanFilter* scan) { scan->SetMaximumRange(0.999); } },
  { "MinimumRange", [](vtkLMS3DScanFilter* scan) { scan->SetMinimumRange(0.999); } },
  { "Mounting", [](vtkLMS3DScanFilter* scan) { scan->SetMountingToRolling(); } },
  { "Footprint", [](vtkLMS3DScanFilter* scan) { scan->SetBeamDivergence(0.01); } },
  { "Method", [](vtkLMS3DScanFilter* scan) { scan->SetIntersectionMethodToMollerTrumbore(); } },
  { "Scene", [](vtkLMS3DScanFilter* scan) { scan->SetInputDataObject(MakeBall(1.5, 48)); } },
  { "Threads", [](vtkLMS3DScanFilter* scan) { scan->SetNumberOfThreads(1); } },
};

class EachPlannedChange : public testing::TestWithParam<Change>
{
};

vtkSmartPointer<vtkLMS3DScanFilter> MakeBallScan()
{
  auto scan = MakeScan(MakeBall(1.0, 24));
  SetGrid(scan, 181, 90);
  scan->SetNumberOfThreads(2);
  return scan;
}

void ExpectSameOutputs(vtkLMS3DScanFilter* a, vtkLMS3DScanFilter* b)
{
  EXPECT_GT(a->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(Hash(a->GetOutput()), Hash(b->GetOutput()));
  EXPECT_EQ(Hash(a->GetRangeImage()), Hash(b->GetRangeImage()));
}
} // namespace

TEST_P(EachPlannedChange, LeavesTheScanAsItIsWithoutAPlan)
{
  auto alone = MakeBallScan();
  GetParam().Apply(alone);
  alone->Update();
  // Whether a thread begins a plan in time is a matter of luck.
  for (int i = 0; i < 10; ++i)
  {
    auto planned = MakeBallScan();
    planned->SetPosition(0.01, 0.0, 0.0);
    planned->Update();
    planned->SetPosition(0.0, 0.0, 0.0);
    planned->UpdateInformation();
    GetParam().Apply(planned);
    planned->Update();
    ExpectSameOutputs(planned, alone);
  }
}

INSTANTIATE_TEST_SUITE_P(LMS3DScanFilter, EachPlannedChange, testing::ValuesIn(Changes),
  [](const auto& change) { return change.param.Name; });

TEST(ScanPlan, NeedsNoScanAfterIt)
{
  for (int i = 0; i < 20; ++i)
  {
    auto scan = MakeBallScan();
    scan->Update();
    scan->SetPosition(0.0, 0.1, 0.0);
    scan->UpdateInformation();
  }
}

TEST(ScanPlan, FitsTheBitsOfItsArgumentsAlone)
{
  const auto caster = lms3dRayCaster::New(lms3dRayCaster::EXACT, MakeCube(3));
  const auto twin = lms3dRayCaster::New(lms3dRayCaster::EXACT, MakeCube(3));
  const lms3dScanGeometry geometry(Alpha, 91, Beta, 90);
  const lms3dScanGeometry other(Alpha, 91, Beta, 90);
  const lms3dPose& pose = Upright;
  const lms3dScanPlan plan(*caster, geometry, pose, 80.0);
  EXPECT_TRUE(plan.Fits(*caster, geometry, pose, 80.0));
  EXPECT_FALSE(plan.Fits(*twin, geometry, pose, 80.0));
  EXPECT_FALSE(plan.Fits(*caster, other, pose, 80.0));
  EXPECT_FALSE(plan.Fits(*caster, geometry, pose, 79.0));
  lms3dPose negative = pose;
  negative.Position[1] = -0.0;
  EXPECT_FALSE(plan.Fits(*caster, geometry, negative, 80.0));
  lms3dPose turned = pose;
  turned.Axes[2][0] = 1e-17;
  EXPECT_FALSE(plan.Fits(*caster, geometry, turned, 80.0));
}

TEST(ScanPlan, DoesNotFitWhatTookThePlaceOfItsGeometryOrItsCaster)
{
  auto caster = lms3dRayCaster::New(lms3dRayCaster::EXACT, MakeCube(3));
  std::optional<lms3dScanGeometry> geometry(std::in_place, Alpha, 91, Beta, 90);
  const lms3dScanPlan plan(*caster, *geometry, Upright, 80.0);
  geometry.emplace(Alpha, 91, Beta, 90);
  EXPECT_FALSE(plan.Fits(*caster, *geometry, Upright, 80.0));

  const lms3dScanPlan next(*caster, *geometry, Upright, 80.0);
  for (int i = 0; i < 10; ++i)
  {
    caster = nullptr;
    caster = lms3dRayCaster::New(lms3dRayCaster::EXACT, MakeCube(3));
    EXPECT_FALSE(next.Fits(*caster, *geometry, Upright, 80.0));
  }
}
