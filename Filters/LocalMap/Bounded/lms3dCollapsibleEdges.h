// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The edges of a map that may collapse, sorted by cost.
 */
#ifndef lms3dCollapsibleEdges_h
#define lms3dCollapsibleEdges_h

#include "LocalMap/Bounded/lms3dVertexStars.h"

#include <cstddef>
#include <cstdint>
#include <vector>

/**
 * Keeps the edges with a free end that are not rigid. The cost of an edge is the smallest value of
 * the quadrics of its ends (lms3dQuadric). After edges collapsed, only the costs of edges near them
 * are computed again.
 */
class lms3dCollapsibleEdges
{
public:
  /// An edge between two vertices. `From` is free.
  struct Edge
  {
    double Cost;
    std::int32_t From;
    std::int32_t To;
    /// Three times the triangle on the left side of the edge, plus its corner where the edge
    /// starts.
    std::int32_t Side;
  };

  /// Keeps a reference. Uses the threads of the calling TBB arena.
  explicit lms3dCollapsibleEdges(const lms3dVertexStars& stars);

  /// Takes out edges, the cheapest first, whose stars have no vertex in common.
  std::vector<Edge> TakeIndependent();

  /// Where the vertex that replaces an edge fits the triangles around both ends best.
  static lms3dVector GetBestPlace(const lms3dVertexStars& stars, const Edge& edge);

  /// Takes changes into account: the stars of these vertices, into which edges collapsed. `gone`
  /// are the vertices that these edges removed. Uses the threads of the calling TBB arena.
  void Update(const std::vector<std::int32_t>& changed, const std::vector<std::int32_t>& gone);

private:
  void MarkChanged(std::int32_t vertex, std::vector<std::int32_t>& marked);
  std::vector<std::int32_t> FindTriangles(const std::vector<std::int32_t>& vertices);
  bool AreFree(const Edge& edge) const;
  void Use(const Edge& edge);
  void AppendEdges(std::int32_t number, std::vector<Edge>& edges) const;
  void Sort(std::vector<Edge>& edges) const;
  void MergeIn(const std::vector<Edge>& edges);

  const lms3dVertexStars& Stars;
  std::vector<Edge> Sorted;
  /// Memory for what will be Sorted.
  std::vector<Edge> Merged;
  /// By vertex and by triangle: whether it is among those whose edges are computed again. Not
  /// vector<bool>, which is slower.
  std::vector<std::uint8_t> IsChanged;
  std::vector<std::uint8_t> IsFound;
  /// By vertex: the number of the selection that used it last.
  std::vector<std::int32_t> Uses;
  std::int32_t Selection = 0;
};

#endif
