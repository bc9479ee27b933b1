// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ranges of the surface at the borders of patches.
 */
#ifndef lms3dBorderRanges_h
#define lms3dBorderRanges_h

#include "LocalMap/Borders/lms3dBorderGates.h"
#include "LocalMap/Borders/lms3dRangeSupport.h"

#include <array>
#include <limits>

/// A vertex of the map, in the sensor frame.
struct lms3dMapVertex
{
  /// A unit vector.
  lms3dVector Direction;
  /// 1/metre, above 0.
  double InverseRange;
};

/**
 * Gives border vertices their ranges. A border lies in the planes of its patches, within the ranges
 * that returns support (lms3dRangeSupport). Where two patches of few returns meet and their planes
 * do not, the surface runs straight from return to return.
 *
 * See lms3dBorderGates for gates, edges and cells.
 */
class lms3dBorderRanges
{
public:
  using GridIndex = lms3dBeamSphere::GridIndex;
  using Cell = lms3dBorderGates::Cell;
  /// A point of a cell, as bilinear weights of the corners' directions. Their sum is 1.
  using Weights = std::array<double, 4>;

  /// Keeps references.
  lms3dBorderRanges(
    const lms3dBeamSphere& sphere, const lms3dPatches& patches, const lms3dBorderGates& gates);

  /// How far the surface may extend from an edge's owner into the gate of a depth step: a share of
  /// the way to the other end, at most `maximum`.
  double GetExtension(int edge, double maximum) const;

  /// The direction of the other end of an edge's gate. At a depth step, the other end counts at the
  /// range of the edge's owner.
  lms3dVector GetDirectionBeyond(int edge) const;

  /// The vertex in the gate of an edge, for the edge's patch. `at` is the share of the way from the
  /// owner to the other end.
  lms3dMapVertex GetVertexInGate(int edge, double at) const;

  /// The vertex of a junction, which the patches at some corners of the cell share. `corners` gives
  /// these as bits, at least one; each has a return. Beside a depth step, the vertex may move from
  /// `weights` towards these corners, to lie on their planes.
  lms3dMapVertex GetVertexInCell(const Cell& cell, int corners, const Weights& weights) const;

private:
  /// A direction inside a cell, and the inverse ranges of some planes there, 1/metre.
  struct CellPoint
  {
    lms3dVector Unit;
    double Minimum = std::numeric_limits<double>::infinity();
    double Maximum = -std::numeric_limits<double>::infinity();
    /// The mean of all planes or, if they do not meet there, the plane of the patch of most
    /// returns.
    double Best = 0.0;
  };

  lms3dVector GetPointInGate(int edge, double at) const;
  double GetInverseAtCrease(int edge, double at, const lms3dVector& unit) const;
  const lms3dPlane& GetPlane(GridIndex index) const;
  lms3dVector GetDirectionInCell(const Cell& cell, int corners, int corner) const;
  CellPoint GetPointInCell(const Cell& cell, int corners, const Weights& weights) const;
  double InterpolateInCell(const Cell& cell, const Weights& weights) const;
  bool AreSameSurface(double inverse, double other) const;
  bool HaveFewReturns(const Cell& cell, int corners) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const lms3dBorderGates& Gates;
  const lms3dRangeSupport Support;
};

#endif
