// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Checks that patches grow over joined returns only, and that merged planes explain their returns.
 */
#include "LocalMap/Patches/lms3dPatchGrower.h"
#include "LocalMap/Patches/lms3dPatchMerger.h"
#include "LocalMap/SurfaceFitMaps.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace
{
using GridIndex = lms3dBeamSphere::GridIndex;

constexpr double Radius = BallScan::Radius;
constexpr int Beams = BallScan::Beams;
constexpr int Turns = BallScan::Turns;
/// Far more than the steps of the balls, metres.
constexpr double LargeTolerance = 0.8;

/// A ball without returns at its poles. `getRange` takes the row and the column.
struct Ball
{
  explicit Ball(const std::function<double(int, int)>& getRange)
    : Scan([&](int beam, int turn)
        { return beam == 0 || beam == Beams - 1 ? 0.0 : getRange(beam, turn); })
    , Sphere(this->Scan.Grid, this->Scan.Joins)
  {
  }

  const BallScan Scan;
  const lms3dBeamSphere Sphere;
};

/// Expects that no patch has returns both nearer and farther than a range, metres.
void ExpectApart(const Ball& ball, double range)
{
  const lms3dPatches patches = lms3dPatchGrower(ball.Sphere, LargeTolerance).Grow();
  std::vector<int> near(patches.Patches.size());
  std::vector<int> far(patches.Patches.size());
  for (GridIndex index = 0; index < ball.Sphere.GetSize(); ++index)
  {
    if (ball.Sphere.HasReturn(index))
    {
      ++(ball.Sphere.GetRange(index) < range ? near : far)[patches.Labels[index]];
    }
  }
  for (std::size_t patch = 0; patch < near.size(); ++patch)
  {
    EXPECT_TRUE(near[patch] == 0 || far[patch] == 0) << patch;
  }
}
} // namespace

TEST(PatchGrower, DoesNotPassDepthSteps)
{
  const double far = Radius + 0.4;
  ExpectApart(Ball([=](int row, int) { return row < Beams / 2 ? Radius : far; }), Radius + 0.2);
  ExpectApart(
    Ball([=](int, int column) { return column < Turns / 2 ? Radius : far; }), Radius + 0.2);
  ExpectApart(
    Ball([=](int row, int column) { return (row + column) / 20 % 2 == 0 ? Radius : far; }),
    Radius + 0.2);
}

// A step that grows along the turns. Where it begins, a patch can pass around its end.
TEST(PatchGrower, HasSpansOfJoinedReturns)
{
  const Ball ball([](int row, int column)
    { return row < Beams / 2 || column > 45 ? Radius : Radius + 0.007 * column; });
  const lms3dPatches patches = lms3dPatchGrower(ball.Sphere, LargeTolerance).Grow();
  std::vector<std::int32_t> found(ball.Sphere.GetSize(), lms3dPatches::None);
  int passed = 0;
  for (std::size_t patch = 0; patch < patches.Patches.size(); ++patch)
  {
    for (const lms3dPatches::Span& span : patches.Patches[patch].Spans)
    {
      EXPECT_EQ(ball.Sphere.GetColumn(span.First), ball.Sphere.GetColumn(span.Last));
      for (GridIndex index = span.First; index <= span.Last; ++index)
      {
        EXPECT_EQ(found[index], lms3dPatches::None) << index;
        found[index] = static_cast<std::int32_t>(patch);
        EXPECT_TRUE(index == span.Last || ball.Sphere.IsJoined(index, lms3dBeamSphere::Up))
          << index;
      }
    }
  }
  for (GridIndex index = 0; index < ball.Sphere.GetSize(); ++index)
  {
    EXPECT_EQ(patches.Labels[index], found[index]) << index;
    const bool isPassed = ball.Sphere.HasNeighbor(index, lms3dBeamSphere::Up) &&
      ball.Sphere.HasReturn(index) && patches.Labels[index] == patches.Labels[index + 1] &&
      !ball.Sphere.IsJoined(index, lms3dBeamSphere::Up);
    passed += isPassed ? 1 : 0;
  }
  EXPECT_GT(passed, 5);
}

TEST(PatchMerger, KeepsReturnsWithinTheToleranceOfTheirPlane)
{
  constexpr double Bound = 0.05;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> error(-0.01, 0.01);
  const Ball ball([&](int, int) { return Radius + error(random); });
  lms3dPatches patches = lms3dPatchGrower(ball.Sphere, 0.5 * Bound).Grow();
  const std::vector<lms3dPatches::Patch> before = patches.Patches;
  lms3dPatchMerger(ball.Sphere, patches, Bound).Merge();
  int merged = 0;
  int kept = 0;
  for (std::size_t patch = 0; patch < before.size(); ++patch)
  {
    ++(patches.Patches[patch].Spans.empty() ? merged : kept);
  }
  EXPECT_GT(merged, 20);
  EXPECT_GT(kept, 20);
  for (GridIndex index = 0; index < ball.Sphere.GetSize(); ++index)
  {
    if (ball.Sphere.HasReturn(index))
    {
      const lms3dPlane& plane = patches.Patches[patches.Labels[index]].Plane;
      EXPECT_TRUE(lms3dIsWithinTolerance(ball.Sphere.GetRange(index),
        plane.GetInverseRange(ball.Sphere.GetDirection(index)),
        lms3dPatches::MergedShare * Bound + 1e-9))
        << index;
    }
  }
}
