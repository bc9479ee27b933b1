// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/lms3dTransform.h"

#include "Geometry/lms3dVector.h"

#include <algorithm>
#include <cmath>

lms3dTransform lms3dTransform::Translation(const std::array<double, 3>& offset)
{
  lms3dTransform result;
  for (int row = 0; row < 3; ++row)
  {
    result.Rows[row][3] = offset[row];
  }
  return result;
}

lms3dTransform lms3dTransform::Scale(const std::array<double, 3>& factors)
{
  lms3dTransform result;
  for (int row = 0; row < 3; ++row)
  {
    result.Rows[row][row] = factors[row];
  }
  return result;
}

// Rodrigues' formula.
lms3dTransform lms3dTransform::Rotation(const std::array<double, 4>& axisAndAngle)
{
  const lms3dVector axis = lms3dNormalize({ axisAndAngle[0], axisAndAngle[1], axisAndAngle[2] });
  if (lms3dDot(axis, axis) == 0.0)
  {
    return {};
  }
  const double sine = std::sin(axisAndAngle[3]);
  const double cosine = std::cos(axisAndAngle[3]);
  std::array<lms3dVector, 3> images;
  for (int column = 0; column < 3; ++column)
  {
    lms3dVector unit = { 0, 0, 0 };
    unit[column] = 1.0;
    const lms3dVector turned = lms3dCross(axis, unit);
    for (int i = 0; i < 3; ++i)
    {
      images[column][i] =
        cosine * unit[i] + sine * turned[i] + (1.0 - cosine) * axis[column] * axis[i];
    }
  }
  return Frame(images[0], images[1], images[2]);
}

lms3dTransform lms3dTransform::Frame(
  const std::array<double, 3>& x, const std::array<double, 3>& y, const std::array<double, 3>& z)
{
  lms3dTransform result;
  for (int row = 0; row < 3; ++row)
  {
    result.Rows[row] = { x[row], y[row], z[row], 0.0 };
  }
  return result;
}

lms3dTransform lms3dTransform::operator*(const lms3dTransform& first) const
{
  lms3dTransform result;
  for (int row = 0; row < 3; ++row)
  {
    const std::array<double, 4>& r = this->Rows[row];
    for (int column = 0; column < 4; ++column)
    {
      result.Rows[row][column] = r[0] * first.Rows[0][column] + r[1] * first.Rows[1][column] +
        r[2] * first.Rows[2][column] + (column == 3 ? r[3] : 0.0);
    }
  }
  return result;
}

std::array<double, 3> lms3dTransform::Apply(const std::array<double, 3>& p) const
{
  std::array<double, 3> image;
  for (int i = 0; i < 3; ++i)
  {
    const std::array<double, 4>& r = this->Rows[i];
    image[i] = r[0] * p[0] + r[1] * p[1] + r[2] * p[2] + r[3];
  }
  return image;
}

// The square of the largest stretch is an eigenvalue of M^T M, so the row sum norm bounds it.
double lms3dTransform::GetLargestScale() const
{
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    double sum = 0.0;
    for (int j = 0; j < 3; ++j)
    {
      double product = 0.0;
      for (int row = 0; row < 3; ++row)
      {
        product += this->Rows[row][i] * this->Rows[row][j];
      }
      sum += std::abs(product);
    }
    largest = std::max(largest, sum);
  }
  return std::sqrt(largest);
}

bool lms3dTransform::IsMirror() const
{
  const auto row = [this](int i) -> lms3dVector {
    return { this->Rows[i][0], this->Rows[i][1], this->Rows[i][2] };
  };
  return lms3dDot(row(0), lms3dCross(row(1), row(2))) < 0.0;
}

bool lms3dTransform::IsFinite(double largestCoordinate) const
{
  return std::all_of(this->Rows.begin(), this->Rows.end(),
    [largestCoordinate](const std::array<double, 4>& r)
    {
      const double sum = std::abs(r[0]) + std::abs(r[1]) + std::abs(r[2]);
      return std::isfinite(sum * largestCoordinate + std::abs(r[3]));
    });
}
