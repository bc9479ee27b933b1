// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Where a beam truly meets a triangle, decided without rounding.
 */
#ifndef ExactTriangle_h
#define ExactTriangle_h

#include "ExactReference.h"

/// Refers to corners that must live longer.
class ExactTriangle
{
public:
  using Quad = ExactReference::Quad;
  using Vector = ExactReference::Vector;

  ExactTriangle(const Vector& a, const Vector& b, const Vector& c)
    : Corners{ &a, &b, &c }
  {
  }

  /// Whether the line along a beam crosses the triangle.
  bool IsInside(const Vector& origin, const Vector& direction) const;

  /// Whether double precision proves that the plane is behind the origin, or beyond a limit.
  bool IsOutOfReach(const Vector& origin, const Vector& direction, double limit) const;

  /// The range of the plane. The line along the beam must cross the triangle.
  Quad GetRange(const Vector& origin, const Vector& direction) const;

private:
  const Vector* Corners[3];
};

#endif
