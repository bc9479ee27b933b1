// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Two corners of an outline that become one.
 */
#ifndef lms3dCornerMerge_h
#define lms3dCornerMerge_h

#include "Fusion/lms3dSegment2.h"
#include "Triangulation/lms3dOrientation.h"

#include <algorithm>
#include <array>

struct lms3dCornerMerge
{
  using Triangle = std::array<lms3dPoint2, 3>;

  /// The squared distance from the outline after the merge.
  double GetSquaredDistance(const lms3dPoint2& point) const
  {
    return std::min(lms3dSegment2(this->Before[0], this->Corner).GetSquaredDistance(point),
      lms3dSegment2(this->Corner, this->Before[3]).GetSquaredDistance(point));
  }

  /// The squared distance of the new corner from the outline before the merge.
  double GetSquaredDistanceOfCorner() const
  {
    double least = lms3dSegment2(this->Before[0], this->Before[1]).GetSquaredDistance(this->Corner);
    for (int i = 1; i < 3; ++i)
    {
      const lms3dSegment2 edge(this->Before[i], this->Before[i + 1]);
      least = std::min(least, edge.GetSquaredDistance(this->Corner));
    }
    return least;
  }

  /// The triangles between the outlines before and after. The region loses those that are
  /// counter-clockwise, and gains the others.
  std::array<Triangle, 3> GetTriangles() const
  {
    const std::array<lms3dPoint2, 4>& b = this->Before;
    return { { { b[0], b[1], this->Corner }, { b[2], this->Corner, b[1] },
      { this->Corner, b[2], b[3] } } };
  }

  /// The two corners between their neighbours.
  std::array<lms3dPoint2, 4> Before;
  /// The one that takes their place.
  lms3dPoint2 Corner;
};

#endif
