// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The ranges that returns support beside them, where nothing was measured.
 */
#ifndef lms3dRangeSupport_h
#define lms3dRangeSupport_h

#include "LocalMap/Borders/lms3dBorderGates.h"
#include "LocalMap/Borders/lms3dDepthStepMargins.h"

#include <algorithm>
#include <limits>

/// An interval of ranges, metres, above 0. It starts empty.
struct lms3dRangeInterval
{
  double Nearest = std::numeric_limits<double>::infinity();
  double Farthest = 0.0;

  /// Grows to contain another interval.
  void Include(const lms3dRangeInterval& other)
  {
    this->Nearest = std::min(this->Nearest, other.Nearest);
    this->Farthest = std::max(this->Farthest, other.Farthest);
  }

  /// Whether a range lies in the interval. Takes 1 / range.
  bool Contains(double inverseRange) const
  {
    return inverseRange * this->Nearest <= 1.0 && inverseRange * this->Farthest >= 1.0;
  }

  /// Moves a range into the interval. Takes and returns 1 / range, 1/metre. A plane that does not
  /// meet the beam has an inverse range below 0 and moves to the far end.
  double Clamp(double inverseRange) const
  {
    return std::min(std::max(inverseRange, 1.0 / this->Farthest), 1.0 / this->Nearest);
  }
};

/**
 * A border lies up to one cell beyond the last returns of its patch. There the range may differ
 * from the range of the last return by no more than
 *
 * - a share of the range's last change, from the return before the last to the last one, and
 * - the tolerance of lms3dBorderGates or, at a depth step, a quarter of the step if that is less.
 *
 * Beside a beam without a return, nothing else is near that an inclined plane could hit, so the
 * change of range that the patch's plane predicts counts as well.
 *
 * Directions are unit vectors in the sensor frame; see lms3dBorderGates for gates, edges and cells.
 */
class lms3dRangeSupport
{
public:
  using GridIndex = lms3dBeamSphere::GridIndex;
  using Cell = lms3dBorderGates::Cell;

  /// Keeps references.
  lms3dRangeSupport(
    const lms3dBeamSphere& sphere, const lms3dPatches& patches, const lms3dBorderGates& gates)
    : Sphere(sphere)
    , Patches(patches)
    , Gates(gates)
    , Margins(sphere, patches, gates.GetTolerance())
  {
  }

  /// Metres by which the range may differ from its edge's owner at a depth step.
  double GetMarginAtDepthStep(int edge) const;

  /// The range of a return plus or minus `margin`, metres. The far end also contains the plane
  /// through the return that faces the sensor. `cosine` is of the angle to the return's beam.
  static lms3dRangeInterval GetInterval(double range, double margin, double cosine)
  {
    return { std::max(MinimumRangeShare * range, range - margin),
      range / std::max(MinimumCosine, cosine) + margin };
  }

  ///@{
  /// The interval in direction `unit` inside the gate of an edge, for each kind of gate.
  lms3dRangeInterval GetIntervalAtDepthStep(int edge, const lms3dVector& unit) const;
  lms3dRangeInterval GetIntervalAtCrease(int edge, const lms3dVector& unit) const;
  lms3dRangeInterval GetIntervalAtOffset(int edge, const lms3dVector& unit) const;
  ///@}

  /// The interval in direction `unit` inside a cell, supported by some of its corners, given as
  /// bits. `isContinuous` means that no depth step passes the cell. The corners have returns.
  lms3dRangeInterval GetIntervalInCell(
    const Cell& cell, int corners, bool isContinuous, const lms3dVector& unit) const;

private:
  /// The surface beside a return never comes nearer to the sensor than this share of the return's
  /// range.
  static constexpr double MinimumRangeShare = 0.1;
  /// Limits the far end in cells that are nearly as wide as half a circle.
  static constexpr double MinimumCosine = 0.25;

  lms3dRangeInterval GetIntervalAround(
    GridIndex index, double change, const lms3dVector& unit) const;

  const lms3dBeamSphere& Sphere;
  const lms3dPatches& Patches;
  const lms3dBorderGates& Gates;
  const lms3dDepthStepMargins Margins;
};

#endif
