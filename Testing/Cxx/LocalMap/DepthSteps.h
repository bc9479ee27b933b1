// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Decides which neighbours lie on one surface, as the filter's public header defines it.
 */
#ifndef DepthSteps_h
#define DepthSteps_h

#include "Fixtures/ScanGrid.h"

#include <array>
#include <vector>

/**
 * A beam a and its neighbour b are certainly joined if both returned and one of these holds:
 *
 * - Their ranges differ by at most DepthStep.
 * - The scan has no noise, and the planes through either return and the return before it meet the
 *   other within half a millimetre.
 *
 * They are certainly apart if the surfaces on both sides end before they would meet, by more than
 * the tolerance and by more than noise can move them. The tolerance is DepthStep plus a share of
 * the nearer range, 2 % or the angle between the beams if that is more. In the cases in between, a
 * scan does not determine the surface: planes can intersect between a and b at the edge of a box
 * that hides one side, or at a crease that has only two returns beside it.
 *
 * Along a turn, the plane also passes through the beam's neighbour towards the horizon if the two
 * are joined; otherwise it is upright. Beyond a pole of a full circle, the opposite turn follows.
 *
 * Beams half a circle apart have no surface between them.
 */
class DepthSteps
{
public:
  using Beam = ScanGrid::Beam;

  /// Keeps a reference to the grid. `noise` is how far returns were moved along their beams,
  /// metres.
  DepthSteps(const ScanGrid& grid, double depthStep, double noise)
    : Grid(grid)
    , DepthStep(depthStep)
    , Noise(noise)
  {
  }

  bool AreJoined(const Beam& a, const Beam& b) const;
  bool AreApart(const Beam& a, const Beam& b) const;
  double GetTolerance(const Beam& a, const Beam& b) const;

private:
  /// The ranges at which the surface would continue: at b from a, and at a from b.
  using Predictions = std::array<double, 2>;

  bool HaveReturned(const Beam& a, const Beam& b) const;
  double GetRange(const Beam& beam) const;
  double GetStep(const Beam& a, const Beam& b) const;
  bool AreJoined(const Beam& a, const Beam& b, const Predictions& predictions) const;
  double Predict(const Beam& a, const Beam& b) const;
  std::vector<double> PredictAnyTilt(const Beam& a, const Beam& b) const;
  double GetError(const Beam& a, const Beam& b) const;
  double PredictAlong(const Beam& a, const Beam& b) const;
  double GetRangeBefore(const Beam& before, const Beam& a) const;
  double PredictInverse(const Beam& last, const Beam& a, const Beam& b) const;
  Beam GetTowardsHorizon(const Beam& beam) const;

  const ScanGrid& Grid;
  double DepthStep;
  double Noise;
};

#endif
