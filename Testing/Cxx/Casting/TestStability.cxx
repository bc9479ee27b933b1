// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The stability suite, as a test: what the header of vtkLMS3DScanFilter says of each method,
 * in each situation of Documentation/charts/C-stability.csv.
 */
#include "Fixtures/CasterFixtures.h"
#include "StabilityMethod.h"
#include "StabilitySituations.h"
#include "StabilityTruth.h"

#include "vtkLMS3DScanFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace
{
using Scan = vtkLMS3DScanFilter;

constexpr std::size_t Shots = std::max<std::size_t>(4, 60 / Fewer);

/// Where a method fails, as its documentation says, and in what share of the beams. Where nothing
/// is said it never does.
struct Weakness
{
  int Method;
  std::string Situation;
  std::string Parameter;
  double Least;
  double Most;
};

const std::vector<Weakness>& GetWeaknesses()
{
  static const std::vector<Weakness> weaknesses = {
    // The wrong side of an edge, up to 1e-6 of the scene's size beside it.
    { Scan::FAST, "beside an edge", "1e-8", 0.6, 1.0 },
    { Scan::FAST, "beside an edge", "1e-10", 0.6, 1.0 },
    { Scan::FAST, "within an edge", "-1e-8", 0.05, 0.4 },
    { Scan::FAST, "within an edge", "-1e-10", 0.05, 0.4 },
    { Scan::FAST, "common grid", "blocks", 0.03, 0.3 },
    { Scan::FAST, "grazing angle", "1e-4", 0.0, 0.01 },
    { Scan::FAST, "grazing angle", "1e-6", 0.0, 0.1 },
    { Scan::FAST, "grazing angle", "1e-8", 0.0, 0.1 },
    { Scan::FAST, "nested shells", "1e-2", 0.0, 0.005 },
    // What it sees through the face that it stands on.
    { Scan::FAST, "on a surface", "face", 0.4, 0.6 },
    { Scan::FAST, "on a surface", "edge", 0.25, 0.5 },
    { Scan::FAST, "on a surface", "vertex", 0.2, 0.5 },
    // Its tolerance, 1e-7 of the triangle's size.
    { Scan::ANGLE_SUM, "beside an edge", "1e-8", 1.0, 1.0 },
    { Scan::ANGLE_SUM, "beside an edge", "1e-10", 1.0, 1.0 },
    { Scan::ANGLE_SUM, "far targets", "1e9", 0.0, 0.01 },
    // One in ten or fifteen of the beams at edges and vertices.
    { Scan::MOLLER_TRUMBORE, "shared edges", "ball", 0.04, 0.13 },
    { Scan::MOLLER_TRUMBORE, "shared vertices", "ball", 0.03, 0.12 },
    { Scan::MOLLER_TRUMBORE, "slivers", "", 0.02, 0.12 },
    { Scan::MOLLER_TRUMBORE, "T-junction", "", 0.0, 0.06 },
    { Scan::MOLLER_TRUMBORE, "offset", "", 0.02, 0.12 },
    { Scan::MOLLER_TRUMBORE, "scale", "", 0.02, 0.12 },
    { Scan::MOLLER_TRUMBORE, "denormals", "", 0.02, 0.12 },
    { Scan::MOLLER_TRUMBORE, "nested shells", "", 0.02, 0.12 },
    { Scan::MOLLER_TRUMBORE, "far targets", "1e9", 0.0, 0.01 },
    // Its tolerance, 1e-9 m.
    { Scan::STATIC_CELL_LOCATOR, "beside an edge", "1e-10", 1.0, 1.0 },
    { Scan::STATIC_CELL_LOCATOR, "common grid", "blocks", 0.0, 0.01 },
    { Scan::STATIC_CELL_LOCATOR, "offset", "1e7", 0.0, 0.03 },
    { Scan::STATIC_CELL_LOCATOR, "scale", "1e7", 0.005, 0.05 },
    { Scan::STATIC_CELL_LOCATOR, "denormals", "", 0.3, 1.0 },
    { Scan::STATIC_CELL_LOCATOR, "far targets", "1e9", 0.0, 0.01 },
  };
  return weaknesses;
}

// Below 1e-100 m products of coordinates are too small for double, and beams may be lost.
bool IsBeyondDouble(const StabilitySituation& situation)
{
  return situation.Parameter == "1e-120" || situation.Parameter == "1e-310";
}

void Check(int method, const StabilitySituation& situation, const StabilityTally& tally)
{
  const auto& weaknesses = GetWeaknesses();
  const auto known = std::find_if(weaknesses.begin(), weaknesses.end(),
    [&](const Weakness& weakness)
    {
      return weakness.Method == method && weakness.Situation == situation.Name &&
        (weakness.Parameter.empty() || weakness.Parameter == situation.Parameter);
    });
  if (known == weaknesses.end())
  {
    EXPECT_EQ(tally.Missed, 0u);
    EXPECT_EQ(tally.False, 0u);
    EXPECT_EQ(tally.Wrong, 0u);
    return;
  }
  // A share needs more beams.
  if (Fewer == 1)
  {
    EXPECT_GE(tally.GetShare(), known->Least);
    EXPECT_LE(tally.GetShare(), known->Most);
  }
}

class Stability : public testing::TestWithParam<int>
{
};
} // namespace

TEST_P(Stability, IsThatOfTheDocumentation)
{
  const StabilityMethod method = GetFilterMethods().at(GetParam());
  for (const StabilitySituation& situation : GetStabilitySituations())
  {
    SCOPED_TRACE(situation.Name + ' ' + situation.Parameter);
    const StabilityCase scene = situation.MakeCase(Shots);
    const StabilityTally tally = StabilityTruth(scene).Judge(method.Cast(scene));
    if (IsBeyondDouble(situation))
    {
      EXPECT_EQ(tally.False, 0u);
      EXPECT_EQ(tally.Wrong, 0u);
      continue;
    }
    Check(GetParam(), situation, tally);
    if (GetParam() == Scan::EXACT)
    {
      EXPECT_LE(tally.WorstUnits, ExactRangeError);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EachOfThem, Stability,
  testing::Range(0, Scan::GetNumberOfIntersectionMethods()),
  [](const testing::TestParamInfo<int>& method)
  { return std::string(Scan::GetIntersectionMethodName(method.param)); });

// Otherwise no method could fail there.
TEST(StabilitySituations, HaveBeamsThatHit)
{
  for (const StabilitySituation& situation : GetStabilitySituations())
  {
    SCOPED_TRACE(situation.Name + ' ' + situation.Parameter);
    const StabilityCase scene = situation.MakeCase(4);
    const std::vector<double> nothing(
      4 * lms3dBeamPacket::Size, std::numeric_limits<double>::infinity());
    const StabilityTally tally = StabilityTruth(scene).Judge(nothing);
    EXPECT_EQ(tally.Missed, tally.Hits);
    EXPECT_EQ(tally.Hits > 0, situation.Name != "beside an edge");
  }
}
