// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Arithmetic without rounding, for the reference of the ray casters.
 *
 * Source: J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
 * predicates", 1997. It shares no code with the tested filters on purpose.
 */
#ifndef ExactExpansion_h
#define ExactExpansion_h

#include "ExactReference.h"

#include <cmath>
#include <cstddef>
#include <vector>

/// A number as a sum of doubles that do not overlap, from the smallest to the largest. Sums and
/// products are exact unless they overflow or underflow.
class ExactExpansion
{
public:
  ExactExpansion() = default;
  explicit ExactExpansion(double x) { this->Add(x); }

  ExactExpansion operator+(const ExactExpansion& other) const { return this->Sum(other, 1.0); }
  ExactExpansion operator-(const ExactExpansion& other) const { return this->Sum(other, -1.0); }

  ExactExpansion operator*(const ExactExpansion& other) const
  {
    ExactExpansion product;
    for (double x : this->Terms)
    {
      for (double y : other.Terms)
      {
        product.Add(std::fma(x, y, -(x * y)));
        product.Add(x * y);
      }
    }
    return product;
  }

  int GetSign() const
  {
    return this->Terms.empty() ? 0 : (this->Terms.back() > 0.0) - (this->Terms.back() < 0.0);
  }

  ExactReference::Quad GetValue() const
  {
    ExactReference::Quad sum = 0;
    for (double term : this->Terms)
    {
      sum += term;
    }
    return sum;
  }

private:
  ExactExpansion Sum(const ExactExpansion& other, double factor) const
  {
    ExactExpansion sum = *this;
    for (double term : other.Terms)
    {
      sum.Add(factor * term);
    }
    return sum;
  }

  // Each step keeps the rounding error of a sum as a term and passes the rounded sum on.
  void Add(double x)
  {
    std::size_t kept = 0;
    for (double term : this->Terms)
    {
      const double sum = x + term;
      const double part = sum - x;
      const double error = (x - (sum - part)) + (term - part);
      if (error != 0.0)
      {
        this->Terms[kept++] = error;
      }
      x = sum;
    }
    this->Terms.resize(kept);
    if (x != 0.0)
    {
      this->Terms.push_back(x);
    }
  }

  std::vector<double> Terms;
};

#endif
