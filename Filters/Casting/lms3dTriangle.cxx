// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting/lms3dTriangle.h"

#include "Geometry/lms3dExactSum.h"

#include <algorithm>
#include <cmath>

namespace
{
// Four for each of the 48 products of a determinant.
using ExactSum = lms3dExactSum<192>;

/// p - q as the sum of two doubles for each axis, the rounding error last.
using Difference = std::array<std::array<double, 2>, 3>;

Difference Subtract(const double* p, const double* q)
{
  Difference difference;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double rounded = p[axis] - q[axis];
    const double part = rounded - p[axis];
    difference[axis] = { rounded, (p[axis] - (rounded - part)) - (q[axis] + part) };
  }
  return difference;
}

/// Adds x times the determinant's cofactor of an axis.
void AddCofactor(ExactSum& sum, double x, int axis, const Difference& p, const Difference& q)
{
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  for (int i = 0; i < 4; ++i)
  {
    sum.AddProduct(p[next][i / 2], q[last][i % 2], x);
    sum.AddProduct(p[last][i / 2], q[next][i % 2], -x);
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
    AddCofactor(sum, a[axis][1], axis, p, q);
    AddCofactor(sum, a[axis][0], axis, p, q);
  }
  return sum;
}

double SumOfMagnitudes(const Difference& p)
{
  return std::abs(p[0][0]) + std::abs(p[1][0]) + std::abs(p[2][0]);
}

// Where the sensor is nearer to a plane than this share of the triangle's size or distance, the
// plane's 31 digits leave too few of the range, and may put a sensor that stands on it beside it.
constexpr double NearPlane = 1e-12;

// Above this share of its terms' size a rounded determinant is not 0.
constexpr double RoundingOfDeterminant = 1e-14;
} // namespace

bool lms3dIsInside(const lms3dCorners& corners, const double origin[3], const double direction[3])
{
  const Difference seen[3] = { Subtract(corners[0], origin), Subtract(corners[1], origin),
    Subtract(corners[2], origin) };
  int positive = 0;
  int negative = 0;
  for (int i = 0; i < 3; ++i)
  {
    const int sign = GetDeterminant(direction, seen[(i + 1) % 3], seen[(i + 2) % 3]).GetSign();
    positive += sign > 0;
    negative += sign < 0;
  }
  return (positive == 0) != (negative == 0);
}

bool lms3dHasArea(const lms3dCorners& corners)
{
  const Difference p = Subtract(corners[1], corners[0]);
  const Difference q = Subtract(corners[2], corners[0]);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double x = p[(axis + 1) % 3][0] * q[(axis + 2) % 3][0];
    const double y = p[(axis + 2) % 3][0] * q[(axis + 1) % 3][0];
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

bool lms3dIsEdgeOn(const lms3dCorners& corners, const double origin[3])
{
  const Difference a = Subtract(corners[0], origin);
  const Difference p = Subtract(corners[1], corners[0]);
  const Difference q = Subtract(corners[2], corners[0]);
  double rounded = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    rounded += a[axis][0] * (p[next][0] * q[last][0] - p[last][0] * q[next][0]);
  }
  const double size = SumOfMagnitudes(a) * SumOfMagnitudes(p) * SumOfMagnitudes(q);
  return std::abs(rounded) <= RoundingOfDeterminant * size &&
    GetDeterminant(a, p, q).GetSign() == 0;
}

bool lms3dIsNearPlane(
  const lms3dCorners& corners, const double origin[3], const lms3dSeenPlane& plane)
{
  const double a = SumOfMagnitudes(Subtract(corners[0], origin));
  const double p = SumOfMagnitudes(Subtract(corners[1], corners[0]));
  const double q = SumOfMagnitudes(Subtract(corners[2], corners[0]));
  return std::abs(plane.Offset.High) <= NearPlane * std::max({ a, p, q }) * p * q;
}

void lms3dMeasureNearPlane(const lms3dCorners& corners, const double origin[3],
  const lms3dBeamPacket& packet, double* ranges)
{
  const Difference a = Subtract(corners[0], origin);
  const Difference p = Subtract(corners[1], corners[0]);
  const Difference q = Subtract(corners[2], corners[0]);
  const double offset = GetDeterminant(a, p, q).GetValue();
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    const double direction[3] = { packet.Direction[0][beam], packet.Direction[1][beam],
      packet.Direction[2][beam] };
    ranges[beam] = offset == 0.0 ? 0.0 : offset / GetDeterminant(direction, p, q).GetValue();
  }
}
