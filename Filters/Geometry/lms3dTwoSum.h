// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sums and differences of two doubles with their rounding error.
 *
 * Source: D. E. Knuth, The Art of Computer Programming 2, section 4.2.2. The result is exact unless
 * the sum overflows. The compiler must keep the order of the operations (no -ffast-math).
 *
 * The functions are static, so that each source has its own copy: the packet kernels are compiled
 * for instruction sets that not every processor has, and the linker may not mix them.
 */
#ifndef lms3dTwoSum_h
#define lms3dTwoSum_h

/// The number High + Low. High is that number rounded to double.
struct lms3dDoubleDouble
{
  double High;
  double Low;
};

/// Returns x + y without rounding.
static inline lms3dDoubleDouble lms3dTwoSum(double x, double y)
{
  const double sum = x + y;
  const double part = sum - x;
  return { sum, (x - (sum - part)) + (y - part) };
}

/// Returns x - y without rounding.
static inline lms3dDoubleDouble lms3dTwoDifference(double x, double y)
{
  return lms3dTwoSum(x, -y);
}

#endif
