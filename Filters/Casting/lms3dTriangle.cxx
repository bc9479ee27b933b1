// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dTriangle.h"

#include "Casting/lms3dPacketBeams.h"
#include "Geometry/lms3dExactSum.h"
#include "Geometry/lms3dTwoSum.h"

#include <algorithm>
#include <cmath>

namespace
{
// Four terms for each of the 48 products of a determinant.
using ExactSum = lms3dExactSum<192>;

/// p - q without rounding, for each axis.
using Difference = std::array<lms3dDoubleDouble, 3>;

Difference Subtract(const double* p, const double* q)
{
  return { lms3dTwoDifference(p[0], q[0]), lms3dTwoDifference(p[1], q[1]),
    lms3dTwoDifference(p[2], q[2]) };
}

/// Adds x times one component of the cross product of p and q.
void AddCofactor(ExactSum& sum, double x, int axis, const Difference& p, const Difference& q)
{
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  const double pNext[2] = { p[next].High, p[next].Low };
  const double pLast[2] = { p[last].High, p[last].Low };
  const double qNext[2] = { q[next].High, q[next].Low };
  const double qLast[2] = { q[last].High, q[last].Low };
  for (int i = 0; i < 4; ++i)
  {
    sum.AddProduct(pNext[i / 2], qLast[i % 2], x);
    sum.AddProduct(pLast[i / 2], qNext[i % 2], -x);
  }
}

ExactSum GetDeterminant(const double direction[3], const Difference& p, const Difference& q)
{
  ExactSum sum;
  for (int axis = 0; axis < 3; ++axis)
  {
    AddCofactor(sum, direction[axis], axis, p, q);
  }
  return sum;
}

ExactSum GetDeterminant(const Difference& a, const Difference& p, const Difference& q)
{
  ExactSum sum;
  for (int axis = 0; axis < 3; ++axis)
  {
    AddCofactor(sum, a[axis].Low, axis, p, q);
    AddCofactor(sum, a[axis].High, axis, p, q);
  }
  return sum;
}

double SumOfMagnitudes(const Difference& p)
{
  return std::abs(p[0].High) + std::abs(p[1].High) + std::abs(p[2].High);
}

/// A plane near to where beams start.
class NearPlane
{
public:
  NearPlane(const lms3dCorners& corners, const double origin[3])
    : P(Subtract(corners[1], corners[0]))
    , Q(Subtract(corners[2], corners[0]))
    , Offset(GetDeterminant(Subtract(corners[0], origin), this->P, this->Q).GetValue())
  {
  }

  /// Returns the range of a beam.
  double Intersect(const double direction[3]) const
  {
    return this->Offset == 0.0
      ? 0.0
      : this->Offset / GetDeterminant(direction, this->P, this->Q).GetValue();
  }

private:
  const Difference P;
  const Difference Q;
  const double Offset;
};

// A rounded determinant that exceeds this share of the size of its terms is not 0.
constexpr double RoundingOfDeterminant = 1e-14;

// The inverses of sizes from this one on, metres, do not overflow.
constexpr double MinimumSize = 1e-300;
} // namespace

bool lms3dIsInside(const lms3dCorners& corners, const double origin[3], const double direction[3])
{
  const Difference corner[3] = { Subtract(corners[0], origin), Subtract(corners[1], origin),
    Subtract(corners[2], origin) };
  int positive = 0;
  int negative = 0;
  for (int i = 0; i < 3; ++i)
  {
    const int sign = GetDeterminant(direction, corner[(i + 1) % 3], corner[(i + 2) % 3]).GetSign();
    positive += sign > 0;
    negative += sign < 0;
  }
  return (positive == 0) != (negative == 0);
}

lms3dCornerDirections lms3dGetCornerDirections(const lms3dSensorFrameTriangle& triangle)
{
  lms3dCornerDirections directions;
  for (int i = 0; i < 3; ++i)
  {
    const double(&corner)[3] = triangle.Corner[i];
    const double size = std::abs(corner[0]) + std::abs(corner[1]) + std::abs(corner[2]);
    const double scale = size > MinimumSize ? 1.0 / size : 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      directions.Corner[i][axis] = static_cast<float>(corner[axis] * scale);
    }
  }
  return directions;
}

bool lms3dHasArea(const lms3dCorners& corners)
{
  const Difference p = Subtract(corners[1], corners[0]);
  const Difference q = Subtract(corners[2], corners[0]);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double x = p[(axis + 1) % 3].High * q[(axis + 2) % 3].High;
    const double y = p[(axis + 2) % 3].High * q[(axis + 1) % 3].High;
    if (std::abs(x - y) > RoundingOfDeterminant * (std::abs(x) + std::abs(y)))
    {
      return true;
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    ExactSum component;
    AddCofactor(component, 1.0, axis, p, q);
    if (component.GetSign() != 0)
    {
      return true;
    }
  }
  return false;
}

// The determinant is the product of the normal and the vector from the sensor to the triangle.
int lms3dGetSide(const lms3dCorners& corners, const double origin[3])
{
  const Difference a = Subtract(corners[0], origin);
  const Difference p = Subtract(corners[1], corners[0]);
  const Difference q = Subtract(corners[2], corners[0]);
  double rounded = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    rounded += a[axis].High * (p[next].High * q[last].High - p[last].High * q[next].High);
  }
  const double size = SumOfMagnitudes(a) * SumOfMagnitudes(p) * SumOfMagnitudes(q);
  if (std::abs(rounded) > RoundingOfDeterminant * size)
  {
    return rounded > 0.0 ? -1 : 1;
  }
  return -GetDeterminant(a, p, q).GetSign();
}

bool lms3dIsNearPlane(
  const lms3dCorners& corners, const double origin[3], const lms3dDoubleDoublePlane& plane)
{
  const double a = SumOfMagnitudes(Subtract(corners[0], origin));
  const double p = SumOfMagnitudes(Subtract(corners[1], corners[0]));
  const double q = SumOfMagnitudes(Subtract(corners[2], corners[0]));
  return std::abs(plane.Offset.High) <= lms3dNearPlane * std::max({ a, p, q }) * p * q;
}

double lms3dIntersectNearPlane(
  const lms3dCorners& corners, const double origin[3], const double direction[3])
{
  return NearPlane(corners, origin).Intersect(direction);
}

void lms3dIntersectNearPlane(const lms3dCorners& corners, const double origin[3],
  const lms3dBeamPacket& packet, double* ranges)
{
  const NearPlane plane(corners, origin);
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    ranges[beam] = plane.Intersect(lms3dGetDirection(packet, beam).data());
  }
}
