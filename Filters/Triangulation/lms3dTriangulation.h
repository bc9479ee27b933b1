// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The constrained Delaunay triangulation of a polygon with holes.
 */
#ifndef lms3dTriangulation_h
#define lms3dTriangulation_h

#include "Triangulation/lms3dDelaunay.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * Inserts all points, then the edges of the outline, then marks the triangles inside. More points
 * may be inserted inside afterwards. Orientation tests are exact, so triangles never overlap. The
 * in-circle test is not, so shapes may differ from the Delaunay triangulation by a rounding error.
 *
 * Coordinates have any unit. Points are numbered as in lms3dDelaunay.
 */
class lms3dTriangulation
{
public:
  static constexpr std::int32_t None = lms3dDelaunay::None;

  /**
   * `loops` holds the numbers of the outline's points, loop after loop: counter-clockwise loops
   * around the polygon, clockwise loops around its holes. `loopEnds` holds the end of each loop in
   * `loops`. Loops may touch at points only. There must be a point, and no two points may coincide.
   */
  lms3dTriangulation(std::vector<lms3dPoint2> points, const std::vector<std::int32_t>& loops,
    const std::vector<std::int32_t>& loopEnds);

  /// False if loops cross, overlap or have the wrong direction. No other method may be called then.
  bool IsValid() const { return this->Valid; }

  /// Counts triangles inside and outside.
  int GetNumberOfTriangles() const { return this->Delaunay.GetTriangles().GetNumberOfTriangles(); }
  /// Whether a triangle belongs to the polygon.
  bool IsInside(int triangle) const
  {
    return this->Delaunay.GetTriangles().GetTriangle(triangle).IsInside;
  }
  /// The points of a triangle, counter-clockwise.
  const std::array<std::int32_t, 3>& GetCorners(int triangle) const
  {
    return this->Delaunay.GetTriangles().GetTriangle(triangle).Corners;
  }

  /**
   * Adds a point inside the polygon. The search for it starts at triangle `near`. Returns its
   * number, which follows the given points, the three corners of the super-triangle and points
   * added before. Returns None if the point lies outside, or if there is a point or an edge of the
   * outline already.
   */
  std::int32_t Insert(const lms3dPoint2& point, int near)
  {
    return this->Delaunay.InsertInside(point, near);
  }

private:
  using Numbers = std::vector<std::int32_t>;

  bool InsertPoints(std::int32_t count);
  bool InsertLoops(const Numbers& loops, const Numbers& loopEnds);
  bool MarkInside(const Numbers& loops, const Numbers& loopEnds);
  void Enter(int triangle, std::vector<int>& stack);
  bool IsAtSuperTriangle(int triangle) const;
  template <typename Visitor>
  static bool ForEdges(const Numbers& loops, const Numbers& loopEnds, const Visitor& visit);

  lms3dDelaunay Delaunay;
  bool Valid;
};

#endif
