// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulation/lms3dOrientation.h"

#include "Geometry/lms3dExactSum.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace
{
constexpr double HalfUlp = std::numeric_limits<double>::epsilon() / 2.0;
// Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust geometric
// predicates": the rounding error of the determinant in plain arithmetic.
constexpr double CircleError = (10.0 + 96.0 * HalfUlp) * HalfUlp;

// Whether products of differences of such points have no rounding error: corners of cells.
bool IsSmallAndWhole(const lms3dPoint2& point)
{
  constexpr double Largest = 1 << 25;
  return std::all_of(point.begin(), point.end(),
    [](double place)
    {
      return std::abs(place) <= Largest &&
        static_cast<double>(static_cast<std::int32_t>(place)) == place;
    });
}
} // namespace

int lms3dGetExactOrientation(const lms3dPoint2& a, const lms3dPoint2& b, const lms3dPoint2& c)
{
  const double left = (a[0] - c[0]) * (b[1] - c[1]);
  const double right = (a[1] - c[1]) * (b[0] - c[0]);
  // Differences of equal coordinates alone are 0.
  const bool areZero = left == 0.0 && right == 0.0;
  if (areZero || (IsSmallAndWhole(a) && IsSmallAndWhole(b) && IsSmallAndWhole(c)))
  {
    return left == right ? 0 : (left > right ? 1 : -1);
  }
  // Six products have two terms each.
  lms3dExactSum<12> exact;
  exact.AddProduct(a[0], b[1]);
  exact.AddProduct(-a[1], b[0]);
  exact.AddProduct(b[0], c[1]);
  exact.AddProduct(-b[1], c[0]);
  exact.AddProduct(c[0], a[1]);
  exact.AddProduct(-c[1], a[0]);
  return exact.GetSign();
}

bool lms3dIsInTriangle(
  const lms3dPoint2& point, const std::array<lms3dPoint2, 3>& triangle, int orientation)
{
  for (int i = 0; i < 3; ++i)
  {
    if (lms3dGetOrientation(triangle[i], triangle[(i + 1) % 3], point) * orientation < 0)
    {
      return false;
    }
  }
  return true;
}

bool lms3dIsInCircle(
  const lms3dPoint2& a, const lms3dPoint2& b, const lms3dPoint2& c, const lms3dPoint2& d)
{
  double x[3];
  double y[3];
  double square[3];
  const lms3dPoint2* points[3] = { &a, &b, &c };
  for (int i = 0; i < 3; ++i)
  {
    x[i] = (*points[i])[0] - d[0];
    y[i] = (*points[i])[1] - d[1];
    square[i] = x[i] * x[i] + y[i] * y[i];
  }
  double determinant = 0.0;
  double size = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const int next = (i + 1) % 3;
    const int last = (i + 2) % 3;
    determinant += square[i] * (x[next] * y[last] - x[last] * y[next]);
    size += square[i] * (std::abs(x[next] * y[last]) + std::abs(x[last] * y[next]));
  }
  return determinant > CircleError * size;
}
