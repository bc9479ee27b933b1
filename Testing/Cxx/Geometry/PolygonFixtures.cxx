// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Geometry/PolygonFixtures.h"

#include "Geometry/lms3dAngle.h"

#include <cmath>
#include <cstddef>

Corners MakeComb(int teeth)
{
  Corners corners = { { 0, -1, 0 } };
  for (int i = 0; i < teeth; ++i)
  {
    corners.push_back({ 2.0 * i + 1, -1, 0 });
    corners.push_back({ 2.0 * i + 1, 1, 0 });
    corners.push_back({ 2.0 * i + 2, 1, 0 });
    corners.push_back({ 2.0 * i + 2, -1, 0 });
  }
  corners.push_back({ 2.0 * teeth, -2, 0 });
  corners.push_back({ 0, -2, 0 });
  return corners;
}

Corners MakeRegularPolygon(int sides, double radius)
{
  Corners corners;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * lms3dPi * i / sides;
    corners.push_back({ radius * std::cos(angle), radius * std::sin(angle), 1.0 });
  }
  return corners;
}

Corners MakeCrescent(int count, double radius, double far)
{
  const int half = count / 2;
  Corners corners;
  for (int i = 0; i < half; ++i)
  {
    const double angle = lms3dPi * i / half;
    corners.push_back({ far + radius * std::cos(angle), far + radius * std::sin(angle), 0 });
  }
  for (int i = 0; i < half; ++i)
  {
    const double angle = lms3dPi * i / half;
    corners.push_back({ far - radius * std::cos(angle), far + 0.7 * radius * std::sin(angle), 0 });
  }
  return corners;
}

Corners MakeBowedTriangle(int cornersPerSide)
{
  const Corners tips = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, std::sqrt(0.75), 0 } };
  Corners corners;
  for (std::size_t side = 0; side < 3; ++side)
  {
    const lms3dVector along = lms3dSubtract(tips[(side + 1) % 3], tips[side]);
    const lms3dVector inwards = { -along[1], along[0], 0 };
    for (int i = 0; i < cornersPerSide; ++i)
    {
      const double t = static_cast<double>(i) / cornersPerSide;
      const double depth = 0.1 * 4.0 * t * (1.0 - t);
      corners.push_back(
        lms3dAdd(lms3dAdd(tips[side], lms3dScale(along, t)), lms3dScale(inwards, depth)));
    }
  }
  return corners;
}

Corners MakeStar(int points)
{
  Corners corners;
  for (int i = 0; i < 2 * points; ++i)
  {
    const double angle = lms3dPi * i / points;
    const double radius = i % 2 == 0 ? 2.0 : 1.0;
    corners.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0 });
  }
  return corners;
}
