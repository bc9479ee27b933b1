// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Cuts polygons of any shape and size into triangles.
 */
#ifndef lms3dTriangulator_h
#define lms3dTriangulator_h

#include "Geometry/lms3dVector.h"
#include "lms3dCornerGrid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * Clips ears in the polygon's mean plane (that of Newell's normal): concave polygons and holes that
 * a bridge joins to the rim (keyholes) come out right. Corners that may be inside of an ear are
 * looked up in a grid, and the work for a polygon of n corners is bounded by a multiple of n.
 *
 * One triangulator may cut many polygons and keeps its memory for them.
 */
class lms3dTriangulator
{
public:
  using Triangle = std::array<std::int32_t, 3>;

  /**
   * Finds the triangles, of indices into the corners, facing where the corners turn
   * counter-clockwise. False for a polygon that crosses itself, or is too much work: its triangles
   * then cover it, but also what is beside or twice. No triangles where all corners are on a line.
   */
  bool Cut(const std::vector<lms3dVector>& corners);

  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }

private:
  using FlatPoint = lms3dCornerGrid::Point;

  bool Flatten(const std::vector<lms3dVector>& corners);
  bool IsConvex() const;
  void Fan();
  bool ClipEars();

  /// How careful an ear is chosen, if need be with less care.
  enum Care
  {
    NO_CORNER_TOUCHES, ///< no corner is inside of the ear or on its rim
    NO_CORNER_INSIDE,
    CONVEX,
    ANY
  };
  bool IsEar(std::int32_t corner, int care);
  bool IsFree(std::int32_t corner, bool mayTouch);
  void Clip(std::int32_t corner);

  double GetTurn(std::int32_t a, std::int32_t b, std::int32_t c) const;
  double GetTurn(std::int32_t corner) const;
  bool IsStraight(std::int32_t corner) const;

  void BuildGrid();

  /// A turn that is smaller is one of rounding: the corner is on a straight line.
  double LeastTurn = 0.0;

  std::vector<Triangle> Triangles;
  std::vector<FlatPoint> Points;
  std::vector<std::int32_t> Next;
  std::vector<std::int32_t> Previous;

  lms3dCornerGrid Grid;
  /// In units of a corner that is looked at.
  std::size_t WorkLeft = 0;
};

#endif
