// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Kernels of range errors: normal deviates, and the ranges that a device reports.
 *
 * The logarithm, sine and cosine are series of our own: the functions of the C library differ in
 * the last bit between processors and versions, and compilers do not vectorize them.
 */
#ifndef lms3dRangeErrorKernels_inl
#define lms3dRangeErrorKernels_inl

#include "Kernels/lms3dPacketMask.inl"

#include <Random123/threefry.h>

namespace
{
constexpr std::uint64_t BitsOfOne = 0x3ff0000000000000u;
constexpr std::uint64_t BitsOfTwo52 = 0x4330000000000000u;
constexpr std::uint64_t FractionBits = 0x000fffffffffffffu;

double FromBits(std::uint64_t bits)
{
  double value;
  __builtin_memcpy(&value, &bits, sizeof value);
  return value;
}

std::uint64_t ToBits(double value)
{
  std::uint64_t bits;
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits;
}

// Returns a number from 1 up to, not including, 2, of the upper 52 bits.
double FromOneToTwo(std::uint64_t bits)
{
  return FromBits((bits >> 12) | BitsOfOne);
}

// Returns the logarithm of x, a normal number above 0: with x = m * 2^e, m between the root of 1/2
// and the root of 2, and s = (m - 1) / (m + 1), it is e ln 2 + 2 (s + s^3 / 3 + s^5 / 5 + ...).
double Logarithm(double x)
{
  const std::uint64_t bits = ToBits(x);
  const double exponent = FromBits((bits >> 52) | BitsOfTwo52) - (0x1p52 + 1023.0);
  const double fraction = FromBits((bits & FractionBits) | BitsOfOne);
  const bool isLarge = fraction > 1.4142135623730951;
  const double m = isLarge ? 0.5 * fraction : fraction;
  const double e = isLarge ? exponent + 1.0 : exponent;
  const double s = (m - 1.0) / (m + 1.0);
  const double q = s * s;
  double sum = 1.0 / 21.0;
  sum = sum * q + 1.0 / 19.0;
  sum = sum * q + 1.0 / 17.0;
  sum = sum * q + 1.0 / 15.0;
  sum = sum * q + 1.0 / 13.0;
  sum = sum * q + 1.0 / 11.0;
  sum = sum * q + 1.0 / 9.0;
  sum = sum * q + 1.0 / 7.0;
  sum = sum * q + 1.0 / 5.0;
  sum = sum * q + 1.0 / 3.0;
  return e * 0.6931471805599453 + 2.0 * (s + s * (q * sum));
}

// For angles from -pi/4 to pi/4.
double SineNearZero(double angle)
{
  const double q = angle * angle;
  double sum = -1.0 / 1307674368000.0;
  sum = sum * q + 1.0 / 6227020800.0;
  sum = sum * q - 1.0 / 39916800.0;
  sum = sum * q + 1.0 / 362880.0;
  sum = sum * q - 1.0 / 5040.0;
  sum = sum * q + 1.0 / 120.0;
  sum = sum * q - 1.0 / 6.0;
  return angle + angle * (q * sum);
}

// For angles from -pi/4 to pi/4.
double CosineNearZero(double angle)
{
  const double q = angle * angle;
  double sum = 1.0 / 20922789888000.0;
  sum = sum * q - 1.0 / 87178291200.0;
  sum = sum * q + 1.0 / 479001600.0;
  sum = sum * q - 1.0 / 3628800.0;
  sum = sum * q + 1.0 / 40320.0;
  sum = sum * q - 1.0 / 720.0;
  sum = sum * q + 1.0 / 24.0;
  sum = sum * q - 0.5;
  return 1.0 + q * sum;
}

// The transform of Box and Muller. The upper bits of `circle` choose an angle in one quarter of the
// circle, its lowest two bits choose the quarter.
void DrawNormals(const lms3dDrawKey& key, int pairs, double* deviates)
{
  const std::uint64_t effectAndTurn = static_cast<std::uint64_t>(key.Effect) << 32 | key.Turn;
  const std::uint64_t seed = key.Seed;
  const std::uint64_t scan = key.Scan;
  for (int pair = 0; pair < pairs; ++pair)
  {
    const threefry2x64_ctr_t counter = { { effectAndTurn, static_cast<std::uint64_t>(pair) } };
    const threefry2x64_key_t cipherKey = { { seed, scan } };
    const threefry2x64_ctr_t random = threefry2x64(counter, cipherKey);
    const double radius = __builtin_sqrt(-2.0 * Logarithm(2.0 - FromOneToTwo(random.v[0])));
    const std::uint64_t circle = random.v[1];
    const double angle = (FromOneToTwo(circle) - 1.5) * 1.5707963267948966;
    const std::uint64_t x = ToBits(radius * CosineNearZero(angle));
    const std::uint64_t y = ToBits(radius * SineNearZero(angle));
    const std::uint64_t swap = (x ^ y) & (0 - (circle & 1u));
    const std::uint64_t sign = (circle & 2u) << 62;
    deviates[2 * pair] = FromBits(x ^ swap ^ sign);
    deviates[2 * pair + 1] = FromBits(y ^ swap ^ sign);
  }
}

// Beyond 2^51 steps a double cannot be nearer to a multiple than it is. Below, the sum with 1.5 *
// 2^52 has no digits after the point.
double RoundToStep(double range, const lms3dRangeErrorModel& model)
{
  const double steps = range * model.StepDenominator / model.StepNumerator;
  const double whole = (steps + 0x1.8p52) - 0x1.8p52;
  return Magnitude(steps) < 0x1p51 ? whole * model.StepNumerator / model.StepDenominator : range;
}

void ReportRanges(
  const lms3dRangeErrorModel& model, const double* deviates, int count, double* ranges)
{
  const lms3dRangeErrorModel errors = model;
  for (int i = 0; i < count; ++i)
  {
    const double noisy = (ranges[i] + errors.Bias) + errors.Noise * deviates[i];
    const double reported = errors.HasSteps ? RoundToStep(noisy, errors) : noisy;
    const bool isReturn = (reported > 0.0) & (reported <= __DBL_MAX__);
    ranges[i] = isReturn ? reported : __builtin_nan("");
  }
}
} // namespace

#endif
