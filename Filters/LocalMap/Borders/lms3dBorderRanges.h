// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How far from the sensor the surface is at the borders of patches.
 */
#ifndef lms3dBorderHeights_h
#define lms3dBorderHeights_h

#include "LocalMap/Borders/lms3dBorderGates.h"

#include <algorithm>
#include <array>
#include <limits>

/// A point of the map: where it is seen, a unit vector, and the inverse of its range.
struct lms3dMapVertex
{
  lms3dVector Direction;
  double InverseRange;
};

/**
 * Borders lie in the planes of their patches, as far as the returns support those: beyond the last
 * return of a patch its range changes by no more than half of what it changed by before that return,
 * or by the bound. Where planes of few returns do not meet, the surface runs straight from return to
 * return.
 */
class lms3dBorderRanges
{
public:
  using GridIndex = lms3dBeamSphere::GridIndex;
  /// Of the corners of a cell.
  using Weights = std::array<double, 4>;

  /// Keeps references.
  lms3dBorderRanges(
    const lms3dBeamSphere& sphere, const lms3dPatches& patches, const lms3dBorderGates& gates);

  /// The share of the way from an edge's owner to the other side of a cut that the surface may reach.
  double GetExtension(int edge, double most) const;

  /// The vertex of an edge's owner at a share of the way to the other side.
  lms3dMapVertex GetVertexInGate(int edge, double at) const;

  /// Of the patches at some of the corners of a cell, those with their bits set: where the corners'
  /// directions have so much weight each.
  lms3dMapVertex GetVertexInCell(
    const lms3dBorderGates::Cell& cell, int corners, const Weights& weights) const;

private:
  /// Ranges between which the surface may be; at first none.
  struct Interval
  {
    double Nearest = std::numeric_limits<double>::infinity();
    double Farthest = 0.0;

    void Include(const Interval& other)
    {
      this->Nearest = std::min(this->Nearest, other.Nearest);
      this->Farthest = std::max(this->Farthest, other.Farthest);
    }
    bool Holds(double inverseRange) const
    {
      return inverseRange * this->Nearest <= 1.0 && inverseRange * this->Farthest >= 1.0;
    }
    double Clamp(double inverseRange) const
    {
      // A plane that does not meet the beam has an inverse range below 0.
      return std::min(std::max(inverseRange, 1.0 / this->Farthest), 1.0 / this->Nearest);
    }
  };

  /// A place in a cell, and what the planes around it say of its inverse range.
  struct CellPoint
  {
    lms3dVector Unit;
    double Minimum = std::numeric_limits<double>::infinity();
    double Maximum = -std::numeric_limits<double>::infinity();
    double Mean = 0.0;
  };

  lms3dVector GetPointInGate(int edge, double at) const;
  double GetInverseAtCrease(int edge, double at, const lms3dVector& unit) const;
  const lms3dPatches::Patch& GetPatch(GridIndex index) const;
  double GetSlope(GridIndex index, int side) const;
  bool HasSlope(GridIndex index, int back) const;
  double GetSlopeOfPlane(GridIndex index, int side) const;
  double GetMarginAtDepthStep(int edge) const;
  Interval GetInterval(double range, double margin, double cosine) const;
  Interval GetInterval(GridIndex index, double change, const lms3dVector& unit) const;
  Interval GetIntervalInCell(const lms3dBorderGates::Cell& cell, int corners, bool isContinuous,
    const lms3dVector& unit) const;
  CellPoint GetPointInCell(
    const lms3dBorderGates::Cell& cell, int corners, const Weights& weights) const;
  double GetStraightInCell(const lms3dBorderGates::Cell& cell, const Weights& weights) const;
  bool AreSameSurface(double inverse, double other) const;
  bool HaveFewReturns(const lms3dBorderGates::Cell& cell, int corners) const;
  bool IsContinuous(const lms3dBorderGates::Cell& cell) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const lms3dBorderGates& Gates;
};

#endif
