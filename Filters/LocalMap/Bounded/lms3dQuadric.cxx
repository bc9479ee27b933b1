// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Bounded/lms3dQuadric.h"

void lms3dQuadric::AddTriangle(const lms3dVector& a, const lms3dVector& b, const lms3dVector& c)
{
  const lms3dVector normal = lms3dCross(lms3dSubtract(b, a), lms3dSubtract(c, a));
  const double length = lms3dGetLength(normal);
  if (!(length > 0.0))
  {
    return;
  }
  const auto& [x, y, z] = normal;
  const double weight = 0.5 / length;
  const double offset = -lms3dDot(normal, a);
  const std::array<double, 6> products = { x * x, x * y, x * z, y * y, y * z, z * z };
  for (int i = 0; i < 6; ++i)
  {
    this->Matrix[i] += weight * products[i];
  }
  this->Linear = lms3dAdd(this->Linear, lms3dScale(normal, weight * offset));
  this->Constant += weight * offset * offset;
}

void lms3dQuadric::AddPoint(const lms3dVector& point, double weight)
{
  this->Matrix[0] += weight;
  this->Matrix[3] += weight;
  this->Matrix[5] += weight;
  this->Linear = lms3dSubtract(this->Linear, lms3dScale(point, weight));
  this->Constant += weight * lms3dDot(point, point);
}

void lms3dQuadric::Add(const lms3dQuadric& other)
{
  for (int i = 0; i < 6; ++i)
  {
    this->Matrix[i] += other.Matrix[i];
  }
  this->Linear = lms3dAdd(this->Linear, other.Linear);
  this->Constant += other.Constant;
}

double lms3dQuadric::GetValue(const lms3dVector& point) const
{
  const auto& [x, y, z] = point;
  const std::array<double, 6>& m = this->Matrix;
  return m[0] * x * x + 2.0 * m[1] * x * y + 2.0 * m[2] * x * z + m[3] * y * y +
    2.0 * m[4] * y * z + m[5] * z * z + 2.0 * lms3dDot(this->Linear, point) + this->Constant;
}

lms3dVector lms3dQuadric::GetMinimum() const
{
  const std::array<double, 6>& m = this->Matrix;
  const lms3dVector x = { m[0], m[1], m[2] };
  const lms3dVector y = { m[1], m[3], m[4] };
  const lms3dVector z = { m[2], m[4], m[5] };
  const lms3dVector right = lms3dScale(this->Linear, -1.0);
  const double determinant = lms3dDot(x, lms3dCross(y, z));
  return { lms3dDot(right, lms3dCross(y, z)) / determinant,
    lms3dDot(x, lms3dCross(right, z)) / determinant,
    lms3dDot(x, lms3dCross(y, right)) / determinant };
}
