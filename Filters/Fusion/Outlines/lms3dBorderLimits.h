// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Which cells a border may gain, and which returns it may cut off.
 */
#ifndef lms3dBorderLimits_h
#define lms3dBorderLimits_h

#include "Fusion/Cells/lms3dBlockGrid.h"
#include "Fusion/Outlines/lms3dCornerMerge.h"
#include "Triangulation/lms3dOrientation.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

/**
 * A region may gain cells if no beam passed through them and if they lie in blocks. A border may
 * cut off a return that stays near it, since the return is then within the bound of the region.
 * Each edge of a border keeps the returns that it has cut off, so that the edge that takes its
 * place is not farther from them. Lengths are cells.
 */
class lms3dBorderLimits
{
public:
  using Triangle = lms3dCornerMerge::Triangle;
  using Edge = std::size_t;

  /// `region` has the bits of lms3dCopySureReturns(). Edges have numbers from 0 on. `reach` is how
  /// far a border may be away from a return that it cuts off.
  lms3dBorderLimits(const lms3dRegion& region, std::size_t edges, double reach);

  /// Whether a corner may move outwards to a point: a cell of the region, one with May, is at most
  /// two cells away along both axes.
  bool IsNearRegion(const lms3dPoint2& point) const;

  /// Whether the third side of a triangle may take the place of two edges. The first edge goes from
  /// the triangle's first corner to its second one.
  bool MayJoin(const Triangle& triangle, Edge first, Edge second) const;

  /// Lets the first edge take the place of both.
  void Join(const Triangle& triangle, Edge first, Edge second);

  /// The same for the edges of a merge, in any order. The first two take the place of all: the
  /// first one then goes to the new corner.
  bool MayMerge(const lms3dCornerMerge& merge, const std::vector<Edge>& edges) const;
  void Merge(const lms3dCornerMerge& merge, const std::vector<Edge>& edges);

private:
  using Returns = std::vector<lms3dPoint2>;

  bool MayGain(const Triangle& triangle) const;
  bool HasPassed(const lms3dCellStrip& strip) const;
  bool MayCutOff(const lms3dPoint2& place) const;
  bool MayChange(const Triangle& triangle, const lms3dCornerMerge& merge) const;
  void AddReturns(const Triangle& triangle, Returns& returns) const;
  template <typename Visitor>
  bool ForReturns(const Triangle& triangle, const Visitor& visit) const;

  const lms3dRegion& Region;
  /// Squared.
  const double Reach;
  /// The centres of the cells of returns that each edge has cut off.
  std::vector<Returns> CutOff;
  /// The row in which MayGain() found a beam last. It spares work and changes no result.
  mutable std::int32_t PassedRow = std::numeric_limits<std::int32_t>::min();
};

#endif
