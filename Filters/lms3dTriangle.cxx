// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dTriangle.h"

namespace
{
#ifdef __SIZEOF_FLOAT128__
__extension__ using Quad = __float128;
#else
using Quad = long double;
#endif

using QuadVector = std::array<Quad, 3>;

// Rounding of an edge function relative to |p| |q| in the 1-norm stays below 9 units of 1e-34.
constexpr double QuadEdgeError = 1e-31;

QuadVector Subtract(const double* p, const double* q)
{
  return { Quad(p[0]) - q[0], Quad(p[1]) - q[1], Quad(p[2]) - q[2] };
}

QuadVector Cross(const QuadVector& p, const QuadVector& q)
{
  return { p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0] };
}

Quad Dot(const QuadVector& p, const QuadVector& q)
{
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

Quad SumOfMagnitudes(const QuadVector& p)
{
  Quad sum = 0;
  for (Quad component : p)
  {
    sum += component < 0 ? -component : component;
  }
  return sum;
}

int GetSign(const QuadVector& direction, const QuadVector& p, const QuadVector& q)
{
  const Quad value = Dot(direction, Cross(p, q));
  const Quad error = Quad(QuadEdgeError) * SumOfMagnitudes(p) * SumOfMagnitudes(q);
  return (value > error) - (value < -error);
}
} // namespace

bool lms3dIsInside(const lms3dCorners& corners, const double origin[3], const double direction[3])
{
  const QuadVector d = { direction[0], direction[1], direction[2] };
  const QuadVector seen[3] = { Subtract(corners[0], origin), Subtract(corners[1], origin),
    Subtract(corners[2], origin) };
  int positive = 0;
  int negative = 0;
  for (int i = 0; i < 3; ++i)
  {
    const int sign = GetSign(d, seen[(i + 1) % 3], seen[(i + 2) % 3]);
    positive += sign > 0;
    negative += sign < 0;
  }
  return (positive == 0) != (negative == 0);
}
