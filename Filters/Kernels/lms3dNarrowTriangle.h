// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A triangle in single precision, seen from the sensor, with error bounds.
 *
 * Let a, b, c be the corners in the sensor frame, |.| the 1-norm, and u = 6e-8 the rounding of
 * single precision. A direction d of length 1 passes inside if d.(b x c), d.(c x a), d.(a x b) have
 * the sign of a.(b x c). It then meets the plane with the normal n = (b - a) x (c - a) at the range
 * n.a / n.d. So the products of d with four vectors decide: three edges (b x c) / |b x c| and so
 * on, turned so that directions inside have positive products, and the plane (n / n.a) times a unit
 * of length, whose product is the inverse range. Edges of a triangle that is used once are not
 * divided by |b x c|. The bounds of their products are then multiplied by it, and these edges are
 * between 1e-20 and 1e20 square metres: no product overflows, and what underflows, below 1e-37, is
 * far less than the bound, 2e-26 or more. Rounding the bound itself changes it by a share of u.
 *
 * The 1-norm of an edge is 1, and no component of d exceeds 1. So the products of a dot product,
 * and its sums, are at most 1 together. Rounding the edge to single precision, rounding d, and
 * rounding the products err by at most u each, and so does each of the two sums: 5 u = 3e-7
 * together. An instruction set with fused multiply-add rounds two times less. The error of a
 * plane's product is the same share of the plane's 1-norm.
 *
 * The vectors are computed in double precision, from corners that are rounded once. This changes b
 * x c by less than 1e-15 |b| |c|: two roundings of corners, two of products and one of a difference
 * are 6e-16. As long as |b x c| > 1e-6 |b| |c|, the edge's product changes by less than 1e-9. For
 * directions that meet the triangle the plane's product, too, changes by less than 1e-9 as long as
 * |n.a| > 1e-6 |b - a| |c - a| |a|: there, rounding moves a corner, and with it the hit, by at most
 * 1e-16 |a| / 1e-6. Beside a small, far triangle the plane can err by more. This is harmless: the
 * plane decides only for beams inside the edges, or for whole tiles. Its product is linear, so what
 * holds at a tile's corners holds wherever the triangle lies in the tile.
 *
 * The sign of n.a, which turns the edges, is certain. Since a x b = a x (b - a), the first
 * condition also gives |b - a| > 1e-6 |b| and > 1e-6 |a|. So rounding of the corners changes b - a
 * by less than 3e-10 |b - a|, c - a likewise, and thus n.a by less than 1e-9 |b - a| |c - a| |a|,
 * far below the second condition.
 */
#ifndef lms3dNarrowTriangle_h
#define lms3dNarrowTriangle_h

#include "Kernels/lms3dBeamPacket.h"

#include <cstdint>

/// The bound of an edge's product, and of a plane's product relative to the plane's 1-norm. Six
/// times what the derivation above needs: tiles add the rounding of their corners.
constexpr float lms3dNarrowError = 2e-6f;

/// One cache line. All values are without unit, but edges that are not scaled are in square metres.
struct alignas(64) lms3dNarrowTriangle
{
  /// The x, y and z of four vectors: the edges opposite to corner 0, 1 and 2, and the plane, whose
  /// product with a direction is unit / range.
  float Vectors[3][4];

  /// Which of the vectors is the plane.
  static constexpr int Plane = 3;

  /// The bound of the plane's product; negative if single precision cannot represent the triangle:
  /// it is very narrow, its plane passes very near to the sensor, or its size overflows.
  float PlaneError;
};

/// The corners of a triangle and the sensor's position in world coordinates.
struct lms3dCornerPoints
{
  const double* Corner[3];
  const double* Origin;

  /// The length whose inverse is 1, metres.
  double Unit;
};

/// The nearest hits of a packet in single precision: unit / range, 0 at infinity, with error
/// bounds.
struct lms3dNarrowHits
{
  alignas(64) float InverseRange[lms3dBeamPacket::Size];
  alignas(64) float Error[lms3dBeamPacket::Size];
};

/// What single precision finds for one triangle. Beams in neither mask keep their hits for certain.
struct lms3dNarrowMasks
{
  /// Beams that certainly have their nearest hit here now.
  std::uint32_t Changed;

  /// Beams on which single precision cannot decide.
  std::uint32_t Uncertain;
};

#endif
