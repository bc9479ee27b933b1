// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Successive corners of an outline that become one.
 */
#ifndef lms3dCornerMerge_h
#define lms3dCornerMerge_h

#include "Fusion/Outlines/lms3dSegment2.h"
#include "Triangulation/lms3dOrientation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

/// The new corner takes the place of all corners between two neighbours. The region lies on the
/// left of the outline. The outlines before and after the merge enclose triangles that have the new
/// corner in common. Coordinates are cells.
struct lms3dCornerMerge
{
  using Triangle = std::array<lms3dPoint2, 3>;

  /// The squared distance from the outline after the merge.
  double GetSquaredDistance(const lms3dPoint2& point) const
  {
    return std::min(lms3dSegment2(this->Before.front(), this->Corner).GetSquaredDistance(point),
      lms3dSegment2(this->Corner, this->Before.back()).GetSquaredDistance(point));
  }

  /// The squared distance of the new corner from the outline before the merge.
  double GetSquaredDistanceOfCorner() const
  {
    double least = lms3dSegment2(this->Before[0], this->Before[1]).GetSquaredDistance(this->Corner);
    for (std::size_t i = 1; i < this->GetNumberOfEdges(); ++i)
    {
      const lms3dSegment2 edge(this->Before[i], this->Before[i + 1]);
      least = std::min(least, edge.GetSquaredDistance(this->Corner));
    }
    return least;
  }

  /// Whether a point between the outlines before and after the merge is in the region after it: the
  /// straight way from the new corner to the point meets no edge.
  bool IsInside(const lms3dPoint2& point) const
  {
    const lms3dPoint2& first = this->Before.front();
    const lms3dPoint2& last = this->Before.back();
    const bool isLeftOfFirst = lms3dGetOrientation(first, this->Corner, point) >= 0;
    const bool isLeftOfSecond = lms3dGetOrientation(this->Corner, last, point) >= 0;
    return lms3dGetOrientation(first, this->Corner, last) > 0 ? isLeftOfFirst && isLeftOfSecond
                                                              : isLeftOfFirst || isLeftOfSecond;
  }

  /// The number of edges of the outline before the merge.
  std::size_t GetNumberOfEdges() const { return this->Before.size() - 1; }

  /// The triangle between an edge and the new corner. The region gains at most the triangles that
  /// are clockwise, and loses at most the others.
  Triangle GetTriangle(std::size_t edge) const
  {
    return { this->Before[edge], this->Before[edge + 1], this->Corner };
  }

  /// At least one corner, between its neighbours.
  std::vector<lms3dPoint2> Before;
  /// The one that takes their place.
  lms3dPoint2 Corner;
};

#endif
