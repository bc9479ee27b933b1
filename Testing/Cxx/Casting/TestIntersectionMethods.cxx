// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What the header of vtkLMS3DScanFilter promises of methods other than the exact one.
 */
#include "Casting/MethodFixtures.h"
#include "Fixtures/CasterFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using Scan = vtkLMS3DScanFilter;

constexpr int Packets = 200;

// Relative; beyond, a range is that of another surface.
constexpr double RangeError = 1e-9;

const Vector Center = { 0.0, 0.0, 0.0 };
const Vector OffCenter = { 0.1, 0.2, -0.3 };

/// The ray caster of a method, and the errors of its results against the exact reference.
class CheckedCaster
{
public:
  CheckedCaster(int method, const lms3dTriangleMesh& mesh)
    : Caster(lms3dRayCaster::New(method, mesh))
    , Reference({ mesh.Points.begin(), mesh.Points.end() },
        { mesh.Triangles.begin(), mesh.Triangles.end() })
  {
  }

  void Cast(const Vector& sensor, const Beams& beams)
  {
    lms3dBeamPacket packet = MakePacket(beams);
    this->Caster->Cast(
      { { sensor[0], sensor[1], sensor[2] }, lms3dBeamPacket::NoRange }, &packet, 1);
    for (int i = 0; i < lms3dBeamPacket::Size; ++i)
    {
      const ExactReference::Hit truth = this->Reference.Cast(sensor, beams[i]);
      const bool isHit = packet.Triangle[i] != lms3dBeamPacket::NoTriangle;
      const bool isTrueHit = truth.Triangle != ExactReference::NoTriangle;
      this->Hits += isTrueHit;
      this->Misses += isTrueHit && !isHit;
      this->FalseHits += isHit && !isTrueHit;
      this->WrongRanges += isHit && isTrueHit &&
        !(std::abs(packet.Range[i] - truth.Range) <= RangeError * truth.Range);
    }
  }

  void ExpectNoneWrong() const
  {
    EXPECT_GT(this->Hits, 0);
    EXPECT_EQ(this->Misses, 0);
    EXPECT_EQ(this->FalseHits, 0);
    EXPECT_EQ(this->WrongRanges, 0);
  }

private:
  std::unique_ptr<lms3dRayCaster> Caster;
  ExactReference Reference;
  int Hits = 0;
  int Misses = 0;
  int FalseHits = 0;
  int WrongRanges = 0;
};

Beams MakeRandomBeams(Random& random)
{
  Beams beams;
  std::generate(beams.begin(), beams.end(), [&random] { return random.GetDirection(); });
  return beams;
}

class AnyMethod : public testing::TestWithParam<int>
{
};

/// Fast gives no return from the half space that a sensor on a surface looks at through it.
class MethodThatSeesThroughItsStand : public testing::TestWithParam<int>
{
};

/// MollerTrumbore loses some beams there.
class MethodThatSeesVertices : public testing::TestWithParam<int>
{
};
} // namespace

TEST_P(AnyMethod, NeverHitsTrianglesWithoutArea)
{
  // Points and lines before a ball, aimed at.
  const lms3dTriangleMesh ball = MakeIcosphere(3);
  lms3dTriangleMesh mesh = ball;
  for (int i = 0; i < Packets; ++i)
  {
    const Vector p = 0.5 * ball.Points[i];
    const Vector q = 0.5 * ball.Points[i + 1];
    Append(MakeMesh({ { { p, p, p } }, { { p, q, p } }, { { p, q, q } } }), mesh);
  }
  CheckedCaster caster(GetParam(), mesh);
  Random random(1);
  for (int i = 0; i < Packets; ++i)
  {
    const Vector p = 0.5 * ball.Points[i];
    const Vector q = 0.5 * ball.Points[i + 1];
    Beams beams;
    for (Vector& beam : beams)
    {
      beam = Normalize(p + random.Get() * (q - p) - OffCenter);
    }
    caster.Cast(OffCenter, beams);
  }
  caster.ExpectNoneWrong();
}

TEST_P(AnyMethod, SeesABallAllAround)
{
  const lms3dTriangleMesh ball = MakeIcosphere(3);
  CheckedCaster caster(GetParam(), ball);
  Random random(2);
  for (int i = 0; i < Packets; ++i)
  {
    caster.Cast(OffCenter, MakeRandomBeams(random));
  }
  caster.ExpectNoneWrong();
}

TEST_P(MethodThatSeesVertices, LosesNoneOfTheirBeams)
{
  const lms3dTriangleMesh ball = MakeIcosphere(3);
  CheckedCaster caster(GetParam(), ball);
  Random random(3);
  for (int i = 0; i < Packets; ++i)
  {
    for (const Vector& sensor : { Center, OffCenter })
    {
      Beams beams;
      for (Vector& beam : beams)
      {
        beam = Normalize(ball.Points[random.GetBits() % ball.Points.size()] - sensor);
      }
      caster.Cast(sensor, beams);
    }
  }
  caster.ExpectNoneWrong();
}

TEST_P(MethodThatSeesThroughItsStand, SeesTheOtherSideOfABallFromItsVertices)
{
  const lms3dTriangleMesh ball = MakeIcosphere(3);
  CheckedCaster caster(GetParam(), ball);
  Random random(4);
  for (int i = 0; i < Packets; ++i)
  {
    caster.Cast(ball.Points[i], MakeRandomBeams(random));
  }
  caster.ExpectNoneWrong();
}

TEST_P(MethodThatSeesThroughItsStand, SeesTheOtherSidesOfACubeFromItsTop)
{
  CheckedCaster caster(GetParam(), MakeCube(2));
  Random random(5);
  for (const Vector& sensor : { Vector{ 0.25, 0.5, 1.0 }, Vector{ 0.5, 0.5, 1.0 },
         Vector{ 0.0, 0.0, 1.0 }, Vector{ 1.0, 0.25, 1.0 }, Vector{ 1.0, 1.0, 1.0 } })
  {
    for (int i = 0; i < Packets / 5; ++i)
    {
      caster.Cast(sensor, MakeRandomBeams(random));
    }
  }
  caster.ExpectNoneWrong();
}

INSTANTIATE_TEST_SUITE_P(IntersectionMethods, AnyMethod,
  testing::Range(0, Scan::GetNumberOfIntersectionMethods()), GetMethodName);

INSTANTIATE_TEST_SUITE_P(IntersectionMethods, MethodThatSeesVertices,
  testing::Values(Scan::EXACT, Scan::FAST, Scan::ANGLE_SUM, Scan::STATIC_CELL_LOCATOR),
  GetMethodName);

INSTANTIATE_TEST_SUITE_P(IntersectionMethods, MethodThatSeesThroughItsStand,
  testing::Values(Scan::EXACT, Scan::ANGLE_SUM, Scan::MOLLER_TRUMBORE, Scan::STATIC_CELL_LOCATOR),
  GetMethodName);
