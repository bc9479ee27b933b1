// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/NarrowFixtures.h"

#include "Fixtures/BeamFixtures.h"

#include "Casting/lms3dTriangle.h"
#include "Geometry/lms3dVector.h"

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

Corners Scale(const Corners& corners, double scale)
{
  return { scale * corners[0], scale * corners[1], scale * corners[2] };
}

double GetNearlyOne(Random& random, double least, double most)
{
  return 1.0 + std::pow(10.0, random.Get(least, most)) * (random.GetBits() % 2 ? 1.0 : -1.0);
}

Vector GetAcross(const Vector& vector, const Vector& direction)
{
  return Normalize(lms3dCross(direction, lms3dCross(vector, direction)));
}

Attack MakeNeedle(Random& random)
{
  const Vector a = random.GetDirection();
  const Vector p = random.Get(0.3, 2.0) * random.GetDirection();
  const Vector along = Normalize(p);
  const Vector v = GetAcross(lms3dCross(a, p), along);
  const double width = std::pow(10.0, random.Get(-13.0, -10.5));
  Attack attack;
  attack.Second = { a, a + p,
    a + random.Get(0.3, 0.7) * p + width * GetAcross(random.GetDirection(), along) };
  attack.First =
    Scale({ a - p - v, a + 2.0 * p - v, a + 0.5 * p + 2.0 * v }, GetNearlyOne(random, -5.5, -4.0));
  for (Vector& beam : attack.Beams)
  {
    beam = Normalize(random.Get() * attack.Second[0] + random.Get() * attack.Second[1] +
      random.Get() * attack.Second[2]);
  }
  return attack;
}

Attack MakeTinyTriangles(Random& random)
{
  const Vector a = random.GetDirection();
  const Vector p = random.GetDirection();
  const Vector across = GetAcross(p, a);
  const Vector normal = lms3dCross(a, across);
  const double size = std::pow(10.0, random.Get(-12.5, -9.5));
  Attack attack;
  for (Corners* corners : { &attack.First, &attack.Second })
  {
    const Vector q = random.Get(-1.0, 1.0) * a + random.Get(-1.0, 1.0) * across +
      std::pow(10.0, random.Get(-6.0, -4.0)) * random.GetDirection();
    *corners = { a, a + size * p, a + size * q };
  }
  for (Vector& beam : attack.Beams)
  {
    const double tilt = std::pow(10.0, random.Get(-7.0, -4.0)) * random.Get(-1.0, 1.0);
    beam = Normalize(random.Get(-1.0, 1.0) * a + random.Get(-1.0, 1.0) * across + tilt * normal);
  }
  return attack;
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
