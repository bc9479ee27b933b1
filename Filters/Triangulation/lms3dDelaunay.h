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
 * Incremental construction with edge flips (Lawson 1977, "Software for C1 surface interpolation"):
 * each point splits the triangle in which it lies, then illegal edges are flipped, except
 * constrained ones. A super-triangle around all points is there from the beginning.
 *
 * Points are numbered in the order given; the corners of the super-triangle follow, then added
 * points. Coordinates have any unit.
 */
class lms3dDelaunay
{
public:
  static constexpr std::int32_t None = lms3dLinkedTriangles::None;

  /// Takes at least one point. The points are not inserted yet.
  explicit lms3dDelaunay(std::vector<lms3dPoint2> points);

  const lms3dLinkedTriangles& GetTriangles() const { return this->Triangles; }
  lms3dLinkedTriangles& GetTriangles() { return this->Triangles; }
  bool IsSuperTriangleCorner(std::int32_t point) const
  {
    return point >= this->FirstOfSuperTriangle && point < this->FirstOfSuperTriangle + 3;
  }

  /// Inserts one of the points. The search for its triangle starts at triangle `near`. Returns
  /// false if the point coincides with another one or lies on a constrained edge.
  bool Insert(std::int32_t point, int near);

  /// Adds a point and inserts it, if it lies in a triangle that is inside. Returns its number, or
  /// None as Insert() returns false.
  std::int32_t InsertInside(const lms3dPoint2& point, int near);

  /// 1 if point c lies left of the line from a to b, -1 if right, 0 if on it. Exact.
  int Orient(std::int32_t a, std::int32_t b, std::int32_t c) const
  {
    return lms3dGetOrientation(this->Points[a], this->Points[b], this->Points[c]);
  }

  /// The triangle to the left of the edge from a to b, which must exist. `edge` receives its number
  /// in the triangle.
  int FindTriangle(std::int32_t a, std::int32_t b, int& edge) const;

  /// Whether the two triangles at an edge form a strictly convex quadrilateral.
  bool IsConvex(int triangle, int edge) const;

  /// Queues the edge of a triangle opposite to one of its corners for LegalizeEdges().
  void QueueEdge(int triangle, std::int32_t apex) { this->Pending.push_back({ triangle, apex }); }

  /// Flips all queued edges that violate the Delaunay criterion, and the edges that become illegal
  /// by it.
  void LegalizeEdges();

private:
  /// Where a point lies: inside a triangle, on one of its edges, or at a corner.
  struct Location
  {
    int Triangle;
    int Edge = None;
    bool IsCorner = false;
  };

  static std::vector<lms3dPoint2> AddSuperTriangle(std::vector<lms3dPoint2> points);
  Location Locate(const lms3dPoint2& point, int near) const;
  int FindExitEdge(const lms3dPoint2& point, int triangle, int from, Location& location) const;
  bool InsertAt(std::int32_t point, const Location& location);
  int FindTriangleAt(std::int32_t a, std::int32_t b, int& edge) const;
  bool IsIllegal(int triangle, int edge) const;

  std::vector<lms3dPoint2> Points;
  std::int32_t FirstOfSuperTriangle;
  lms3dLinkedTriangles Triangles;
  /// Edges to check: a triangle and the corner opposite to the edge.
  std::vector<std::array<std::int32_t, 2>> Pending;
};

#endif
