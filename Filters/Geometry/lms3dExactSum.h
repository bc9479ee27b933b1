// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sums and products of doubles without rounding.
 *
 * Source: J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
 * predicates", 1997. Exact unless a product overflows or its error underflows.
 */
#ifndef lms3dExactSum_h
#define lms3dExactSum_h

#include "Geometry/lms3dTwoSum.h"

#include <array>
#include <cmath>

/// A sum, kept as doubles that do not overlap, from the smallest to the largest. `Capacity` is the
/// maximum number of terms added: one for a number, two for a product of two numbers, four for a
/// product of three.
template <int Capacity>
class lms3dExactSum
{
public:
  void Add(double x)
  {
    int kept = 0;
    for (int i = 0; i < this->Count; ++i)
    {
      const lms3dDoubleDouble sum = lms3dTwoSum(x, this->Terms[i]);
      this->Terms[kept] = sum.Low;
      kept += sum.Low != 0.0;
      x = sum.High;
    }
    this->Terms[kept] = x;
    this->Count = kept + (x != 0.0);
  }

  void AddProduct(double x, double y)
  {
    const double product = x * y;
    if (product != 0.0)
    {
      this->Add(std::fma(x, y, -product));
      this->Add(product);
    }
  }

  void AddProduct(double x, double y, double z)
  {
    const double product = x * y;
    const double error = std::fma(x, y, -product);
    this->AddProduct(product, z);
    this->AddProduct(error, z);
  }

  /// Returns the sum rounded to double, within 1 unit in the last place.
  double GetValue() const
  {
    double sum = 0.0;
    for (int i = 0; i < this->Count; ++i)
    {
      sum += this->Terms[i];
    }
    return sum;
  }

  /// Returns -1, 0 or 1: the sign of the largest term, which exceeds all others together.
  int GetSign() const
  {
    const double largest = this->Count > 0 ? this->Terms[this->Count - 1] : 0.0;
    return (largest > 0.0) - (largest < 0.0);
  }

private:
  std::array<double, Capacity + 1> Terms;
  int Count = 0;
};

#endif
