// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/MapScenes.h"

#include "Fixtures/SceneBuilder.h"
#include "Fixtures/SceneFixtures.h"

#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

namespace
{
constexpr Vector RoomLow = { -4.0, -3.0, 0.0 };
constexpr Vector RoomHigh = { 4.0, 3.0, 3.0 };

SceneBuilder MakeRoom()
{
  SceneBuilder builder;
  builder.AddBox(RoomLow, RoomHigh);
  return builder;
}

MapScene MakeClosedRoom()
{
  return { MakeRoom().GetSurface(), { 0.3, -0.2, 1.0 }, {}, true };
}

MapScene MakeTurnedRoom()
{
  return { MakeRoom().GetSurface(), { -1.2, 0.7, 1.9 }, { 20.0, 40.0, 60.0 }, true };
}

MapScene MakeCorner()
{
  return { MakeRoom().GetSurface(), RoomLow + Vector{ 0.01, 0.01, 0.01 }, {}, true };
}

// Beams run exactly along creases and into corners.
MapScene MakeCube()
{
  SceneBuilder builder;
  builder.AddBox({ -2.0, -2.0, -2.0 }, { 2.0, 2.0, 2.0 });
  return { builder.GetSurface(), {}, {}, true };
}

MapScene MakeSphere()
{
  return { MakeBall(2.0, 96), { 0.3, -0.4, 0.2 }, {}, true };
}

MapScene MakeWallsWithGap()
{
  SceneBuilder builder;
  for (double low : { -30.0, 0.5 })
  {
    builder.AddQuad(
      { 2.0, low, -9.0 }, { 2.0, low + 29.5, -9.0 }, { 2.0, low + 29.5, 9.0 }, { 2.0, low, 9.0 });
  }
  builder.AddQuad(
    { 3.0, -90.0, -90.0 }, { 3.0, 90.0, -90.0 }, { 3.0, 90.0, 90.0 }, { 3.0, -90.0, 90.0 });
  MapScene scene = { builder.GetSurface() };
  scene.AlphaRange = { -50.0, 50.0 };
  scene.BetaRange = { -70.0, 50.0 };
  scene.AlphaResolution = 101;
  scene.BetaResolution = 121;
  return scene;
}

MapScene MakePole()
{
  SceneBuilder builder = MakeRoom();
  builder.AddCone({ 2.5, 0.0, 0.0 }, 0.01, 0.01, 2.0, 12);
  return { builder.GetSurface(), { 0.0, 0.0, 1.0 } };
}

MapScene MakeBar()
{
  SceneBuilder builder = MakeRoom();
  builder.AddBox({ 2.0, -1.5, 0.98 }, { 2.04, 1.5, 1.02 });
  return { builder.GetSurface(), { 0.0, 0.0, 1.0 } };
}

// A beam thick, across the grid.
MapScene MakeWire()
{
  SceneBuilder builder = MakeRoom();
  const double side = std::sqrt(0.5);
  builder.AddTurnedBox({ 2.0, 0.0, 1.5 },
    { { { 0.03, 0.0, 0.0 }, { 0.0, 1.5 * side, 1.5 * side },
      { 0.0, 0.035 * side, -0.035 * side } } });
  return { builder.GetSurface(), { 0.0, 0.0, 1.5 } };
}

// Met at down to 1 degree, up to 115 m away.
MapScene MakeFarFloor()
{
  SceneBuilder builder;
  builder.AddQuad(
    { -1e3, -1e3, -2.0 }, { 1e3, -1e3, -2.0 }, { 1e3, 1e3, -2.0 }, { -1e3, 1e3, -2.0 });
  MapScene scene = { builder.GetSurface() };
  scene.IsWhole = true;
  scene.MaximumRange = 120.0;
  scene.AlphaRange = { -90.0, -1.0 };
  scene.AlphaResolution = 90;
  return scene;
}

MapScene MakeFarWall()
{
  SceneBuilder builder;
  builder.AddQuad(
    { -9e3, -9e4, -2.0 }, { 3e3, -9e4, -2.0 }, { 3e3, 9e4, -2.0 }, { -9e3, 9e4, -2.0 });
  builder.AddQuad({ 3e3, -9e4, -2.0 }, { 3e3, 9e4, -2.0 }, { 3e3, 9e4, 9e4 }, { 3e3, -9e4, 9e4 });
  MapScene scene = { builder.GetSurface() };
  scene.MaximumRange = 1e6;
  scene.AlphaRange = { -60.0, 60.0 };
  scene.BetaRange = { -50.0, 50.0 };
  scene.AlphaResolution = 121;
  scene.BetaResolution = 101;
  return scene;
}

// Seen from below, treads unseen above the sensor.
MapScene MakeStairs()
{
  SceneBuilder builder = MakeRoom();
  for (int step = 0; step < 8; ++step)
  {
    builder.AddBox({ 1.0 + 0.3 * step, -1.0, 0.0 }, { 1.3 + 0.3 * step, 1.0, 0.17 * (step + 1) });
  }
  return { builder.GetSurface(), { -1.0, 0.0, 1.0 } };
}

MapScene MakeTeapot()
{
  return { ReadTeapot(), { 0.10, -0.33, 0.30 } };
}

MapScene MakeFurnishedRoom()
{
  return { ReadRoom(), { 0.3, -0.2, 1.0 } };
}

// One leg hides a part of the other.
MapScene MakeLShapedRoom()
{
  SceneBuilder builder = MakeRoom();
  builder.AddBox({ 1.0, -3.0, 0.0 }, { 4.0, 1.0, 3.0 });
  return { builder.GetSurface(), { -1.0, -2.0, 1.2 } };
}

MapScene MakeConeInRoom()
{
  SceneBuilder builder = MakeRoom();
  builder.AddCone({ 2.0, 0.5, 0.0 }, 0.8, 0.0, 1.8, 48);
  return { builder.GetSurface(), { 0.0, 0.0, 1.0 } };
}

MapScene MakeBallInRoom()
{
  SceneBuilder builder = MakeRoom();
  builder.AddBall({ 1.7, -0.6, 1.2 }, 0.5, 48);
  return { builder.GetSurface(), { 0.0, 0.0, 1.0 } };
}

const std::map<std::string, std::function<MapScene()>> Makers = { { "ClosedRoom", MakeClosedRoom },
  { "TurnedRoom", MakeTurnedRoom }, { "Corner", MakeCorner }, { "Cube", MakeCube },
  { "Sphere", MakeSphere }, { "WallsWithGap", MakeWallsWithGap }, { "Pole", MakePole },
  { "Bar", MakeBar }, { "Wire", MakeWire }, { "FarFloor", MakeFarFloor },
  { "FarWall", MakeFarWall }, { "Stairs", MakeStairs }, { "Teapot", MakeTeapot },
  { "FurnishedRoom", MakeFurnishedRoom }, { "LShapedRoom", MakeLShapedRoom },
  { "ConeInRoom", MakeConeInRoom }, { "BallInRoom", MakeBallInRoom } };
} // namespace

MapScene MakeMapScene(const std::string& name)
{
  const auto maker = Makers.find(name);
  if (maker == Makers.end())
  {
    throw std::runtime_error("there is no scene " + name);
  }
  return maker->second();
}

std::vector<std::string> GetMapSceneNames()
{
  std::vector<std::string> names;
  names.reserve(Makers.size());
  for (const auto& [name, maker] : Makers)
  {
    names.push_back(name);
  }
  return names;
}
