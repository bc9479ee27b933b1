// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The returns beside a region that borders have cut off.
 */
#ifndef lms3dCutReturns_h
#define lms3dCutReturns_h

#include "Fusion/lms3dBlockGrid.h"
#include "Triangulation/lms3dOrientation.h"

#include <array>
#include <cstddef>
#include <vector>

/**
 * A border may cut off a return that stays near it, since the return is then within the bound of
 * the region. Each edge of a border knows the returns that it has cut off, so that the edge that
 * takes its place is not farther from them. Lengths are cells.
 */
class lms3dCutReturns
{
public:
  using Triangle = std::array<lms3dPoint2, 3>;

  /// `region` has the returns. Edges have numbers from 0 on.
  lms3dCutReturns(const lms3dRegion& region, std::size_t edges);

  /// How far a border may be away from a return that it cuts off. At first, none may be cut off.
  void SetReach(double reach) { this->Reach = reach * reach; }

  /// Whether the third side of a triangle may take the place of two edges, if the region loses the
  /// triangle. The first edge goes from the triangle's first corner to its second one.
  bool MayCut(const Triangle& triangle, std::size_t first, std::size_t second) const;

  /// Lets the first edge take the place of both.
  void Join(const Triangle& triangle, std::size_t first, std::size_t second);

private:
  template <typename Visitor>
  bool ForReturns(const Triangle& triangle, const Visitor& visit) const;

  const lms3dRegion& Region;
  /// Squared; below 0 for none.
  double Reach = -1.0;
  /// The centres of their cells, for each edge.
  std::vector<std::vector<lms3dPoint2>> Returns;
};

#endif
