// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/FreeFixtures.h"

#include "Fixtures/BeamFixtures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
struct Box
{
  explicit Box(const lms3dTriangleMesh& mesh)
  {
    this->Low.fill(std::numeric_limits<double>::infinity());
    this->High.fill(-std::numeric_limits<double>::infinity());
    for (const Vector& point : mesh.Points)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Low[axis] = std::min(this->Low[axis], point[axis]);
        this->High[axis] = std::max(this->High[axis], point[axis]);
      }
    }
  }

  Vector GetPoint(Random& random) const
  {
    Vector point;
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = random.Get(this->Low[axis], this->High[axis]);
    }
    return point;
  }

  double GetDiagonal() const { return GetLength(this->High - this->Low); }

  Vector Low;
  Vector High;
};

// A corner, a point of an edge or a point inside of some triangle.
Vector GetPointOfTriangle(const lms3dTriangleMesh& mesh, Aims aims, Random& random)
{
  const std::size_t triangle = random.GetBits() % mesh.GetNumberOfTriangles();
  const int first = static_cast<int>(random.GetBits() % 3);
  Vector corner[3];
  for (int i = 0; i < 3; ++i)
  {
    std::copy_n(mesh.GetCorner(triangle, (first + i) % 3), 3, corner[i].begin());
  }
  if (aims == Aims::Faces)
  {
    const double u = random.Get(0.1, 0.4);
    const double v = random.Get(0.1, 0.4);
    return (1.0 - u - v) * corner[0] + u * corner[1] + v * corner[2];
  }
  switch (random.GetBits() % 4)
  {
    case 0:
      return corner[0];
    case 1:
      return 0.5 * (corner[0] + corner[1]);
    default:
    {
      const double u = random.Get();
      const double v = random.Get() * (1.0 - u);
      return (1.0 - u - v) * corner[0] + u * corner[1] + v * corner[2];
    }
  }
}

Vector GetStart(const lms3dTriangleMesh& mesh, const Box& box, Starts starts, Random& random)
{
  switch (starts)
  {
    case Starts::OnTriangles:
      return GetPointOfTriangle(mesh, Aims::Everywhere, random);
    case Starts::Mixed:
    {
      // The exponent of a distance of a thousandth of a diagonal to 1e7 diagonals.
      const double distance = box.GetDiagonal() * std::pow(10.0, random.Get(-3.0, 7.0));
      const Vector inside = box.GetPoint(random);
      return random.GetBits() % 2 ? inside : inside + distance * random.GetDirection();
    }
    default:
      return box.GetPoint(random);
  }
}

Vector GetDirection(const lms3dTriangleMesh& mesh, const Vector& start, Aims aims, Random& random)
{
  const std::uint64_t kind = aims == Aims::Faces ? 2 : random.GetBits() % 8;
  if (kind == 0)
  {
    return random.GetDirection();
  }
  if (kind == 1)
  {
    Vector axis = { 0.0, 0.0, 0.0 };
    axis[random.GetBits() % 3] = random.GetBits() % 2 ? 1.0 : -1.0;
    axis[random.GetBits() % 3] += random.GetBits() % 2 ? -1e-17 : 0.0;
    return axis;
  }
  const Vector towards = GetPointOfTriangle(mesh, aims, random) - start;
  return GetLength(towards) > 0.0 ? Normalize(towards) : random.GetDirection();
}
} // namespace

void FillFreePacket(
  const lms3dTriangleMesh& mesh, Starts starts, Aims aims, Random& random, lms3dFreePacket& packet)
{
  const Box box(mesh);
  const Vector center = box.GetPoint(random);
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    const Vector start = starts == Starts::Footprint
      ? center + 1e-3 * box.GetDiagonal() * random.GetDirection()
      : GetStart(mesh, box, starts, random);
    const Vector direction = GetDirection(mesh, start, aims, random);
    for (int axis = 0; axis < 3; ++axis)
    {
      packet.Origin[axis][beam] = start[axis];
      packet.Direction[axis][beam] = direction[axis];
    }
  }
}

lms3dBeamPacket MakeLonelyPacket(const lms3dFreePacket& packet, int beam)
{
  Vector direction;
  for (int axis = 0; axis < 3; ++axis)
  {
    direction[axis] = packet.Direction[axis][beam];
  }
  lms3dBeamPacket lonely = MakePacket(MakeSame(direction));
  lonely.Active = 1u << beam;
  return lonely;
}

lms3dRayOrigin GetRayOrigin(const lms3dFreePacket& packet, int beam, double maximumRange)
{
  return { { packet.Origin[0][beam], packet.Origin[1][beam], packet.Origin[2][beam] },
    maximumRange };
}
