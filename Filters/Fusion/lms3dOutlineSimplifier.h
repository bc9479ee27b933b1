// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Takes corners out of the outlines of a region.
 */
#ifndef lms3dOutlineSimplifier_h
#define lms3dOutlineSimplifier_h

#include "Fusion/lms3dCornerBuckets.h"
#include "Fusion/lms3dCornerCandidates.h"
#include "Fusion/lms3dCutReturns.h"
#include "Fusion/lms3dRaster.h"
#include "Fusion/lms3dRasterOutline.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * A corner goes if the straight line between its neighbours passes all corners that went before
 * within a tolerance, and if the triangle between corner and line holds no other corner, so
 * outlines never cross. If the region loses the triangle, no cell of Must that is not near the line
 * may have its centre there (lms3dCutReturns); if the region gains it, no cell of Passed may touch
 * it, and all its cells must lie in blocks. Corners of steps go first, then those that cost least
 * (M. Visvalingam and J. Whyatt 1993, "Line generalisation by repeated elimination of points").
 */
class lms3dOutlineSimplifier
{
public:
  /// `region` has the bits of lms3dCopySureReturns(). The tolerance, and the reach within which the
  /// border may cut off returns, are in cells. Corners of `isFixed`, in the order of the loops, go
  /// only if they lie on a straight line.
  lms3dOutlineSimplifier(const lms3dRegion& region, const std::vector<lms3dLoop>& loops,
    const std::vector<bool>& isFixed, double tolerance, double reach);

  std::vector<lms3dLoop> Simplify();

private:
  using Corner = std::int32_t;

  void Link(const std::vector<lms3dLoop>& loops);
  void RemoveSteps();
  void FindCandidates();
  void Queue(Corner corner);
  double GetCost(Corner corner) const;
  bool MayGo(Corner corner) const;
  bool MayGain(const std::array<lms3dPoint2, 3>& triangle) const;
  std::array<lms3dPoint2, 3> GetTriangle(Corner corner) const;
  bool IsEmpty(const std::array<lms3dPoint2, 3>& triangle, Corner corner) const;
  void Remove(Corner corner);
  std::vector<lms3dLoop> GetLoops() const;

  const lms3dRegion& Region;
  const std::vector<bool>& IsFixed;
  /// Squared.
  double Tolerance;
  const double Reach;
  std::vector<lms3dPoint2> Points;
  std::vector<Corner> Next;
  std::vector<Corner> Previous;
  /// The next corner before any went.
  std::vector<Corner> NextOriginal;
  std::vector<Corner> FirstOfLoop;
  std::vector<int> SizeOfLoop;
  std::vector<int> Versions;
  std::vector<bool> IsGone;
  /// The number of an edge is its first corner.
  lms3dCutReturns Cut;
  /// The corners that did not go.
  lms3dCornerBuckets Buckets;
  lms3dCornerCandidates Candidates;
};

#endif
