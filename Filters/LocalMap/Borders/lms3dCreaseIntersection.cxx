// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dCreaseIntersection.h"

#include <algorithm>

namespace
{
// The coordinates of a cell's corners.
constexpr double X[4] = { 0.0, 0.0, 1.0, 1.0 };
constexpr double Y[4] = { 0.0, 1.0, 1.0, 0.0 };
constexpr double Margin = 0.1;
constexpr double Damping = 1e-9;
} // namespace

void lms3dCreaseIntersection::Move(const lms3dPoint2& offset)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    this->Point[axis] = std::min(1.0 - Margin, std::max(Margin, this->Point[axis] + offset[axis]));
  }
}

void lms3dCreaseIntersection::Solve()
{
  constexpr int Iterations = 4;
  if (this->Count == 0)
  {
    return;
  }
  for (int i = 0; i < Iterations; ++i)
  {
    this->Step();
  }
}

std::array<double, 4> lms3dCreaseIntersection::GetWeights() const
{
  std::array<double, 4> weights;
  for (int i = 0; i < 4; ++i)
  {
    weights[i] = (X[i] > 0.5 ? this->Point[0] : 1.0 - this->Point[0]) *
      (Y[i] > 0.5 ? this->Point[1] : 1.0 - this->Point[1]);
  }
  return weights;
}

void lms3dCreaseIntersection::Step()
{
  const double x = this->Point[0];
  const double y = this->Point[1];
  double xx = 0.0, xy = 0.0, yy = 0.0, xf = 0.0, yf = 0.0;
  for (int i = 0; i < this->Count; ++i)
  {
    const std::array<double, 4>& f = this->Creases[i];
    const double fx = (f[3] - f[0]) * (1.0 - y) + (f[2] - f[1]) * y;
    const double fy = (f[1] - f[0]) * (1.0 - x) + (f[2] - f[3]) * x;
    const double value =
      (f[0] * (1.0 - x) + f[3] * x) * (1.0 - y) + (f[1] * (1.0 - x) + f[2] * x) * y;
    xx += fx * fx;
    xy += fx * fy;
    yy += fy * fy;
    xf += fx * value;
    yf += fy * value;
  }
  // The damping keeps the point in place along a single crease.
  const double damping = Damping * (xx + yy);
  const double determinant = (xx + damping) * (yy + damping) - xy * xy;
  if (determinant > 0.0)
  {
    this->Move({ -((yy + damping) * xf - xy * yf) / determinant,
      -((xx + damping) * yf - xy * xf) / determinant });
  }
}
