// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Triangles that know their neighbours, split and flipped.
 */
#ifndef lms3dLinkedTriangles_h
#define lms3dLinkedTriangles_h

#include <array>
#include <cstdint>
#include <vector>

/// Knows which points are joined, but not where they are.
class lms3dLinkedTriangles
{
public:
  /// In place of a triangle, a point or an edge.
  static constexpr std::int32_t None = -1;

  /// The edge or corner after each, and the one before.
  static constexpr int Next[3] = { 1, 2, 0 };
  static constexpr int Last[3] = { 2, 0, 1 };

  struct Triangle
  {
    /// Counter-clockwise.
    std::array<std::int32_t, 3> Corners;
    /// The triangles across the edges from each corner to the next.
    std::array<std::int32_t, 3> Neighbors;
    std::array<bool, 3> IsFixed;
    bool IsInside;
  };

  /// Begins with one triangle, of the last three of so many points; `expected` points may come.
  lms3dLinkedTriangles(std::int32_t points, std::size_t expected);

  int GetNumberOfTriangles() const { return static_cast<int>(this->Triangles.size()); }
  const Triangle& GetTriangle(int triangle) const { return this->Triangles[triangle]; }
  /// A triangle at a point that has been added.
  int GetTriangleAt(std::int32_t point) const { return this->TriangleAt[point]; }

  /// Which corner a point is; it is one of them.
  int FindCorner(int triangle, std::int32_t point) const
  {
    const std::array<std::int32_t, 3>& corners = this->Triangles[triangle].Corners;
    return corners[0] == point ? 0 : (corners[1] == point ? 1 : 2);
  }

  /// Across which edge a neighbour lies.
  int FindEdge(int triangle, int neighbor) const
  {
    const std::array<std::int32_t, 3>& neighbors = this->Triangles[triangle].Neighbors;
    return neighbors[0] == neighbor ? 0 : (neighbors[1] == neighbor ? 1 : 2);
  }

  /// The corner of a triangle that does not lie on an edge, and that of the neighbour across it.
  std::int32_t GetApex(int triangle, int edge) const
  {
    return this->Triangles[triangle].Corners[Last[edge]];
  }
  std::int32_t GetOpposite(int triangle, int edge) const
  {
    const int other = this->Triangles[triangle].Neighbors[edge];
    return this->GetApex(other, this->FindEdge(other, triangle));
  }

  /// For a point behind all others.
  void AddPoint() { this->TriangleAt.push_back(None); }
  void RemovePoint() { this->TriangleAt.pop_back(); }

  /// Into three around a point, one to each edge; returns them.
  std::array<int, 3> SplitTriangle(std::int32_t point, int triangle);

  /// The triangles on both sides of an edge, into two each around a point on it; returns all four.
  std::array<int, 4> SplitEdge(std::int32_t point, int triangle, int edge);

  /// Turns the edge between two triangles, which keep their numbers.
  void Flip(int triangle, int edge);

  /// Fixes an edge on both sides.
  void Fix(int triangle, int edge);
  void SetInside(int triangle) { this->Triangles[triangle].IsInside = true; }

private:
  void Relink(int triangle, int from, int to);

  std::vector<Triangle> Triangles;
  std::vector<std::int32_t> TriangleAt;
};

#endif
