// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
#include "lms3dTriangleTest.h"

#include <cmath>

namespace
{
#ifdef __SIZEOF_FLOAT128__
__extension__ using Quad = __float128;
#else
using Quad = long double;
#endif

template <typename T>
using Vector = std::array<T, 3>;

template <typename T>
Vector<T> Subtract(const double* p, const double* q)
{
  return { T(p[0]) - T(q[0]), T(p[1]) - T(q[1]), T(p[2]) - T(q[2]) };
}

// Swapping the arguments changes nothing but the sign, to the last bit.
template <typename T>
Vector<T> Cross(const Vector<T>& p, const Vector<T>& q)
{
  return { p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0] };
}

template <typename T>
T Dot(const Vector<T>& p, const Vector<T>& q)
{
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

template <typename T>
T SumOfMagnitudes(const Vector<T>& p)
{
  T sum = 0;
  for (T component : p)
  {
    sum += component < 0 ? -component : component;
  }
  return sum;
}

// Rounding of an edge function relative to |b| |c| in the 1-norm: the differences (1 unit each), the
// cross product (2) and the dot product (3) stay below 9 units; 2e-15 is 18, 1e-31 several hundred.
constexpr double DoubleEdgeError = 2e-15;
constexpr double QuadEdgeError = 1e-31;

// Where the plane's normal is shorter than this share of its edges' product, or nearly at right
// angles to what it is multiplied with, double keeps too few digits of the range.
constexpr double WellConditioned = 1e-3;

template <typename T>
struct Triangle
{
  Triangle(const lms3dCorners& corners, const double origin[3])
    : A(Subtract<T>(corners[0], origin))
    , B(Subtract<T>(corners[1], origin))
    , C(Subtract<T>(corners[2], origin))
    , FirstEdge(Subtract<T>(corners[1], corners[0]))
    , SecondEdge(Subtract<T>(corners[2], corners[0]))
    , Normal(Cross(this->FirstEdge, this->SecondEdge))
  {
  }

  Vector<T> A, B, C;
  Vector<T> FirstEdge, SecondEdge;
  Vector<T> Normal;
};

struct EdgeFunctions
{
  EdgeFunctions(const Triangle<double>& t)
    : Normals{ Cross(t.B, t.C), Cross(t.C, t.A), Cross(t.A, t.B) }
  {
    const double a = SumOfMagnitudes(t.A);
    const double b = SumOfMagnitudes(t.B);
    const double c = SumOfMagnitudes(t.C);
    this->Errors = { DoubleEdgeError * b * c, DoubleEdgeError * c * a, DoubleEdgeError * a * b };
  }

  std::array<Vector<double>, 3> Normals;
  Vector<double> Errors;
};

struct Verdicts
{
  std::uint32_t Hit = 0;
  std::uint32_t Doubt = 0;
};

// Branch-free over the whole packet, so that the compiler can use the processor's wide registers.
Verdicts Classify(const EdgeFunctions& edges, const lms3dBeamPacket& packet)
{
  constexpr int Size = lms3dBeamPacket::Size;
  alignas(64) std::array<std::int64_t, Size> positive{};
  alignas(64) std::array<std::int64_t, Size> negative{};
  for (int edge = 0; edge < 3; ++edge)
  {
    const Vector<double> normal = edges.Normals[edge];
    const double error = edges.Errors[edge];
    for (int i = 0; i < Size; ++i)
    {
      const double value = packet.Direction[0][i] * normal[0] + packet.Direction[1][i] * normal[1] +
        packet.Direction[2][i] * normal[2];
      positive[i] += value > error ? 1 : 0;
      negative[i] += value < -error ? 1 : 0;
    }
  }

  Verdicts verdicts;
  for (int i = 0; i < Size; ++i)
  {
    const bool hit = positive[i] == 3 || negative[i] == 3;
    const bool miss = positive[i] > 0 && negative[i] > 0;
    verdicts.Hit |= static_cast<std::uint32_t>(hit) << i;
    verdicts.Doubt |= static_cast<std::uint32_t>(!hit && !miss) << i;
  }
  return verdicts;
}

int QuadSign(const Vector<Quad>& direction, const Vector<Quad>& p, const Vector<Quad>& q)
{
  const Quad value = Dot(direction, Cross(p, q));
  const Quad error = Quad(QuadEdgeError) * SumOfMagnitudes(p) * SumOfMagnitudes(q);
  return (value > error) - (value < -error);
}

bool IsInside(const Triangle<Quad>& t, const Vector<Quad>& direction)
{
  const int signs[3] = { QuadSign(direction, t.B, t.C), QuadSign(direction, t.C, t.A),
    QuadSign(direction, t.A, t.B) };
  int positive = 0;
  int negative = 0;
  for (int sign : signs)
  {
    positive += sign > 0;
    negative += sign < 0;
  }
  return (positive == 0) != (negative == 0);
}

Vector<double> GetDirection(const lms3dBeamPacket& packet, int beam)
{
  return { packet.Direction[0][beam], packet.Direction[1][beam], packet.Direction[2][beam] };
}

Vector<Quad> Widen(const Vector<double>& v)
{
  return { v[0], v[1], v[2] };
}

double QuadRange(const Triangle<Quad>& t, const Vector<double>& direction)
{
  return static_cast<double>(Dot(t.Normal, t.A) / Dot(t.Normal, Widen(direction)));
}

// The plane's equation, N.p = N.a, with what double needs to keep its digits.
class Plane
{
public:
  Plane(const Triangle<double>& t)
    : Normal(t.Normal)
    , Offset(Dot(t.Normal, t.A))
  {
    const double edges = SumOfMagnitudes(t.FirstEdge) * SumOfMagnitudes(t.SecondEdge);
    this->SmallestSlope = WellConditioned * edges;
    this->OffsetIsExact = std::abs(this->Offset) > this->SmallestSlope * SumOfMagnitudes(t.A);
  }

  bool GetRange(const Vector<double>& direction, double& range) const
  {
    const double slope = Dot(this->Normal, direction);
    range = this->Offset / slope;
    return this->OffsetIsExact && std::abs(slope) > this->SmallestSlope;
  }

private:
  Vector<double> Normal;
  double Offset;
  double SmallestSlope;
  bool OffsetIsExact;
};

bool IsNearer(double range, std::int32_t triangle, const lms3dBeamPacket& packet, int beam)
{
  return range < packet.Range[beam] ||
    (range == packet.Range[beam] && triangle < packet.Triangle[beam]);
}
} // namespace

std::uint32_t lms3dIntersectTriangle(const lms3dCorners& corners, std::int32_t triangle,
  const double origin[3], double maximumRange, lms3dBeamPacket& packet)
{
  const Triangle<double> rounded(corners, origin);
  const Verdicts verdicts = Classify(EdgeFunctions(rounded), packet);
  const std::uint32_t candidates = (verdicts.Hit | verdicts.Doubt) & packet.Active;
  if (candidates == 0)
  {
    return 0;
  }

  const Plane plane(rounded);
  std::uint32_t changed = 0;
  for (int beam = 0; beam < lms3dBeamPacket::Size; ++beam)
  {
    const std::uint32_t bit = 1u << beam;
    if (!(candidates & bit))
    {
      continue;
    }
    const Vector<double> direction = GetDirection(packet, beam);
    if ((verdicts.Doubt & bit) && !IsInside(Triangle<Quad>(corners, origin), Widen(direction)))
    {
      continue;
    }
    double range;
    if (!plane.GetRange(direction, range))
    {
      range = QuadRange(Triangle<Quad>(corners, origin), direction);
    }
    if (range > 0.0 && range <= maximumRange && IsNearer(range, triangle, packet, beam))
    {
      packet.Range[beam] = range;
      packet.Triangle[beam] = triangle;
      changed |= bit;
    }
  }
  return changed;
}

double lms3dPlaneRange(
  const lms3dCorners& corners, const double origin[3], const double direction[3])
{
  const Vector<double> d = { direction[0], direction[1], direction[2] };
  double range;
  if (Plane(Triangle<double>(corners, origin)).GetRange(d, range))
  {
    return range;
  }
  return QuadRange(Triangle<Quad>(corners, origin), d);
}
