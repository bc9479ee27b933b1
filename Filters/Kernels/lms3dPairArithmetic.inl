// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Arithmetic with twice the digits of a double (Dekker 1971, Knuth): pairs whose sum is the
 * number.
 */
#ifndef lms3dPairArithmetic_inl
#define lms3dPairArithmetic_inl

#include "Kernels/lms3dPacketKernels.h"

namespace
{
using Pair = lms3dDoubleDouble;

Pair Add(double x, double y)
{
  const double sum = x + y;
  const double part = sum - x;
  return { sum, (x - (sum - part)) + (y - part) };
}

Pair Subtract(double x, double y)
{
  return Add(x, -y);
}

// Both ways give the exact product.
Pair Multiply(double x, double y)
{
  const double product = x * y;
#ifdef __FMA__
  return { product, __builtin_fma(x, y, -product) };
#else
  const double scaledX = 134217729.0 * x;
  const double scaledY = 134217729.0 * y;
  const double upperX = scaledX - (scaledX - x);
  const double upperY = scaledY - (scaledY - y);
  const double lowerX = x - upperX;
  const double lowerY = y - upperY;
  return { product,
    ((upperX * upperY - product) + upperX * lowerY + lowerX * upperY) + lowerX * lowerY };
#endif
}

Pair Add(const Pair& x, const Pair& y)
{
  const Pair high = Add(x.High, y.High);
  const Pair low = Add(x.Low, y.Low);
  const Pair sum = Add(high.High, high.Low + low.High);
  return Add(sum.High, sum.Low + low.Low);
}

Pair Multiply(const Pair& x, const Pair& y)
{
  const Pair product = Multiply(x.High, y.High);
  return Add(product.High, product.Low + (x.High * y.Low + x.Low * y.High));
}

Pair Negate(const Pair& x)
{
  return { -x.High, -x.Low };
}
} // namespace

#endif
