// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Sums and products of doubles without rounding.
 */
#ifndef lms3dExactSum_h
#define lms3dExactSum_h

#include <array>
#include <cmath>

/// Doubles that do not overlap, from the smallest to the largest (Shewchuk 1997, "Adaptive precision
/// floating-point arithmetic and fast robust geometric predicates"). `Capacity` is the most terms that
/// are added: one for a number, two for a product of two and four for one of three.
template <int Capacity>
class lms3dExactSum
{
public:
  void Add(double x)
  {
    int kept = 0;
    for (int i = 0; i < this->Count; ++i)
    {
      const double sum = x + this->Terms[i];
      const double part = sum - x;
      const double error = (x - (sum - part)) + (this->Terms[i] - part);
      this->Terms[kept] = error;
      kept += error != 0.0;
      x = sum;
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

  double GetValue() const
  {
    double sum = 0.0;
    for (int i = 0; i < this->Count; ++i)
    {
      sum += this->Terms[i];
    }
    return sum;
  }

  /// That of the largest term, which outweighs all others.
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
