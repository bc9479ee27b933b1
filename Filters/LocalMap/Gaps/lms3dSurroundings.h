// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The plane of the returns around a group of beams.
 */
#ifndef lms3dSurroundings_h
#define lms3dSurroundings_h

#include "LocalMap/Gaps/lms3dBeamStates.h"
#include "LocalMap/Patches/lms3dPlane.h"

#include <optional>
#include <vector>

/**
 * The surroundings of a group are the returns next to its beams, diagonals included. If there are
 * only a few, beams without a return and speckles next to the group count as parts of it, so the
 * surroundings are one beam farther away.
 *
 * Three of the returns must stand in an angle: two beside each other in a fan, two in a turn.
 * Otherwise, two surfaces at different depths can end at the group, one on each side: a plane
 * passes through any two parallel lines of returns.
 */
class lms3dSurroundings
{
public:
  /// Keeps a reference. `tolerance` and `depthStep` are metres.
  lms3dSurroundings(const lms3dBeamStates& states, double tolerance, double depthStep)
    : States(states)
    , Tolerance(tolerance)
    , DepthStep(depthStep)
  {
  }

  /**
   * Returns the plane that explains all returns around a group. There is none if the group is at
   * the edge of the scan or beside a beam along which there is nothing, if no three of the returns
   * around it stand in an angle, or if these returns lie on no common plane. The tolerance is
   * smaller if returns on both sides of a depth step would fit into it.
   */
  std::optional<lms3dPlane> FitPlane(const std::vector<int>& group) const;

  /// Whether the returns next to a group are enough, so that the surroundings are not one beam
  /// farther away.
  bool HasEnoughReturns(const std::vector<int>& group) const;

  /// The range at which a beam meets a plane, metres; not above 0 if it does not meet the plane.
  double GetRange(int place, const lms3dPlane& plane) const;

  /// Whether a plane explains the return of a place.
  bool IsOnPlane(int place, const lms3dPlane& plane, double tolerance) const;

  /// The largest distance along a beam, metres, at which a plane explains any return.
  double GetTolerance() const { return this->Tolerance; }
  /// The same for a return at this range.
  double GetToleranceAt(double range) const;

private:
  bool Collect(
    const std::vector<int>& group, std::vector<int>& returns, std::vector<int>& hidden) const;
  bool HasAngle(const std::vector<int>& returns) const;

  const lms3dBeamStates& States;
  const double Tolerance;
  const double DepthStep;
};

#endif
