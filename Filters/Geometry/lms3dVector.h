// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Points and directions in three dimensions. Each operation rounds as its formula reads.
 */
#ifndef lms3dVector_h
#define lms3dVector_h

#include <array>
#include <cmath>

using lms3dVector = std::array<double, 3>;

inline double lms3dDot(const lms3dVector& a, const lms3dVector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline lms3dVector lms3dCross(const lms3dVector& a, const lms3dVector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline lms3dVector lms3dSubtract(const lms3dVector& a, const lms3dVector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

/// The same for the coordinates of two points.
inline lms3dVector lms3dSubtract(const double* a, const double* b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline lms3dVector lms3dAdd(const lms3dVector& a, const lms3dVector& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline lms3dVector lms3dScale(const lms3dVector& v, double factor)
{
  return { v[0] * factor, v[1] * factor, v[2] * factor };
}

inline double lms3dGetLength(const lms3dVector& v)
{
  return std::sqrt(lms3dDot(v, v));
}

/// Returns a vector of length 1, or zeros if the length is 0 or not finite.
inline lms3dVector lms3dNormalize(const lms3dVector& v)
{
  const double length = std::hypot(v[0], v[1], v[2]);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return { 0.0, 0.0, 0.0 };
  }
  return { v[0] / length, v[1] / length, v[2] / length };
}

inline bool lms3dIsFinite(const lms3dVector& v)
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

#endif
