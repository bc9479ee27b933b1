// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Takes corners out of the outlines of a region.
 */
#ifndef lms3dOutlineSimplifier_h
#define lms3dOutlineSimplifier_h

#include "Fusion/Outlines/lms3dBorderLimits.h"
#include "Fusion/Outlines/lms3dCornerBuckets.h"
#include "Fusion/Outlines/lms3dCornerCandidates.h"
#include "Fusion/Outlines/lms3dOutlineCorners.h"

#include <vector>

/**
 * A corner goes if the straight line between its neighbours passes all corners that went before
 * within a tolerance, if the limits of borders allow it, if neither neighbour is sharp then
 * (lms3dIsSharpCorner), and if the triangle between corner and line holds no other corner, so
 * outlines never cross. Fixed corners go only if they lie on a straight line. Corners of steps go
 * first, then those that cost least (M. Visvalingam and J. Whyatt 1993, "Line generalisation by
 * repeated elimination of points"). If a neighbour of the corner has moved, its first place does
 * not count.
 */
class lms3dOutlineSimplifier
{
public:
  /// The tolerance is in cells. The edges of the limits have the numbers of their first corners.
  /// Keeps references to corners and limits. Some corners may have gone or moved before.
  lms3dOutlineSimplifier(double tolerance, lms3dOutlineCorners& corners, lms3dBorderLimits& limits);

  void Simplify();

private:
  using Corner = lms3dOutlineCorners::Corner;
  using Triangle = lms3dOutlineCorners::Triangle;

  void RemoveSteps();
  void FindCandidates();
  void Queue(Corner corner);
  double GetCost(Corner corner, double limit) const;
  bool MakesSharpCorner(Corner corner) const;
  bool MayGo(Corner corner) const;
  bool IsEmpty(const Triangle& triangle, Corner corner) const;
  void Remove(Corner corner);

  /// Squared.
  const double Tolerance;
  lms3dOutlineCorners& Corners;
  lms3dBorderLimits& Limits;
  std::vector<int> Versions;
  /// The corners that did not go.
  lms3dCornerBuckets Buckets;
  lms3dCornerCandidates Candidates;
};

#endif
