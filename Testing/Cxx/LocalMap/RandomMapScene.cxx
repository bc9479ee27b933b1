// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapScenes.h"

#include "Fixtures/SceneBuilder.h"
#include "Fixtures/TriangleTree.h"

namespace
{
int GetInteger(Random& random, int low, int high)
{
  return static_cast<int>(random.Get(low, high + 1));
}

Vector GetPointInside(Random& random, const Vector& half)
{
  return { random.Get(-half[0], half[0]), random.Get(-half[1], half[1]),
    random.Get(-half[2], half[2]) };
}

void AddThing(SceneBuilder& builder, const Vector& center, Random& random)
{
  const Vector a = random.GetDirection();
  const Vector b = Normalize(Cross(a, random.GetDirection()));
  const Vector c = Cross(a, b);
  const double size = random.Get(0.05, 0.8);
  switch (GetInteger(random, 0, 3))
  {
    case 0:
      builder.AddBall(center, size, GetInteger(random, 6, 24));
      break;
    case 1:
      builder.AddTurnedBox(
        center, { size * a, random.Get(0.01, 0.8) * b, random.Get(0.01, 0.8) * c });
      break;
    case 2:
      builder.AddBox(center - Vector{ size, size, size }, center + Vector{ size, size, size });
      break;
    default:
      builder.AddQuad(center - size * a, center - size * b, center + size * a, center + size * b);
  }
}
} // namespace

MapScene MakeRandomMapScene(Random& random)
{
  const Vector half = { random.Get(1.0, 6.0), random.Get(1.0, 6.0), random.Get(1.0, 3.0) };
  SceneBuilder builder;
  builder.AddBox(-1.0 * half, half);
  const int things = GetInteger(random, 0, 6);
  for (int i = 0; i < things; ++i)
  {
    AddThing(builder, GetPointInside(random, half), random);
  }
  MapScene scene = { builder.GetSurface(), GetPointInside(random, 0.9 * half) };
  scene.IsWhole = things == 0;
  if (random.Get() < 0.5)
  {
    scene.Orientation = { random.Get(-180.0, 180.0), random.Get(-180.0, 180.0),
      random.Get(-180.0, 180.0) };
  }
  scene.AlphaResolution = GetInteger(random, 2, 61);
  scene.BetaResolution = GetInteger(random, 2, 60);
  if (random.Get() < 0.3)
  {
    scene.AlphaRange = { random.Get(-90.0, -10.0), random.Get(10.0, 90.0) };
    scene.BetaRange = { random.Get(-180.0, 0.0), random.Get(20.0, 180.0) };
  }
  return scene;
}
