// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Fixtures/VectorFixtures.h"

#include "Geometry/lms3dVector.h"

#include <vtkMath.h>

#include <cmath>

std::uint64_t Random::GetBits()
{
  this->State += 0x9e3779b97f4a7c15u;
  std::uint64_t bits = this->State;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

Vector Random::GetDirection()
{
  const double z = this->Get(-1.0, 1.0);
  const double angle = this->Get(0.0, 2.0 * vtkMath::Pi());
  const double radius = std::sqrt(1.0 - z * z);
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

Vector operator+(const Vector& p, const Vector& q)
{
  return lms3dAdd(p, q);
}

Vector operator-(const Vector& p, const Vector& q)
{
  return lms3dSubtract(p, q);
}

Vector operator*(double factor, const Vector& p)
{
  return lms3dScale(p, factor);
}

double GetLength(const Vector& p)
{
  return std::hypot(p[0], p[1], p[2]);
}

Vector Normalize(const Vector& p)
{
  return (1.0 / GetLength(p)) * p;
}

Vector Turn(const Vector& p)
{
  const double a = 0.37;
  const double b = 1.13;
  const Vector q = { std::cos(a) * p[0] - std::sin(a) * p[1],
    std::sin(a) * p[0] + std::cos(a) * p[1], p[2] };
  return { q[0], std::cos(b) * q[1] - std::sin(b) * q[2], std::sin(b) * q[1] + std::cos(b) * q[2] };
}
