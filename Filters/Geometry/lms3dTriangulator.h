// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangulates polygons of any shape and size.
 */
#ifndef lms3dTriangulator_h
#define lms3dTriangulator_h

#include "Geometry/lms3dCornerGrid.h"
#include "Geometry/lms3dFlatPolygon.h"
#include "Geometry/lms3dVector.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

/**
 * Triangulates a polygon in space, as lms3dFlatPolygon projects it. The result depends on the
 * corners only.
 *
 * A convex polygon of n corners becomes a fan, in a time proportional to n. Any other polygon is
 * cut by ear clipping. The corners that can be inside an ear are found in a grid. The time is
 * almost proportional to n for usual polygons. For any polygon it is bounded by about 2,000 n +
 * 1,000,000 tests of a corner.
 *
 * One triangulator can cut many polygons. It reuses its memory.
 */
class lms3dTriangulator
{
public:
  using Triangle = std::array<std::int32_t, 3>;

  /// Returns false to stop. Called after every 100,000 tests of a corner.
  using KeepGoing = std::function<bool()>;

  /// The corner that all triangles of a convex polygon share. It decides the surface of a
  /// quadrilateral whose corners are not in one plane. If a neighbour of this corner is straight,
  /// the next corner without a straight neighbour takes its place.
  enum FanCorners
  {
    FIRST_CORNER, ///< cuts a quadrilateral from corner 0 to corner 2
    LAST_CORNER ///< cuts a quadrilateral from corner 1 to corner 3
  };

  explicit lms3dTriangulator(FanCorners fanCorner = FIRST_CORNER)
    : FanCorner(fanCorner)
  {
  }

  /**
   * Triangulates the polygon. All coordinates must be finite, and so small that the product of two
   * is finite. The last corner is not a copy of the first. Concave polygons, and holes that a
   * bridge joins to the outline (keyholes), are cut exactly.
   *
   * Returns true if the triangles cover the polygon exactly once. Returns false if the polygon
   * crosses itself or takes too much work: the triangles then cover the polygon, but can overlap or
   * extend beyond it. If all corners are on a line, returns true without triangles. If `keepGoing`
   * returns false, returns false without triangles.
   */
  bool Cut(const std::vector<lms3dVector>& corners, const KeepGoing& keepGoing = KeepGoing());

  /// Returns the triangles of the last Cut(): indices into the corners, with the orientation of the
  /// polygon.
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }

private:
  std::int32_t FindFanCorner() const;
  /// Returns false, without a complete fan, if a triangle of the fan turns the other way.
  bool MakeFan();

  void LinkCorners();
  void BuildGrid();
  bool ClipEars(const KeepGoing& keepGoing);
  /// Returns false after every 100,000 units of work if `keepGoing` returns false.
  bool MayContinue(const KeepGoing& keepGoing);

  /// The requirements on an ear, from the strictest on. If no corner meets one, the next one
  /// counts.
  enum Requirements
  {
    NO_CORNER_TOUCHES, ///< no corner is in the ear or on its outline
    NO_CORNER_INSIDE, ///< no corner is in the ear
    CONVEX, ///< the ear has the orientation of the polygon
    ANY
  };
  bool IsEar(std::int32_t corner, int requirement);
  bool IsFree(std::int32_t corner, bool mayTouch);
  void Clip(std::int32_t corner);
  void BeginClipping();
  /// Returns whether the maximum of work is reached. From then on ears are not tested for corners.
  bool IsExhausted() const { return this->Work >= this->MaximumWork; }
  /// Returns the strictest requirement that the work done so far allows.
  int GetAffordableRequirement() const;

  /// Returns the turn at a corner between its present neighbours.
  double GetTurn(std::int32_t corner) const;
  double GetMinimumTurn(std::int32_t corner) const;
  bool IsStraight(std::int32_t corner) const;

  FanCorners FanCorner;

  std::vector<Triangle> Triangles;
  lms3dFlatPolygon Polygon;
  /// The neighbours of each corner that is not clipped yet.
  std::vector<std::int32_t> Next;
  std::vector<std::int32_t> Previous;

  /// The corners that can be inside an ear.
  lms3dCornerGrid Grid;
  ///@{
  /// In tests of a corner.
  std::size_t Work = 0;
  std::size_t MaximumWork = 0;
  std::size_t NextCheck = 0;
  ///@}
};

#endif
