// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/NarrowFixtures.h"

#include "Fixtures/BeamFixtures.h"

#include "Casting/lms3dTriangle.h"

#include <cmath>

namespace
{
const Vector Sensor = { 0.0, 0.0, 0.0 };

lms3dCorners GetPointers(const Corners& corners)
{
  return { corners[0].data(), corners[1].data(), corners[2].data() };
}
} // namespace

Corners MakeTriangle(Random& random)
{
  const double distance = std::pow(10.0, random.Get(-3.0, 2.0));
  const double size = distance * std::pow(10.0, random.Get(-4.0, 1.0));
  const Vector a = distance * random.GetDirection();
  const Vector p = size * random.GetDirection();
  Vector q = size * random.GetDirection();
  switch (random.GetBits() % 4)
  {
    case 0:
      q = random.Get(-1.0, 1.0) * p + std::pow(10.0, random.Get(-8.0, -1.0)) * q;
      break;
    case 1:
      q = random.Get(-1.0, 1.0) * p + random.Get(-1.0, 1.0) * a +
        std::pow(10.0, random.Get(-9.0, -2.0)) * q;
      break;
    default:
      break;
  }
  return { a, a + p, a + q };
}

lms3dSensorFrameTriangle GetInSensorFrame(const Corners& corners)
{
  return lms3dToSensorFrame(GetPointers(corners), Sensor.data());
}

double GetRange(const Corners& corners, const Vector& direction)
{
  const lms3dCorners pointers = GetPointers(corners);
  if (!lms3dIsInside(pointers, Sensor.data(), direction.data()))
  {
    return lms3dBeamPacket::NoRange;
  }
  double ranges[lms3dBeamPacket::Size];
  lms3dIntersectNearPlane(pointers, Sensor.data(), MakePacket(MakeSame(direction)), ranges);
  return ranges[0] > 0.0 ? ranges[0] : lms3dBeamPacket::NoRange;
}
