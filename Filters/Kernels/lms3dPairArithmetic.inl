// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Arithmetic with about twice the digits of a double, on unevaluated sums of two doubles.
 *
 * Source: T. J. Dekker, "A floating-point technique for extending the available precision", 1971.
 * Without fused multiply-add instructions, factors above 1e300 overflow.
 */
#ifndef lms3dPairArithmetic_inl
#define lms3dPairArithmetic_inl

#include "Kernels/lms3dPacketKernels.h"

namespace
{
using Pair = lms3dDoubleDouble;

// Returns the exact sum if |x| >= |y|, or if x is 0.
Pair SumOfLargerFirst(double x, double y)
{
  const double sum = x + y;
  return { sum, y - (sum - x) };
}

// Returns the exact product. Both ways give the same bits unless the error underflows.
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
  const Pair high = lms3dTwoSum(x.High, y.High);
  const Pair low = lms3dTwoSum(x.Low, y.Low);
  const Pair sum = lms3dTwoSum(high.High, high.Low + low.High);
  return lms3dTwoSum(sum.High, sum.Low + low.Low);
}

Pair Multiply(const Pair& x, const Pair& y)
{
  const Pair product = Multiply(x.High, y.High);
  return lms3dTwoSum(product.High, product.Low + (x.High * y.Low + x.Low * y.High));
}

Pair Negate(const Pair& x)
{
  return { -x.High, -x.Low };
}
} // namespace

#endif
