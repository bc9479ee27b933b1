// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief A triangle mesh with links between neighbours, which can be split and flipped.
 */
#ifndef lms3dLinkedTriangles_h
#define lms3dLinkedTriangles_h

#include <array>
#include <cstdint>
#include <vector>

/// Holds the topology only: which points the triangles have, not the points' coordinates. Corners
/// and edges of a triangle have the numbers 0 to 2; edge i runs from corner i to the next one.
class lms3dLinkedTriangles
{
public:
  /// Stands for a triangle, a point or an edge that does not exist.
  static constexpr std::int32_t None = -1;

  /// The number of the next and of the previous corner or edge.
  static constexpr int Next[3] = { 1, 2, 0 };
  static constexpr int Previous[3] = { 2, 0, 1 };

  struct Triangle
  {
    /// Numbers of points, counter-clockwise.
    std::array<std::int32_t, 3> Corners;
    /// The triangles across the edges, or None.
    std::array<std::int32_t, 3> Neighbors;
    /// Whether the edges are constrained: they must not be flipped.
    std::array<bool, 3> IsConstrained;
    /// A mark for the user of the mesh. Parts of a triangle inherit it.
    bool IsInside;
  };

  /// Starts with one triangle, of the last three of `points` points. Reserves memory for `expected`
  /// points.
  lms3dLinkedTriangles(std::int32_t points, std::size_t expected);

  int GetNumberOfTriangles() const { return static_cast<int>(this->Triangles.size()); }
  const Triangle& GetTriangle(int triangle) const { return this->Triangles[triangle]; }
  /// One of the triangles at a point; None if no triangle has it.
  int GetTriangleAt(std::int32_t point) const { return this->TriangleAt[point]; }

  /// The corner at which a triangle has a point. It must have the point.
  int FindCorner(int triangle, std::int32_t point) const
  {
    const std::array<std::int32_t, 3>& corners = this->Triangles[triangle].Corners;
    return corners[0] == point ? 0 : (corners[1] == point ? 1 : 2);
  }

  /// The edge across which a triangle has a neighbour. It must have the neighbour.
  int FindEdge(int triangle, int neighbor) const
  {
    const std::array<std::int32_t, 3>& neighbors = this->Triangles[triangle].Neighbors;
    return neighbors[0] == neighbor ? 0 : (neighbors[1] == neighbor ? 1 : 2);
  }

  /// The point of a triangle opposite to an edge.
  std::int32_t GetApex(int triangle, int edge) const
  {
    return this->Triangles[triangle].Corners[Previous[edge]];
  }
  /// The point of the neighbour across an edge opposite to that edge.
  std::int32_t GetOpposite(int triangle, int edge) const
  {
    const int other = this->Triangles[triangle].Neighbors[edge];
    return this->GetApex(other, this->FindEdge(other, triangle));
  }

  /// Adds a point behind all others, without a triangle, or removes it again.
  void AddPoint() { this->TriangleAt.push_back(None); }
  void RemovePoint() { this->TriangleAt.pop_back(); }

  /// Splits a triangle into three around a point. Returns them, one for each edge.
  std::array<int, 3> SplitTriangle(std::int32_t point, int triangle);

  /// Splits both triangles at an edge into two each around a point on the edge. Returns all four.
  std::array<int, 4> SplitEdge(std::int32_t point, int triangle, int edge);

  /// Flips the edge between two triangles. The triangles keep their numbers.
  void Flip(int triangle, int edge);

  /// Constrains an edge on both sides.
  void Constrain(int triangle, int edge);
  void SetInside(int triangle) { this->Triangles[triangle].IsInside = true; }

private:
  void Relink(int triangle, int from, int to);

  std::vector<Triangle> Triangles;
  std::vector<std::int32_t> TriangleAt;
};

#endif
