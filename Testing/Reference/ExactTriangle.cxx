// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ExactTriangle.h"

#include "ExactExpansion.h"

#include <array>
#include <cmath>
#include <utility>

namespace
{
using Quad = ExactTriangle::Quad;
using Vector = ExactTriangle::Vector;

// Widens ranges, far beyond the rounding of a double.
constexpr double Margin = 1e-14;

template <typename Number>
using Triple = std::array<Number, 3>;

template <typename Number>
Triple<Number> Subtract(const Vector& p, const Vector& q)
{
  return { Number(p[0]) - Number(q[0]), Number(p[1]) - Number(q[1]), Number(p[2]) - Number(q[2]) };
}

template <typename Number>
Number GetDeterminant(const Triple<Number>& p, const Triple<Number>& q, const Triple<Number>& r)
{
  return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
    p[2] * (q[0] * r[1] - q[1] * r[0]);
}

template <typename Number>
Number GetMagnitude(const Number& x)
{
  return x < 0 ? -x : x;
}

// No determinant's terms sum to more than this.
template <typename Number>
Number GetSize(const Triple<Number>& p, const Triple<Number>& q, const Triple<Number>& r)
{
  Number size = 1;
  for (const Triple<Number>* t : { &p, &q, &r })
  {
    size = size * (GetMagnitude((*t)[0]) + GetMagnitude((*t)[1]) + GetMagnitude((*t)[2]));
  }
  return size;
}

// Two units in the last place of 1.
template <typename Number>
Number GetPrecision()
{
  Number unit = 1;
  while (Number(1) + unit / 2 != Number(1))
  {
    unit = unit / 2;
  }
  return 2 * unit;
}

/// Two points of a beam's path seen from where the determinant's origin is, and its direction.
struct Edge
{
  const Vector* Direction;
  const Vector* Origin;
  const Vector* P;
  const Vector* Q;
};

// A determinant rounds 10 times at most on the way to a term: below 5 such precisions of its size.
template <typename Number>
int GetCertainSign(const Edge& edge)
{
  static const Number bound = 8 * GetPrecision<Number>();
  const Vector& d = *edge.Direction;
  const Triple<Number> direction = { Number(d[0]), Number(d[1]), Number(d[2]) };
  const Triple<Number> p = Subtract<Number>(*edge.P, *edge.Origin);
  const Triple<Number> q = Subtract<Number>(*edge.Q, *edge.Origin);
  const Number value = GetDeterminant(direction, p, q);
  const Number error = bound * GetSize(direction, p, q);
  return (value > error) - (value < -error);
}

int GetExactSign(const Edge& edge)
{
  const Vector& d = *edge.Direction;
  const Triple<ExactExpansion> direction = { ExactExpansion(d[0]), ExactExpansion(d[1]),
    ExactExpansion(d[2]) };
  return GetDeterminant(direction, Subtract<ExactExpansion>(*edge.P, *edge.Origin),
    Subtract<ExactExpansion>(*edge.Q, *edge.Origin))
    .GetSign();
}

int GetSign(const Edge& edge)
{
  int sign = GetCertainSign<double>(edge);
  sign = sign != 0 ? sign : GetCertainSign<Quad>(edge);
  return sign != 0 ? sign : GetExactSign(edge);
}

/// The plane's offset and slope, whose quotient is the range.
template <typename Number>
std::pair<Number, Number> GetPlane(
  const Vector* const* corners, const Vector& origin, const Vector& d)
{
  const Triple<Number> p = Subtract<Number>(*corners[1], *corners[0]);
  const Triple<Number> q = Subtract<Number>(*corners[2], *corners[0]);
  return { GetDeterminant(Subtract<Number>(*corners[0], origin), p, q),
    GetDeterminant({ Number(d[0]), Number(d[1]), Number(d[2]) }, p, q) };
}

// Whether quadruple precision keeps 24 digits of a plane's offset and slope.
bool IsWide(const Quad& offset, const Quad& slope, const Vector* const* corners,
  const Vector& origin, const Vector& d)
{
  static const Quad share = 1e25 * GetPrecision<Quad>();
  const Triple<Quad> p = Subtract<Quad>(*corners[1], *corners[0]);
  const Triple<Quad> q = Subtract<Quad>(*corners[2], *corners[0]);
  const Triple<Quad> a = Subtract<Quad>(*corners[0], origin);
  return GetMagnitude(offset) > share * GetSize(a, p, q) &&
    GetMagnitude(slope) > share * GetSize<Quad>({ d[0], d[1], d[2] }, p, q);
}
} // namespace

bool ExactTriangle::IsInside(const Vector& origin, const Vector& direction) const
{
  bool isLeft = false;
  bool isRight = false;
  for (int i = 0; i < 3 && !(isLeft && isRight); ++i)
  {
    const int sign =
      GetSign({ &direction, &origin, this->Corners[(i + 1) % 3], this->Corners[(i + 2) % 3] });
    isLeft = isLeft || sign > 0;
    isRight = isRight || sign < 0;
  }
  return isLeft != isRight;
}

bool ExactTriangle::IsOutOfReach(const Vector& origin, const Vector& d, double limit) const
{
  static const double bound = 8 * GetPrecision<double>();
  const Triple<double> p = Subtract<double>(*this->Corners[1], *this->Corners[0]);
  const Triple<double> q = Subtract<double>(*this->Corners[2], *this->Corners[0]);
  const Triple<double> a = Subtract<double>(*this->Corners[0], origin);
  const double offset = GetDeterminant(a, p, q);
  const double slope = GetDeterminant<double>(d, p, q);
  const double offsetError = bound * GetSize(a, p, q);
  const double slopeError = bound * GetSize<double>(d, p, q);
  if (std::abs(offset) <= offsetError || std::abs(slope) <= slopeError)
  {
    return false;
  }
  const double least = (std::abs(offset) - offsetError) / (std::abs(slope) + slopeError);
  return (offset < 0.0) != (slope < 0.0) || least > limit * (1.0 + Margin);
}

ExactReference::Quad ExactTriangle::GetRange(const Vector& origin, const Vector& direction) const
{
  // The beam crosses the plane, so the slope is not 0.
  const auto [offset, slope] = GetPlane<Quad>(this->Corners, origin, direction);
  if (IsWide(offset, slope, this->Corners, origin, direction))
  {
    return offset / slope;
  }
  const auto [exactOffset, exactSlope] = GetPlane<ExactExpansion>(this->Corners, origin, direction);
  return exactOffset.GetValue() / exactSlope.GetValue();
}
