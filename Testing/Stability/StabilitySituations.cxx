// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StabilitySituations.h"

#include "StabilityScenes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace
{
using Make = std::function<StabilityCase(Random&, std::size_t)>;
using MakeOf = StabilityCase (*)(double parameter, Random& random, std::size_t shots);

// A power of ten, or a few of them, as in 1e-6.
std::string Format(double x)
{
  char text[16];
  const int exponent = static_cast<int>(std::floor(std::log10(std::abs(x)) + 0.01));
  std::snprintf(text, sizeof text, "%ge%d", std::round(x / std::pow(10.0, exponent)), exponent);
  return text;
}

class Collector
{
public:
  void Add(const std::string& name, const std::string& parameter, Make make)
  {
    const std::uint64_t seed = this->Situations.size() + 1;
    this->Situations.push_back({ name, parameter, seed, std::move(make) });
  }

  void AddEach(const std::string& name, const std::vector<double>& parameters, MakeOf make)
  {
    for (double parameter : parameters)
    {
      this->Add(name, Format(parameter),
        [make, parameter](Random& random, std::size_t shots)
        { return make(parameter, random, shots); });
    }
  }

  std::vector<StabilitySituation> Situations;
};

// --- Where triangles meet ------------------------------------------------------------------------

Make AimAtBall(StabilityAim aim)
{
  return [aim](Random& random, std::size_t shots)
  { return AimAtTriangles(MakeStabilityBall(), InsideStabilityBall, aim, random, shots); };
}

StabilityCase AimAtCubeOnGrid(Random& random, std::size_t shots)
{
  return AimOnGrid(MakeCube(8), 8, 0.125, 8, random, shots);
}

StabilityCase AimAtBlocksOnGrid(Random& random, std::size_t shots)
{
  return AimOnGrid(MakeBlocks(), 8, 1.0, 8, random, shots);
}

StabilityCase PassEdges(double share, Random& random, std::size_t shots)
{
  return AimBesideEdges(MakeLooseTriangles(), share, random, shots);
}

void AddMeetings(Collector& collector)
{
  collector.Add("generic beams", "ball",
    [](Random& random, std::size_t shots)
    { return AimAllAround(MakeStabilityBall(), { InsideStabilityBall }, random, shots); });
  collector.Add("shared edges", "ball", AimAtBall(StabilityAim::EDGE));
  collector.Add("shared vertices", "ball", AimAtBall(StabilityAim::CORNER));
  collector.Add("common grid", "cube", AimAtCubeOnGrid);
  collector.Add("common grid", "blocks", AimAtBlocksOnGrid);
  collector.AddEach("beside an edge", { 1e-4, 1e-6, 1e-8, 1e-10 }, PassEdges);
  collector.AddEach("within an edge", { -1e-4, -1e-6, -1e-8, -1e-10 }, PassEdges);
  collector.Add("T-junction", "", AimAtTJunction);
}

// --- Shapes and angles ---------------------------------------------------------------------------

void AddShapes(Collector& collector)
{
  collector.AddEach("slivers", { 1e2, 1e4, 1e6, 1e8 }, AimAtNeedles);
  collector.AddEach("grazing angle", { 1e-2, 1e-4, 1e-6, 1e-8 }, AimAlongFloor);
  collector.AddEach("tiny component", { -1e-17, -1e-20, -1e-33 }, AimAlongAxes);
}

// --- Places and sizes ----------------------------------------------------------------------------

StabilityCase AimAtOffset(double offset, Random& random, std::size_t shots)
{
  const Vector center = { offset, -0.7 * offset, 0.3 * offset };
  return AimAtTriangles(Move(MakeStabilityBall(), 1.0, center), InsideStabilityBall + center,
    StabilityAim::ANYTHING, random, shots);
}

StabilityCase AimAtSize(double size, Random& random, std::size_t shots)
{
  // Aimed at the ball of 1 m, since the smallest sizes have no directions.
  StabilityCase scene =
    AimAtTriangles(MakeStabilityBall(), InsideStabilityBall, StabilityAim::ANYTHING, random, shots);
  scene.Mesh = Move(std::move(scene.Mesh), size, {});
  for (StabilityShot& shot : scene.Shots)
  {
    shot.Sensor = size * shot.Sensor;
  }
  return scene;
}

StabilityCase AimFromAfar(double distance, Random& random, std::size_t shots)
{
  return AimAtTriangles(MakeStabilityBall(), distance * Normalize({ 0.3, -0.5, 0.7 }),
    StabilityAim::INSIDE, random, shots);
}

StabilityCase AimAtShells(double gap, Random& random, std::size_t shots)
{
  StabilityCase scene =
    AimAtTriangles(MakeStabilityBall(), InsideStabilityBall, StabilityAim::ANYTHING, random, shots);
  Append(Move(MakeStabilityBall(), 1.0 + gap, {}), scene.Mesh);
  return scene;
}

void AddPlaces(Collector& collector)
{
  collector.AddEach("offset", { 1e3, 1e5, 1e6, 1e7 }, AimAtOffset);
  collector.AddEach("scale", { 1e-6, 1e-3, 1e3, 1e7 }, AimAtSize);
  collector.AddEach("denormals", { 1e-30, 1e-40, 1e-100, 1e-120, 1e-310 }, AimAtSize);
  collector.AddEach("far targets", { 1e3, 1e5, 1e7, 1e9 }, AimFromAfar);
  collector.AddEach("nested shells", { 1e-2, 1e-4, 3e-6 }, AimAtShells);
}

// --- Bad triangles, and where the sensor stands --------------------------------------------------

/// A ball, and in front of it what is not to be seen, made of points halfway to it.
template <typename MakeBad>
Make HideBall(const MakeBad& makeBad)
{
  return [makeBad](Random& random, std::size_t shots)
  {
    constexpr int Count = 200;
    const lms3dTriangleMesh ball = MakeStabilityBall();
    lms3dTriangleMesh bad;
    for (int i = 0; i < Count; ++i)
    {
      Append(makeBad(0.5 * ball.Points[i], 0.5 * ball.Points[i + 1]), bad);
    }
    StabilityCase scene =
      AimAtTriangles(ball, InsideStabilityBall, StabilityAim::INSIDE, random, shots);
    for (std::size_t i = 0; i < shots; i += 2)
    {
      const Vector& p = ball.Points[i % Count];
      const Vector& q = ball.Points[i % Count + 1];
      std::generate(scene.Shots[i].Directions.begin(), scene.Shots[i].Directions.end(),
        [&] { return Normalize(0.5 * (p + random.Get() * (q - p)) - InsideStabilityBall); });
    }
    Append(bad, scene.Mesh);
    return scene;
  };
}

Make HideBallBehind(double bad)
{
  return HideBall(
    [bad](const Vector& p, const Vector& q) {
      return MakeMesh({ { { p, q, { bad, 0.0, 0.0 } } } });
    });
}

Make StandOnCube(const std::vector<Vector>& sensors)
{
  return [sensors](Random& random, std::size_t shots)
  { return AimAllAround(MakeCube(2), sensors, random, shots); };
}

void AddBadTriangles(Collector& collector)
{
  collector.Add("zero area", "",
    HideBall(
      [](const Vector& p, const Vector& q) {
        return MakeMesh({ { { p, p, p } }, { { p, q, p } }, { { p, q, q } } });
      }));
  collector.Add("not finite", "nan", HideBallBehind(std::numeric_limits<double>::quiet_NaN()));
  collector.Add("not finite", "inf", HideBallBehind(std::numeric_limits<double>::infinity()));
  collector.Add("on a surface", "face", StandOnCube({ { 0.25, 0.5, 1.0 }, { -0.3, 1.0, 0.1 } }));
  collector.Add("on a surface", "edge", StandOnCube({ { 0.5, 0.5, 1.0 }, { 1.0, 0.25, 1.0 } }));
  collector.Add("on a surface", "vertex", StandOnCube({ { 0.0, 0.0, 1.0 }, { 1.0, 1.0, 1.0 } }));
}
} // namespace

StabilityCase StabilitySituation::MakeCase(std::size_t shots) const
{
  Random random(this->Seed);
  return this->Make(random, shots);
}

const std::vector<StabilitySituation>& GetStabilitySituations()
{
  static const std::vector<StabilitySituation> situations = []
  {
    Collector collector;
    AddMeetings(collector);
    AddShapes(collector);
    AddPlaces(collector);
    AddBadTriangles(collector);
    return collector.Situations;
  }();
  return situations;
}
