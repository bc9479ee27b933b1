// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The constrained Delaunay triangulation of a region with holes.
 */
#ifndef lms3dTriangulation_h
#define lms3dTriangulation_h

#include "Triangulation/lms3dDelaunay.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * Points are inserted one by one, then the edges of the outline are forced, and the triangles outside
 * of it are taken out. After that, points may be inserted inside. Orientations are exact, so the
 * triangles never overlap; whether a point lies in a circle is asked in plain arithmetic, so shapes
 * may miss the best by a rounding error.
 */
class lms3dTriangulation
{
public:
  static constexpr std::int32_t None = lms3dDelaunay::None;

  /**
   * `points` with counter-clockwise loops of their numbers (clockwise around holes) that end at
   * `loopEnds`. Loops may meet at points, no more.
   */
  lms3dTriangulation(std::vector<lms3dPoint2> points, const std::vector<std::int32_t>& loops,
    const std::vector<std::int32_t>& loopEnds);

  /// False where loops cross, overlap or turn the wrong way; there is nothing else to ask then.
  bool IsValid() const { return this->Valid; }

  int GetNumberOfTriangles() const { return this->Delaunay.GetTriangles().GetNumberOfTriangles(); }
  /// Whether a triangle is a part of the region.
  bool IsInside(int triangle) const
  {
    return this->Delaunay.GetTriangles().GetTriangle(triangle).IsInside;
  }
  const std::array<std::int32_t, 3>& GetCorners(int triangle) const
  {
    return this->Delaunay.GetTriangles().GetTriangle(triangle).Corners;
  }

  /**
   * Adds a point within the region, to be found from a triangle near by; returns its number
   * (behind the given points and the three of a frame), or None where there is a point already, or
   * an edge of the outline.
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
  bool IsAtFrame(int triangle) const;
  template <typename Visitor>
  static bool ForEdges(const Numbers& loops, const Numbers& loopEnds, const Visitor& visit);

  lms3dDelaunay Delaunay;
  bool Valid;
};

#endif
