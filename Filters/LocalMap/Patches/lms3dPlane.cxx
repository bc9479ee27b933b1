// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dPlane.h"

namespace
{
// The weight of the plane that faces the sensor: enough to decide what returns leave open, too
// little to move what they determine.
constexpr double FacingWeight = 1e-10;

// By the factors L D L^T: the weight leaves pivots of 1e-10, which a determinant would drown.
lms3dVector Solve(const std::array<double, 6>& m, const lms3dVector& right)
{
  const double d0 = m[0];
  const double l10 = m[1] / d0;
  const double l20 = m[2] / d0;
  const double d1 = m[3] - l10 * m[1];
  const double e21 = m[4] - l10 * m[2];
  const double l21 = e21 / d1;
  const double d2 = m[5] - l20 * m[2] - l21 * e21;

  const double y0 = right[0];
  const double y1 = right[1] - l10 * y0;
  const double y2 = right[2] - l20 * y0 - l21 * y1;

  const double z = y2 / d2;
  const double y = y1 / d1 - l21 * z;
  return { y0 / d0 - l10 * y - l20 * z, y, z };
}
} // namespace

void lms3dPlaneFit::Add(const lms3dBeamSphere& sphere, int column, int firstRow, int lastRow)
{
  const double* ranges = sphere.GetRanges() + sphere.GetIndex(column, 0);
  // Within the column's own plane a return has two coordinates.
  double level = 0.0;
  double up = 0.0;
  double levelLevel = 0.0;
  double levelUp = 0.0;
  double upUp = 0.0;
  int count = 0;
  for (int row = firstRow; row <= lastRow; ++row)
  {
    if (sphere.IsPoleRow(row) && column > 0)
    {
      continue;
    }
    const double x = ranges[row] * sphere.GetCosines()[row];
    const double z = ranges[row] * sphere.GetSines()[row];
    level += x;
    up += z;
    levelLevel += x * x;
    levelUp += x * z;
    upUp += z * z;
    ++count;
  }
  const std::array<double, 2>& axis = sphere.GetLevel(column);
  this->Count += count;
  this->Sum[0] += level * axis[0];
  this->Sum[1] += level * axis[1];
  this->Sum[2] += up;
  this->Products[0] += levelLevel * axis[0] * axis[0];
  this->Products[1] += levelLevel * axis[0] * axis[1];
  this->Products[2] += levelUp * axis[0];
  this->Products[3] += levelLevel * axis[1] * axis[1];
  this->Products[4] += levelUp * axis[1];
  this->Products[5] += upUp;
}

void lms3dPlaneFit::Add(const lms3dBeamSphere& sphere, lms3dBeamSphere::GridIndex index)
{
  const int row = sphere.GetRow(index);
  // Whichever of a pole's places it is.
  this->Add(sphere, sphere.IsPoleRow(row) ? 0 : sphere.GetColumn(index), row, row);
}

void lms3dPlaneFit::Add(const lms3dPlaneFit& other)
{
  this->Count += other.Count;
  for (int i = 0; i < 3; ++i)
  {
    this->Sum[i] += other.Sum[i];
  }
  for (int i = 0; i < 6; ++i)
  {
    this->Products[i] += other.Products[i];
  }
}

lms3dPlane lms3dPlaneFit::GetPlane() const
{
  const double square = lms3dDot(this->Sum, this->Sum);
  const double weight = FacingWeight * (this->Products[0] + this->Products[3] + this->Products[5]);
  std::array<double, 6> matrix = this->Products;
  matrix[0] += weight;
  matrix[3] += weight;
  matrix[5] += weight;
  // The plane through the mean m of the returns that faces the sensor is m / m.m. To fit the
  // difference from it keeps its digits.
  lms3dVector facing;
  for (int i = 0; i < 3; ++i)
  {
    facing[i] = this->Sum[i] * this->Count / square;
  }
  const std::array<double, 6>& p = this->Products;
  const lms3dVector rest = { this->Sum[0] -
      (p[0] * facing[0] + p[1] * facing[1] + p[2] * facing[2]),
    this->Sum[1] - (p[1] * facing[0] + p[3] * facing[1] + p[4] * facing[2]),
    this->Sum[2] - (p[2] * facing[0] + p[4] * facing[1] + p[5] * facing[2]) };
  const lms3dVector difference = Solve(matrix, rest);
  return { { facing[0] + difference[0], facing[1] + difference[1], facing[2] + difference[2] } };
}

double lms3dPlaneFit::GetSquaredResidual(const lms3dPlane& plane) const
{
  const lms3dVector& q = plane.Q;
  const std::array<double, 6>& p = this->Products;
  return q[0] * q[0] * p[0] + q[1] * q[1] * p[3] + q[2] * q[2] * p[5] +
    2.0 * (q[0] * q[1] * p[1] + q[0] * q[2] * p[2] + q[1] * q[2] * p[4]) -
    2.0 * lms3dDot(q, this->Sum) + this->Count;
}
