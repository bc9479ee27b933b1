// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/NarrowFixtures.h"

#include "Fixtures/BeamFixtures.h"

#include "Casting/lms3dTriangle.h"

#include <cmath>

namespace
{
lms3dCorners GetPointers(const Corners& corners)
{
  return { corners[0].data(), corners[1].data(), corners[2].data() };
}
} // namespace

Corners MakeTriangle(Random& random, const Exponents& sizes)
{
  const double distance = std::pow(10.0, random.Get(-3.0, 2.0));
  const double size = distance * std::pow(10.0, random.Get(sizes.Minimum, sizes.Maximum));
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

Vector MakeSensor(Random& random)
{
  const Vector sensor = std::pow(10.0, random.Get(-3.0, 2.0)) * random.GetDirection();
  return random.GetBits() % 2 ? sensor : Vector{ 0.0, 0.0, 0.0 };
}

SeenTriangle::SeenTriangle(const Corners& corners, const Vector& sensor)
  : World{ corners[0] + sensor, corners[1] + sensor, corners[2] + sensor }
  , Sensor(sensor)
{
}

lms3dSensorFrameTriangle SeenTriangle::GetInSensorFrame() const
{
  return lms3dToSensorFrame(GetPointers(this->World), this->Sensor.data());
}

lms3dCornerPoints SeenTriangle::GetPoints() const
{
  return { { this->World[0].data(), this->World[1].data(), this->World[2].data() },
    this->Sensor.data(), 1.0 };
}

double SeenTriangle::GetRange(const Vector& direction) const
{
  const lms3dCorners corners = GetPointers(this->World);
  if (!lms3dIsInside(corners, this->Sensor.data(), direction.data()))
  {
    return lms3dBeamPacket::NoRange;
  }
  double ranges[lms3dBeamPacket::Size];
  lms3dIntersectNearPlane(corners, this->Sensor.data(), MakePacket(MakeSame(direction)), ranges);
  return ranges[0] > 0.0 ? ranges[0] : lms3dBeamPacket::NoRange;
}
