// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Patches/lms3dPlane.h"

namespace
{
// The weight of the plane that faces the sensor. It decides what the returns leave open, and is too
// small to change what they determine.
constexpr double FacingWeight = 1e-10;

// Solves m x = right by the factors L D L^T. The weight above leaves pivots of 1e-10, which would
// be lost in a determinant.
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

void lms3dPlaneFit::Add(const lms3dVector& point)
{
  const auto& [x, y, z] = point;
  const std::array<double, 6> products = { x * x, x * y, x * z, y * y, y * z, z * z };
  this->Count += 1.0;
  this->Sum = lms3dAdd(this->Sum, point);
  for (int i = 0; i < 6; ++i)
  {
    this->Products[i] += products[i];
  }
}

void lms3dPlaneFit::Add(const lms3dBeamSphere& sphere, int column, int firstRow, int lastRow)
{
  if (!sphere.IsRegular())
  {
    for (int row = firstRow; row <= lastRow; ++row)
    {
      const lms3dBeamSphere::GridIndex index = sphere.GetIndex(column, row);
      if (!sphere.IsPoleCopy(index))
      {
        this->Add(lms3dScale(sphere.GetDirection(index), sphere.GetRange(index)));
      }
    }
    return;
  }
  const double* ranges = sphere.GetRanges() + sphere.GetIndex(column, 0);
  // In the plane of the column, a return has two coordinates.
  double sumX = 0.0;
  double sumZ = 0.0;
  double xx = 0.0;
  double xz = 0.0;
  double zz = 0.0;
  int count = 0;
  for (int row = firstRow; row <= lastRow; ++row)
  {
    if (sphere.IsPoleRow(row) && column > 0)
    {
      continue;
    }
    const double x = ranges[row] * sphere.GetCosines()[row];
    const double z = ranges[row] * sphere.GetSines()[row];
    sumX += x;
    sumZ += z;
    xx += x * x;
    xz += x * z;
    zz += z * z;
    ++count;
  }
  const std::array<double, 2>& axis = sphere.GetHorizontal(column);
  this->Count += count;
  this->Sum[0] += sumX * axis[0];
  this->Sum[1] += sumX * axis[1];
  this->Sum[2] += sumZ;
  this->Products[0] += xx * axis[0] * axis[0];
  this->Products[1] += xx * axis[0] * axis[1];
  this->Products[2] += xz * axis[0];
  this->Products[3] += xx * axis[1] * axis[1];
  this->Products[4] += xz * axis[1];
  this->Products[5] += zz;
}

void lms3dPlaneFit::Add(const lms3dBeamSphere& sphere, lms3dBeamSphere::GridIndex index)
{
  const int row = sphere.GetRow(index);
  // For a pole, the entry in column 0.
  this->Add(sphere, sphere.IsPoleRow(row) ? 0 : sphere.GetColumn(index), row, row);
}

void lms3dPlaneFit::Add(const lms3dPlaneFit& other)
{
  this->Count += other.Count;
  this->Sum = lms3dAdd(this->Sum, other.Sum);
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
  // The plane through the mean m of the returns that faces the sensor is m / m.m. Solving for the
  // difference from it preserves precision.
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
  return { lms3dAdd(facing, difference) };
}
