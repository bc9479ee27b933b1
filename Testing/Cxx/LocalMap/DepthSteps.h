// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which neighbours are on one surface by the words of the filter's header.
 */
#ifndef DepthSteps_h
#define DepthSteps_h

#include "Fixtures/ScanGrid.h"

#include <array>

/**
 * A beam a and its neighbour b are joined where both returned and
 * - their ranges differ by no more than the tolerance: DepthStep and a share of the nearer range, 2
 *   % or the angle between them where that is more; or
 * - the plane through either and the beam before it goes on to the other within the tolerance; or
 * - the planes from both sides go on to the other or behind it, within the tolerance, and the nearer
 *   side is straight, its last three returns on one plane within their tolerance: the planes cross
 *   between a and b, as those at the crease of a room do.
 *
 * Along a turn the plane is that of the beam's neighbour towards the horizon, too, if they are joined,
 * and else upright. Beyond a pole of a full circle, the opposite turn comes.
 *
 * Beams half a circle apart have nothing between them.
 *
 * They are apart, for sure, where the surfaces on both sides end before they would meet. Between
 * the two are cases of which a scan does not tell: planes that cross between a and b as those at the
 * edge of a box do, of which one side may be hidden, or as those of a crease, beside two returns.
 */
class DepthSteps
{
public:
  using Beam = ScanGrid::Beam;

  /// Keeps a reference to the grid.
  DepthSteps(const ScanGrid& grid, double depthStep)
    : Grid(grid)
    , DepthStep(depthStep)
  {
  }

  bool AreJoined(const Beam& a, const Beam& b) const;
  bool AreApart(const Beam& a, const Beam& b) const;
  double GetTolerance(const Beam& a, const Beam& b) const;

private:
  /// Ranges, of one where the surface goes on to it: of b from a, of a from b, and of a and b from
  /// the beams before them.
  using Predictions = std::array<double, 4>;

  bool HaveReturned(const Beam& a, const Beam& b) const;
  double GetRange(const Beam& beam) const;
  double GetStep(const Beam& a, const Beam& b) const;
  bool AreJoined(const Beam& a, const Beam& b, const Predictions& predictions) const;
  bool IsStraight(const Beam& a, const Beam& b, double predicted) const;
  double Predict(const Beam& a, const Beam& b) const;
  double PredictAlong(const Beam& a, const Beam& b) const;
  double GetRangeBefore(const Beam& before, const Beam& a) const;
  double PredictInverse(const Beam& last, const Beam& a, const Beam& b) const;
  Beam GetTowardsHorizon(const Beam& beam) const;

  const ScanGrid& Grid;
  double DepthStep;
};

#endif
