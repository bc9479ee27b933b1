// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The Delaunay triangulation of points that are inserted one by one.
 */
#ifndef lms3dDelaunay_h
#define lms3dDelaunay_h

#include "Triangulation/lms3dLinkedTriangles.h"
#include "Triangulation/lms3dOrientation.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * Each point splits the triangle that it lies in, and edges are flipped as Delaunay's rule asks
 * (Lawson 1977, "Software for C1 surface interpolation"), but for those that are fixed. One triangle
 * around all points, the frame, is there at the beginning.
 */
class lms3dDelaunay
{
public:
  static constexpr std::int32_t None = lms3dLinkedTriangles::None;

  /// The points are not inserted yet; behind them come the three corners of the frame.
  explicit lms3dDelaunay(std::vector<lms3dPoint2> points);

  const lms3dLinkedTriangles& GetTriangles() const { return this->Triangles; }
  lms3dLinkedTriangles& GetTriangles() { return this->Triangles; }
  bool IsFrame(std::int32_t point) const
  {
    return point >= this->FirstOfFrame && point < this->FirstOfFrame + 3;
  }

  /// Inserts one of the points, to be found from a triangle near by; false where there is a point
  /// already or a fixed edge.
  bool Insert(std::int32_t point, int near);

  /// The same for a new point inside the region; returns its number or None.
  std::int32_t InsertInside(const lms3dPoint2& point, int near);

  /// 1 where the third point lies left of the line from the first to the second, -1 right, else 0.
  int Orient(std::int32_t a, std::int32_t b, std::int32_t c) const
  {
    return lms3dGetOrientation(this->Points[a], this->Points[b], this->Points[c]);
  }

  /// The triangle left of the edge from a to b, which exists.
  int FindTriangle(std::int32_t a, std::int32_t b, int& edge) const;

  /// Whether the two triangles at an edge form a convex quadrilateral.
  bool IsConvex(int triangle, int edge) const;

  /// Has Restore() look at the edge of a triangle opposite of one of its points.
  void Suspect(int triangle, std::int32_t apex) { this->Suspects.push_back({ triangle, apex }); }

  /// Flips what Delaunay's rule asks for, starting at the suspects.
  void Restore();

private:
  /// Where a point lies: in a triangle, on one of its edges, or at a corner.
  struct Location
  {
    int Triangle;
    int Edge = None;
    bool IsCorner = false;
  };

  static std::vector<lms3dPoint2> AddFrame(std::vector<lms3dPoint2> points);
  Location Locate(const lms3dPoint2& point, int near) const;
  int FindWayOut(const lms3dPoint2& point, int triangle, int from, Location& location) const;
  bool InsertAt(std::int32_t point, const Location& location);
  int FindTriangleAround(std::int32_t a, std::int32_t b, int& edge) const;
  bool IsBetterFlipped(int triangle, int edge) const;

  std::vector<lms3dPoint2> Points;
  std::int32_t FirstOfFrame;
  lms3dLinkedTriangles Triangles;
  std::vector<std::array<std::int32_t, 2>> Suspects;
};

#endif
