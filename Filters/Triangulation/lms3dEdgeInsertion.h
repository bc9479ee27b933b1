// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Inserts constrained edges into a Delaunay triangulation.
 */
#ifndef lms3dEdgeInsertion_h
#define lms3dEdgeInsertion_h

#include "Triangulation/lms3dDelaunay.h"

#include <array>
#include <cstdint>
#include <deque>

/// Flips the edges that cross the new edge (Sloan 1993, "A fast algorithm for generating
/// constrained Delaunay triangulations").
class lms3dEdgeInsertion
{
public:
  /// Keeps a reference.
  explicit lms3dEdgeInsertion(lms3dDelaunay& delaunay)
    : Delaunay(delaunay)
    , Triangles(delaunay.GetTriangles())
  {
  }

  /// Inserts the edge between two inserted points and constrains it. Returns false if a constrained
  /// edge or a point is in the way, or if the points are the same.
  bool Insert(std::int32_t a, std::int32_t b);

private:
  using Edge = std::array<std::int32_t, 2>;

  template <typename Visitor>
  bool FindAround(std::int32_t vertex, const Visitor& visit) const;
  bool ConstrainIfPresent(std::int32_t a, std::int32_t b);
  bool FindFirstCrossed(std::int32_t a, std::int32_t b, int& crossed, int& edge) const;
  bool FindCrossedEdges(
    std::int32_t a, std::int32_t b, int triangle, int edge, std::deque<Edge>& crossed) const;
  bool FlipCrossedEdges(std::int32_t a, std::int32_t b, int triangle, int edge);
  bool Flip(std::int32_t a, std::int32_t b, Edge& crossing);

  lms3dDelaunay& Delaunay;
  lms3dLinkedTriangles& Triangles;
};

#endif
