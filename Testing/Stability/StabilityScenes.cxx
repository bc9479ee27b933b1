// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "StabilityScenes.h"

#include <algorithm>

namespace
{
struct Weights
{
  double First;
  double Second;
};

// Concerns a triangle's second and third corner.
Weights Choose(StabilityAim aim, Random& random)
{
  if (aim == StabilityAim::ANYTHING)
  {
    aim = static_cast<StabilityAim>(random.GetBits() % 3);
  }
  if (aim == StabilityAim::CORNER)
  {
    return { 0.0, 0.0 };
  }
  const double first = random.Get();
  return { first, aim == StabilityAim::EDGE ? 0.0 : random.Get() * (1.0 - first) };
}

Vector AimAt(const lms3dTriangleMesh& mesh, const Vector& sensor, StabilityAim aim, Random& random)
{
  const auto& triangle = mesh.Triangles[random.GetBits() % mesh.GetNumberOfTriangles()];
  const std::size_t corner = random.GetBits() % 3;
  const Vector a = mesh.Points[triangle[corner]] - sensor;
  const Vector b = mesh.Points[triangle[(corner + 1) % 3]] - sensor;
  const Vector c = mesh.Points[triangle[(corner + 2) % 3]] - sensor;
  const auto [u, v] = Choose(aim, random);
  return Normalize(u == 0.0 ? a : (1.0 - u - v) * a + u * b + v * c);
}
} // namespace

lms3dTriangleMesh MakeStabilityBall()
{
  return MakeIcosphere(3);
}

StabilityCase AimAtTriangles(const lms3dTriangleMesh& mesh, const Vector& sensor, StabilityAim aim,
  Random& random, std::size_t shots)
{
  StabilityCase scene = { mesh, std::vector<StabilityShot>(shots) };
  for (StabilityShot& shot : scene.Shots)
  {
    shot.Sensor = sensor;
    std::generate(shot.Directions.begin(), shot.Directions.end(),
      [&] { return AimAt(mesh, sensor, aim, random); });
  }
  return scene;
}

StabilityCase AimAllAround(const lms3dTriangleMesh& mesh, const std::vector<Vector>& sensors,
  Random& random, std::size_t shots)
{
  StabilityCase scene = { mesh, std::vector<StabilityShot>(shots) };
  for (std::size_t i = 0; i < shots; ++i)
  {
    StabilityShot& shot = scene.Shots[i];
    shot.Sensor = sensors[i % sensors.size()];
    std::generate(
      shot.Directions.begin(), shot.Directions.end(), [&random] { return random.GetDirection(); });
  }
  return scene;
}

lms3dTriangleMesh MakeLooseTriangles()
{
  const lms3dTriangleMesh ball = MakeIcosphere(1);
  std::vector<std::array<Vector, 3>> triangles;
  triangles.reserve(ball.GetNumberOfTriangles());
  for (const auto& [i, j, k] : ball.Triangles)
  {
    const Vector& a = ball.Points[i];
    const Vector& b = ball.Points[j];
    const Vector& c = ball.Points[k];
    const Vector middle = (1.0 / 6.0) * (a + b + c);
    triangles.push_back({ 0.5 * a + middle, 0.5 * b + middle, 0.5 * c + middle });
  }
  return MakeMesh(triangles);
}

StabilityCase AimBesideEdges(
  const lms3dTriangleMesh& mesh, double share, Random& random, std::size_t shots)
{
  StabilityCase scene = { mesh, std::vector<StabilityShot>(shots) };
  for (StabilityShot& shot : scene.Shots)
  {
    shot.Sensor = {};
    for (Vector& direction : shot.Directions)
    {
      const auto& triangle = mesh.Triangles[random.GetBits() % mesh.GetNumberOfTriangles()];
      const std::size_t corner = random.GetBits() % 3;
      const Vector& a = mesh.Points[triangle[corner]];
      const Vector& b = mesh.Points[triangle[(corner + 1) % 3]];
      const Vector& c = mesh.Points[triangle[(corner + 2) % 3]];
      const Vector onEdge = a + random.Get(0.1, 0.9) * (b - a);
      direction = Normalize(onEdge + share * (0.5 * (a + b) - c));
    }
  }
  return scene;
}

StabilityCase AimAtTJunction(Random& random, std::size_t shots)
{
  const lms3dTriangleMesh mesh = MakeTJunction();
  const Vector& a = mesh.Points[0];
  const Vector& b = mesh.Points[1];
  StabilityCase scene = { mesh, std::vector<StabilityShot>(shots) };
  for (StabilityShot& shot : scene.Shots)
  {
    shot.Sensor = { 0.1, 0.2, 0.3 };
    std::generate(shot.Directions.begin(), shot.Directions.end(),
      [&] { return Normalize(a + random.Get(0.01, 0.99) * (b - a) - shot.Sensor); });
  }
  return scene;
}

StabilityCase AimOnGrid(const lms3dTriangleMesh& mesh, int reach, double spacing, int finer,
  Random& random, std::size_t shots)
{
  const auto getPlace = [&random](int most)
  {
    Vector p;
    std::generate(p.begin(), p.end(),
      [&] { return static_cast<double>(random.GetBits() % (2 * most + 1)) - most; });
    return p;
  };
  StabilityCase scene = { mesh, std::vector<StabilityShot>(shots) };
  for (StabilityShot& shot : scene.Shots)
  {
    shot.Sensor = spacing * getPlace(reach - 1);
    for (Vector& direction : shot.Directions)
    {
      // On a face of the cube of directions, whose edge is a power of two.
      direction = (1.0 / finer) * getPlace(finer);
      direction[random.GetBits() % 3] = random.GetBits() % 2 ? 1.0 : -1.0;
    }
  }
  return scene;
}

StabilityCase AimAtNeedles(double aspect, Random& random, std::size_t shots)
{
  const Vector sensor = { 0.0, 0.0, 0.25 };
  StabilityCase scene = { Map(MakeNeedleWall(aspect), Turn), std::vector<StabilityShot>(shots) };
  for (StabilityShot& shot : scene.Shots)
  {
    shot.Sensor = Turn(sensor);
    for (Vector& direction : shot.Directions)
    {
      const double z = random.Get(-0.4, 0.4);
      const std::array<double, 3> places = { 0.0, 0.5 - z, random.Get() };
      const double column = static_cast<double>(random.GetBits() % 180) - 90.0;
      const double x = (column + places[random.GetBits() % 3]) / aspect;
      direction = Turn(Normalize(Vector{ x, 1.0, z } - sensor));
    }
  }
  return scene;
}

StabilityCase AimAlongFloor(double height, Random& random, std::size_t shots)
{
  constexpr int Cells = 8;
  lms3dTriangleMesh floor = Map(MakeCube(Cells), [](const Vector& p) { return 2.0 * p; });
  floor.Triangles.erase(std::remove_if(floor.Triangles.begin(), floor.Triangles.end(),
                          [&floor](const std::array<std::uint32_t, 3>& triangle)
                          {
                            return std::any_of(triangle.begin(), triangle.end(),
                              [&floor](std::uint32_t corner)
                              { return floor.Points[corner][2] < 2.0; });
                          }),
    floor.Triangles.end());
  return AimAtTriangles(
    Map(floor, Turn), Turn({ 0.1, 0.2, 2.0 + height }), StabilityAim::INSIDE, random, shots);
}

StabilityCase AimAlongAxes(double component, Random& random, std::size_t shots)
{
  StabilityCase scene = { MakeStabilityBall(), std::vector<StabilityShot>(shots) };
  for (StabilityShot& shot : scene.Shots)
  {
    shot.Sensor = InsideStabilityBall;
    for (Vector& direction : shot.Directions)
    {
      direction = Normalize({ random.Get(-1.0, 1.0), random.Get(-1.0, 1.0), 0.0 });
      direction[2] = component;
      std::rotate(direction.begin(), direction.begin() + random.GetBits() % 3, direction.end());
    }
  }
  return scene;
}
