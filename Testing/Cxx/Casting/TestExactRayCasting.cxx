// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The exact caster below VTK in closed meshes: no beam lost, none invented.
 */
#include "Fixtures/CasterFixtures.h"
#include "Fixtures/SceneFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <tuple>

namespace
{
/// Closed meshes around the origin, and where sensors stand within all of them.
struct Enclosure
{
  const char* Name;
  std::vector<lms3dTriangleMesh> (*Make)();
  /// Has nothing but its outer side, so that beams hit where they aim.
  bool IsConvex;
  std::vector<Vector> Sensors;
};

std::vector<lms3dTriangleMesh> MakeIcospheres()
{
  std::vector<lms3dTriangleMesh> meshes;
  meshes.reserve(6);
  for (int level = 0; level < 6; ++level)
  {
    meshes.push_back(MakeIcosphere(level));
  }
  return meshes;
}

std::vector<lms3dTriangleMesh> MakeCubes()
{
  return { MakeCube(1), MakeCube(3), MakeCube(8) };
}

std::vector<lms3dTriangleMesh> MakeRoom()
{
  return { MakeMesh(ReadRoom()) };
}

std::vector<lms3dTriangleMesh> MakeTurnedRoom()
{
  return { Map(MakeMesh(ReadRoom()), Turn) };
}

const Vector InRoom = { 0.3, -0.2, 1.0 };

const Enclosure Enclosures[] = {
  { "Icospheres", MakeIcospheres, true, { { 0, 0, 0 }, { 0.31, -0.42, 0.17 }, { 0, 0, 0.7 } } },
  { "Cubes", MakeCubes, true, { { 0, 0, 0 }, { 0.5, 0.25, -0.75 }, { 0.31, -0.42, 0.9 } } },
  { "Room", MakeRoom, false, { InRoom, { 0.25, -0.25, 1.0 } } },
  { "TurnedRoom", MakeTurnedRoom, false, { Turn(InRoom), Turn({ 0.25, -0.25, 1.0 }) } },
};

void PrintTo(const Enclosure& enclosure, std::ostream* os)
{
  *os << enclosure.Name;
}

using Placement = std::tuple<Enclosure, double, double>;

class EachEnclosure : public testing::TestWithParam<Placement>
{
};

std::string GetName(const testing::TestParamInfo<Placement>& info)
{
  std::ostringstream name;
  name << std::get<0>(info.param).Name << "_Scale" << std::get<1>(info.param) << "_Offset"
       << std::get<2>(info.param);
  std::string text = name.str();
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == '.' || c == '+' || c == '-'; }, '_');
  return text;
}

/// Whether a hit is so near to the point that was aimed at that the beam hit there, with nothing in
/// between.
bool IsAtAim(const Target& target, const Enclosure& enclosure, const Vector& sensor,
  const Vector& direction, double range, double distance)
{
  constexpr double Margin = 1e-12;
  return range >= distance * (1.0 - Margin) && range <= distance * (1.0 + Margin) &&
    (enclosure.IsConvex ||
      target.Reference.Cast(sensor, direction, distance * (1.0 - Margin)).Triangle ==
        ExactReference::NoTriangle);
}

/// From within a closed mesh all beams hit, and most of them where they aim. The reference tells
/// the rest: what hides the aim, a silhouette that rounding of the beam passes, a plane through the
/// sensor; and, of one packet of many, everything to the last bits.
Tally JudgeEnclosed(const Target& target, const Enclosure& enclosure, double scale,
  const Vector& center, std::size_t number)
{
  constexpr std::size_t Sample = 160;
  Random random(number);
  const Vector& place = enclosure.Sensors[random.GetBits() % enclosure.Sensors.size()];
  const Vector sensor = scale * place + center;
  const std::size_t triangle = random.GetBits() % target.GetMesh().GetNumberOfTriangles();
  const Beams points = target.GetRelativePoints(triangle, sensor, random);
  Beams beams;
  std::transform(points.begin(), points.end(), beams.begin(), Normalize);
  const lms3dBeamPacket packet = target.Cast(sensor, beams);
  Tally tally;
  for (int i = 0; i < lms3dBeamPacket::Size; ++i)
  {
    const double distance = GetLength(points[i]);
    const bool isClear = number % Sample != 0 &&
      IsAtAim(target, enclosure, sensor, beams[i], packet.Range[i], distance);
    tally += isClear ? Tally{ 1, 1, 0, 0, 0.0 } : JudgeBeam(target, sensor, beams[i], packet, i);
  }
  return tally;
}
} // namespace

// 36 x 280,800 beams.
TEST_P(EachEnclosure, LosesNoBeamAndInventsNone)
{
  constexpr std::size_t Packets = 17550 / Fewer;
  const Enclosure& enclosure = std::get<0>(GetParam());
  const double scale = std::get<1>(GetParam());
  const double offset = std::get<2>(GetParam());
  const Vector center = { offset, -0.7 * offset, 0.3 * offset };
  const std::vector<lms3dTriangleMesh> meshes = enclosure.Make();
  Tally sum;
  for (const lms3dTriangleMesh& mesh : meshes)
  {
    ASSERT_TRUE(IsClosed(mesh));
    const Target target(Move(mesh, scale, center));
    sum += JudgeEach(Packets / meshes.size(),
      [&](std::size_t i) { return JudgeEnclosed(target, enclosure, scale, center, i); });
  }
  ExpectExactAndWhole(sum);
}

INSTANTIATE_TEST_SUITE_P(ExactRayCasting, EachEnclosure,
  testing::Combine(
    testing::ValuesIn(Enclosures), testing::Values(1e-3, 1.0, 1e3), testing::Values(0.0, 1e5, 5e6)),
  GetName);
