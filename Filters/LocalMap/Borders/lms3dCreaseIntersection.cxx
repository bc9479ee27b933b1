// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalMap/Borders/lms3dCreaseIntersection.h"

#include "LocalMap/Borders/lms3dBorderGates.h"

#include <algorithm>

namespace
{
// The corners of a cell, clockwise from the lower left one.
constexpr double X[4] = { 0.0, 0.0, 1.0, 1.0 };
constexpr double Y[4] = { 0.0, 1.0, 1.0, 0.0 };
constexpr double Margin = lms3dBorderGates::Margin;
} // namespace

void lms3dCreaseIntersection::Move(const lms3dPoint2& offset)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    this->At[axis] = std::min(1.0 - Margin, std::max(Margin, this->At[axis] + offset[axis]));
  }
}

void lms3dCreaseIntersection::Run()
{
  constexpr int Steps = 4;
  for (int step = 0; step<Steps&& this->Count> 0; ++step)
  {
    this->Step();
  }
}

std::array<double, 4> lms3dCreaseIntersection::GetWeights() const
{
  std::array<double, 4> weights;
  for (int i = 0; i < 4; ++i)
  {
    weights[i] = (X[i] > 0.5 ? this->At[0] : 1.0 - this->At[0]) *
      (Y[i] > 0.5 ? this->At[1] : 1.0 - this->At[1]);
  }
  return weights;
}

void lms3dCreaseIntersection::Step()
{
  const double x = this->At[0];
  const double y = this->At[1];
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
  // Along a single crease the point stays where it is.
  const double damping = 1e-9 * (xx + yy);
  const double determinant = (xx + damping) * (yy + damping) - xy * xy;
  if (determinant > 0.0)
  {
    this->Move({ -((yy + damping) * xf - xy * yf) / determinant,
      -((xx + damping) * yf - xy * xf) / determinant });
  }
}
