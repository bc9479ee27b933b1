// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Forces edges into a Delaunay triangulation.
 */
#ifndef lms3dEdgeInsertion_h
#define lms3dEdgeInsertion_h

#include "Triangulation/lms3dDelaunay.h"

#include <array>
#include <cstdint>
#include <deque>

/// By flips of the edges that are in the way (Sloan 1993, "A fast algorithm for generating constrained
/// Delaunay triangulations").
class lms3dEdgeInsertion
{
public:
  /// Keeps a reference.
  explicit lms3dEdgeInsertion(lms3dDelaunay& delaunay)
    : Delaunay(delaunay)
    , Triangles(delaunay.GetTriangles())
  {
  }

  /// Fixes the edge from a to b; false where a fixed edge or a point is in the way.
  bool Insert(std::int32_t a, std::int32_t b);

private:
  using Edge = std::array<std::int32_t, 2>;

  bool FixIfPresent(std::int32_t a, std::int32_t b, int& crossed, int& edge);
  bool FindCrossedEdges(
    std::int32_t a, std::int32_t b, int triangle, int edge, std::deque<Edge>& crossed) const;
  bool Untangle(std::int32_t a, std::int32_t b, int triangle, int edge);
  bool Flip(std::int32_t a, std::int32_t b, Edge& crossing);

  lms3dDelaunay& Delaunay;
  lms3dLinkedTriangles& Triangles;
};

#endif
