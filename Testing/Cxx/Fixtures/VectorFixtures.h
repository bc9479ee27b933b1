// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Numbers and vectors for tests below VTK.
 */
#ifndef VectorFixtures_h
#define VectorFixtures_h

#include <array>
#include <cstdint>

using Vector = std::array<double, 3>;

/// The same sequence everywhere for the same seed (SplitMix64).
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : State(seed)
  {
  }
  /// All 64 bits.
  std::uint64_t GetBits();
  /// From 0 up to, not including, 1.
  double Get() { return static_cast<double>(this->GetBits() >> 11) * 0x1p-53; }
  double Get(double low, double high) { return low + (high - low) * this->Get(); }
  /// A vector on the unit sphere.
  Vector GetDirection();

private:
  std::uint64_t State;
};

Vector operator+(const Vector& p, const Vector& q);
Vector operator-(const Vector& p, const Vector& q);
Vector operator*(double factor, const Vector& p);
double GetLength(const Vector& p);
Vector Normalize(const Vector& p);
/// Turned by two angles that are not multiples of a simple fraction of a circle.
Vector Turn(const Vector& p);

#endif
