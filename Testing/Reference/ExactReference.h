// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief What a beam truly hits, decided without rounding: the oracle of the tests.
 *
 * It shares no code with the ray casters that it judges. "Truly" means for the doubles that it is
 * given: the corners, the origin and the direction are taken as exact numbers. A triangle is closed
 * (an edge or a corner is hit) and has two sides; the range is above 0; a beam within a triangle's
 * plane, and a triangle without area, never hit.
 *
 * A sign is computed in double and in quadruple precision, with a bound of the rounding error.
 * Where both leave it open, in expansions (Shewchuk 1997): sums of doubles that do not overlap,
 * which hold sums and products of doubles exactly as long as no product of five of them is below
 * 1e-290 or above 1e290, other than 0.
 */
#ifndef ExactReference_h
#define ExactReference_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

class ExactReference
{
public:
#ifdef __SIZEOF_FLOAT128__
  __extension__ using Quad = __float128;
#else
  using Quad = long double;
#endif
  using Vector = std::array<double, 3>;
  using Triangle = std::array<std::uint32_t, 3>;

  static constexpr std::int32_t NoTriangle = -1;

  struct Hit
  {
    /// In units of the direction's length, to about 24 digits. At least the limit where nothing is
    /// hit.
    Quad WideRange;
    /// The same rounded to double.
    double Range;
    /// The triangle, the smallest index of several at the same range, or NoTriangle.
    std::int32_t Triangle;
  };

  /// All points of the triangles must be finite.
  ExactReference(std::vector<Vector> points, std::vector<Triangle> triangles);

  /// The nearest triangle along a beam, up to a limit.
  Hit Cast(const Vector& origin, const Vector& direction,
    double limit = std::numeric_limits<double>::infinity()) const;

  /// One triangle alone.
  Hit Cast(std::int32_t triangle, const Vector& origin, const Vector& direction,
    double limit = std::numeric_limits<double>::infinity()) const;

  /// How far a range is from the true one, in units in the last place of the true one.
  static double GetError(double range, const Hit& truth);

private:
  /// A ball around the triangles First to First + Count - 1 of Order. Where there are many, the
  /// first half of them lie in the node that follows, the other half in Other.
  struct Node
  {
    Vector Center;
    double Radius;
    std::size_t First;
    std::size_t Count;
    std::size_t Other;
  };

  std::size_t Build(std::size_t first, std::size_t count);
  void Enclose(Node& node) const;
  void Split(const Node& node);
  const Vector& GetCorner(std::int32_t triangle, int corner) const;

  std::vector<Vector> Points;
  std::vector<Triangle> Triangles;
  std::vector<std::int32_t> Order;
  std::vector<Node> Nodes;
};

#endif
