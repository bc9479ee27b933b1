// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Decides exactly which beams of a packet hit a triangle, and at which range.
 *
 * With a, b, c the corners seen from the sensor, a beam along D passes inside the triangle where the
 * three edge functions D.(b x c), D.(c x a), D.(a x b) have one sign. A function is evaluated in
 * double with a bound of its rounding error; where the bound leaves the sign open it is evaluated
 * again in quadruple precision. Two triangles that share an edge compute the same number for it but
 * for its sign, so no beam passes between them. The range is that of the triangle's plane,
 * N.a / N.D.
 *
 * Triangles are closed (an edge or a corner counts as a hit) and have two sides. A beam within the
 * triangle's own plane, a triangle without area, and a surface at range 0 are never hit.
 */
#ifndef lms3dTriangleTest_h
#define lms3dTriangleTest_h

#include <array>
#include <cstdint>
#include <limits>

/// Beams that are cast together: neighbours in the grid, so that they meet the same triangles.
struct lms3dBeamPacket
{
  static constexpr int Size = 16;
  static constexpr std::int32_t NoTriangle = -1;
  static constexpr double NoRange = std::numeric_limits<double>::infinity();

  alignas(64) std::array<double, Size> Direction[3];
  /// The nearest hit so far, or NoRange.
  alignas(64) std::array<double, Size> Range;
  std::array<std::int32_t, Size> Triangle;
  /// Bit i is set where beam i is to be cast.
  std::uint32_t Active;
};

/// Three corners of a triangle in world coordinates.
using lms3dCorners = std::array<const double*, 3>;

/**
 * Takes the hits of a triangle into the packet where they are the nearest so far; of two triangles at
 * the same range the one with the smaller number stays, so the order of the calls does not matter.
 * Returns the beams whose nearest hit changed.
 */
std::uint32_t lms3dIntersectTriangle(const lms3dCorners& corners, std::int32_t triangle,
  const double origin[3], double maximumRange, lms3dBeamPacket& packet);

/// The range at which a beam meets the plane of a triangle; not finite where it is parallel to it.
double lms3dPlaneRange(
  const lms3dCorners& corners, const double origin[3], const double direction[3]);

#endif
