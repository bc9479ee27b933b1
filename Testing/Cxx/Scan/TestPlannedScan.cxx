// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief When a scan is planned before it runs, that the run uses the plan, and that the results
 * have the bits of a scan without one.
 */
#include "Fixtures/CasterFixtures.h"
#include "Fixtures/SceneFixtures.h"

#include "Scan/lms3dScanJob.h"
#include "Scan/lms3dScanOutput.h"
#include "Scan/lms3dScanner.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>

#include <tbb/info.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr double Alpha[2] = { -90.0, 90.0 };
constexpr double Beta[2] = { 0.0, 360.0 };
constexpr double Maximum = 80.0;

bool GoOn(double)
{
  return true;
}

lms3dPose MakePose(double x, double y, double z)
{
  const double position[3] = { x, y, z };
  const double orientation[3] = { 3.0, 4.0, 5.0 };
  return lms3dPose::FromOrientation(position, orientation);
}

/// The results of a scan.
struct Hits
{
  Hits(const lms3dRayCaster& caster, const lms3dScanGeometry& geometry, const lms3dPose& pose,
    const lms3dScanPlan* plan)
    : Ranges(geometry.CountBeamsOfAllTurns())
    , Triangles(this->Ranges.size())
  {
    EXPECT_TRUE(
      lms3dScan({ caster, geometry, pose, { 0.0, Maximum },
                  { this->Ranges.data(), this->Triangles.data() }, { nullptr, nullptr }, plan },
        GoOn));
  }

  std::vector<double> Ranges;
  std::vector<std::int32_t> Triangles;
};

void ExpectSameBits(
  int method, const lms3dTriangleMesh& mesh, const lms3dPose& pose, lms3dMounting mounting)
{
  const auto caster = lms3dRayCaster::New(method, mesh);
  const lms3dScanGeometry geometry(Alpha, 91, Beta, 90, { mounting });
  const lms3dScanPlan plan(*caster, geometry, pose, Maximum);
  const Hits planned(*caster, geometry, pose, &plan);
  const Hits alone(*caster, geometry, pose, nullptr);
  const std::size_t bytes = alone.Ranges.size() * sizeof(double);
  EXPECT_EQ(std::memcmp(planned.Ranges.data(), alone.Ranges.data(), bytes), 0);
  EXPECT_EQ(planned.Triangles, alone.Triangles);
}

/// Counts how often a scan of it is planned.
class CountingCaster final : public lms3dRayCaster
{
public:
  CountingCaster()
    : lms3dRayCaster(MakeCube(3))
    , Inner(New(MOLLER_TRUMBORE, MakeCube(3)))
  {
  }

  void FindNearest(const lms3dRayOrigin& origin, lms3dBeamPacket* packets, int count) const override
  {
    this->Inner->FindNearest(origin, packets, count);
  }

  std::unique_ptr<lms3dGridCaster> NewGridCaster(
    const lms3dRayOrigin& origin, const lms3dBeamGrid& grid) const override
  {
    ++this->Count;
    return this->Inner->NewGridCaster(origin, grid);
  }

  mutable int Count = 0;

private:
  std::unique_ptr<lms3dRayCaster> Inner;
};

/// A job that scanned a ball.
class PlannedJob : public testing::Test
{
protected:
  void SetUp() override
  {
    if (tbb::info::default_concurrency() < 2)
    {
      GTEST_SKIP() << "one core: no other thread to plan";
    }
    this->Run();
  }

  void Run()
  {
    vtkNew<vtkDoubleArray> ranges;
    EXPECT_TRUE(this->Job.CastRanges({ this->Settings, nullptr, this->Ball, nullptr, std::nullopt,
                                       nullptr, GoOn, [](const std::string&) {} },
      ranges, nullptr));
  }

  bool IsPlanned(const lms3dScanSettings& settings, bool canPlan = true)
  {
    this->Job.Wake(settings, canPlan);
    return this->Job.HasPlan();
  }

  vtkSmartPointer<vtkPolyData> Ball = MakeBall(1.0, 24);
  lms3dScanSettings Settings = { { 0.1, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { -90.0, 90.0 }, 91,
    { 0.0, 360.0 }, 90, { 0.0, Maximum }, lms3dRayCaster::EXACT, 2, false, {} };
  lms3dScanJob Job;
};
} // namespace

TEST(PlannedScan, HasTheBitsOfOneWithoutAPlan)
{
  const lms3dPose inside = MakePose(0.1, -0.2, 0.3);
  const std::pair<lms3dTriangleMesh, lms3dPose> scenes[] = { { MakeCube(3), inside },
    { MakeMesh(ReadRoom()), MakePose(0.5, 0.3, 1.0) }, { MakeIcosphere(5), inside },
    { MakeBlocks(), MakePose(0.0, 0.0, 20.0) }, { MakeMesh(MakeFloor(30.0, -1.0)), inside } };
  for (const auto& [mesh, pose] : scenes)
  {
    for (int method : { lms3dRayCaster::EXACT, lms3dRayCaster::FAST })
    {
      SCOPED_TRACE(testing::Message() << mesh.Triangles.size() << " triangles, method " << method);
      ExpectSameBits(method, mesh, pose, lms3dMounting::Yawing);
      ExpectSameBits(method, mesh, pose, lms3dMounting::Rolling);
    }
  }
}

TEST(PlannedScan, UsesThePlanOnceMadeUntilItIsDiscarded)
{
  const CountingCaster caster;
  const lms3dScanGeometry geometry(Alpha, 31, Beta, 30);
  const lms3dPose pose = MakePose(0.1, -0.2, 0.3);
  lms3dScanOutput output;
  const auto cast = [&](double maximum) {
    EXPECT_TRUE(output.Cast(caster, geometry, pose, { 0.0, maximum }, GoOn));
  };
  output.MakePlan(caster, geometry, pose, Maximum);
  output.MakePlan(caster, geometry, pose, Maximum);
  cast(Maximum);
  EXPECT_EQ(caster.Count, 1);
  cast(79.0);
  EXPECT_EQ(caster.Count, 2);
  output.DiscardPlan();
  cast(Maximum);
  EXPECT_EQ(caster.Count, 3);
  output.MakePlan(caster, geometry, pose, Maximum);
  output.Discard();
  cast(Maximum);
  EXPECT_EQ(caster.Count, 5);
}

TEST_F(PlannedJob, PlansFromAnyPoseUntilItRuns)
{
  EXPECT_FALSE(this->Job.HasPlan());
  EXPECT_TRUE(this->IsPlanned(this->Settings));
  this->Settings.Position[0] = 0.2;
  EXPECT_TRUE(this->IsPlanned(this->Settings));
  EXPECT_TRUE(this->IsPlanned(this->Settings));
  this->Run();
  EXPECT_FALSE(this->Job.HasPlan());
  EXPECT_TRUE(this->IsPlanned(this->Settings));
  EXPECT_FALSE(this->IsPlanned(this->Settings, false));
}

TEST_F(PlannedJob, PlansNothingThatTheLastRunDidNotPrepare)
{
  lms3dScanSettings method = this->Settings;
  method.Method = lms3dRayCaster::MOLLER_TRUMBORE;
  EXPECT_FALSE(this->IsPlanned(method));
  lms3dScanSettings angles = this->Settings;
  angles.AlphaResolution = 90;
  EXPECT_FALSE(this->IsPlanned(angles));
  lms3dScanSettings offset = this->Settings;
  offset.Device.Platform.AxisOffset[0] = 0.1;
  EXPECT_FALSE(this->IsPlanned(offset));
  lms3dScanSettings wide = this->Settings;
  wide.Device.Footprint = { 0.0, 0.01, 4 };
  EXPECT_FALSE(this->IsPlanned(wide));
  lms3dScanSettings bad = this->Settings;
  bad.Limits.Maximum = -1.0;
  EXPECT_FALSE(this->IsPlanned(bad));
  EXPECT_FALSE(lms3dScanJob().HasPlan());
}

TEST_F(PlannedJob, LeavesAPlanForOtherSettings)
{
  lms3dScanSettings method = this->Settings;
  method.Method = lms3dRayCaster::MOLLER_TRUMBORE;
  this->Job.Wake(this->Settings, true);
  EXPECT_FALSE(this->IsPlanned(method));
}
