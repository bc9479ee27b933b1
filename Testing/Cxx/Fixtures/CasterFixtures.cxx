// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/CasterFixtures.h"

#include "vtkLMS3DScanFilter.h"

#include <gtest/gtest.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <ostream>

namespace
{
// The header of the filter leaves open which of two surfaces so near to one another is returned.
constexpr double TieMargin = 1e-13;

// Enough to find what goes wrong everywhere.
std::size_t Reduce(std::size_t packets)
{
  return std::max<std::size_t>(1, packets / std::min<std::size_t>(Fewer, 10));
}
} // namespace

Target::Target(const lms3dTriangleMesh& mesh)
  : Caster(lms3dRayCaster::New(vtkLMS3DScanFilter::EXACT, mesh))
  , Reference(
      { mesh.Points.begin(), mesh.Points.end() }, { mesh.Triangles.begin(), mesh.Triangles.end() })
{
}

Vector Target::GetRelativeCorner(const Vector& origin, std::size_t triangle, int corner) const
{
  const double* p = this->GetMesh().GetCorner(triangle, corner);
  return { p[0] - origin[0], p[1] - origin[1], p[2] - origin[2] };
}

Beams Target::GetRelativePoints(std::size_t triangle, const Vector& origin, Random& random) const
{
  constexpr int Corners = 1;
  constexpr int Edges = 4;
  Beams points;
  const int first = static_cast<int>(random.GetBits() % 3);
  const Vector a = this->GetRelativeCorner(origin, triangle, first);
  const Vector b = this->GetRelativeCorner(origin, triangle, (first + 1) % 3);
  const Vector c = this->GetRelativeCorner(origin, triangle, (first + 2) % 3);
  for (int i = 0; i < lms3dBeamPacket::Size; ++i)
  {
    const double u = random.Get();
    const double v = i < Corners + Edges ? 0.0 : random.Get() * (1.0 - u);
    points[i] = i < Corners ? a : (1.0 - u - v) * a + u * b + v * c;
  }
  return points;
}

Beams Target::MakeBeamsAt(std::size_t triangle, const Vector& origin, Random& random) const
{
  Beams beams = this->GetRelativePoints(triangle, origin, random);
  std::transform(beams.begin(), beams.end(), beams.begin(), Normalize);
  return beams;
}

lms3dBeamPacket Target::Cast(
  const Vector& origin, const Beams& directions, double maximumRange) const
{
  lms3dBeamPacket packet = MakePacket(directions);
  this->Caster->Cast({ { origin[0], origin[1], origin[2] }, maximumRange }, &packet, 1);
  return packet;
}

Tally& Tally::operator+=(const Tally& other)
{
  this->Beams += other.Beams;
  this->Hits += other.Hits;
  this->Misses += other.Misses;
  this->FalseHits += other.FalseHits;
  this->WorstError = std::max(this->WorstError, other.WorstError);
  return *this;
}

std::ostream& operator<<(std::ostream& os, const Tally& tally)
{
  return os << tally.Beams << " beams, " << tally.Hits << " hits, " << tally.Misses << " missed, "
            << tally.FalseHits << " false, worst range off by " << tally.WorstError << " ulp";
}

void ExpectExact(const Tally& tally)
{
  EXPECT_EQ(tally.Misses, 0) << tally;
  EXPECT_EQ(tally.FalseHits, 0) << tally;
  EXPECT_LE(tally.WorstError, ExactRangeError) << tally;
}

void ExpectExactAndWhole(const Tally& tally)
{
  EXPECT_EQ(tally.Hits, tally.Beams) << tally;
  ExpectExact(tally);
}

Tally Judge(const Target& target, const Vector& origin, const Beams& directions)
{
  const lms3dBeamPacket packet = target.Cast(origin, directions);
  Tally tally;
  for (int i = 0; i < lms3dBeamPacket::Size; ++i)
  {
    tally += JudgeBeam(target, origin, directions[i], packet, i);
  }
  return tally;
}

Tally JudgeBeam(const Target& target, const Vector& origin, const Vector& direction,
  const lms3dBeamPacket& packet, int beam)
{
  const ExactReference& truth = target.Reference;
  const std::int32_t triangle = packet.Triangle[beam];
  Tally tally;
  tally.Beams = 1;
  if (triangle == lms3dBeamPacket::NoTriangle)
  {
    tally.Hits = truth.Cast(origin, direction).Triangle != ExactReference::NoTriangle;
    tally.Misses = tally.Hits;
    return tally;
  }
  const ExactReference::Hit own = truth.Cast(triangle, origin, direction);
  const double limit = own.Range * (1.0 - TieMargin);
  tally.Hits = 1;
  tally.FalseHits = own.Triangle != triangle || !(packet.Range[beam] > 0.0) ||
    truth.Cast(origin, direction, limit).Triangle != ExactReference::NoTriangle;
  tally.WorstError = tally.FalseHits ? 0.0 : ExactReference::GetError(packet.Range[beam], own);
  return tally;
}

Tally JudgeEach(std::size_t count, const std::function<Tally(std::size_t)>& judge)
{
  return tbb::parallel_reduce(
    tbb::blocked_range<std::size_t>(0, count), Tally(),
    [&](const tbb::blocked_range<std::size_t>& part, Tally tally)
    {
      for (std::size_t i = part.begin(); i < part.end(); ++i)
      {
        tally += judge(i);
      }
      return tally;
    },
    [](Tally a, const Tally& b) { return a += b; });
}

Tally JudgeTriangles(const Target& target, const Vector& sensor, std::size_t packets)
{
  return JudgeEach(Reduce(packets),
    [&](std::size_t number)
    {
      Random random(number);
      const std::size_t triangle = random.GetBits() % target.GetMesh().GetNumberOfTriangles();
      return Judge(target, sensor, target.MakeBeamsAt(triangle, sensor, random));
    });
}

Tally JudgeAllAround(const Target& target, const Vector& sensor, std::size_t packets)
{
  return JudgeEach(Reduce(packets),
    [&](std::size_t number)
    {
      Random random(number);
      Beams beams;
      std::generate(beams.begin(), beams.end(), [&random] { return random.GetDirection(); });
      return Judge(target, sensor, beams);
    });
}
