// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Distances to triangles, and what beams meet of them, in double and without a miss.
 */
#ifndef TriangleTree_h
#define TriangleTree_h

#include "Fixtures/CasterFixtures.h"
#include "Geometry/lms3dVector.h"

#include <vtkType.h>

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

inline double Dot(const Vector& p, const Vector& q)
{
  return lms3dDot(p, q);
}

inline Vector Cross(const Vector& p, const Vector& q)
{
  return lms3dCross(p, q);
}

/// The distance of a point from the nearest point of a line between two, or of a triangle.
double GetDistance(const Vector& point, const Vector& a, const Vector& b);
double GetDistance(const Vector& point, const std::array<Vector, 3>& triangle);

/// Triangles in a tree of boxes. Beams start at the origin of the coordinates.
class TriangleTree
{
public:
  using Triangle = std::array<vtkIdType, 3>;

  struct Hit
  {
    double Range;
    std::size_t Triangle;
  };

  TriangleTree(std::vector<Vector> points, std::vector<Triangle> triangles);

  std::size_t GetNumberOfTriangles() const { return this->Triangles.size(); }
  std::array<Vector, 3> GetCorners(std::size_t triangle) const;

  /// From the nearest triangle, or `limit` where there is none so near.
  double GetDistance(
    const Vector& point, double limit = std::numeric_limits<double>::infinity()) const;

  /**
   * All triangles that a beam meets, in no order. `margin`, radians, is how far outside of an edge
   * it may pass; below 0 it must pass as far inside. Triangles edge-on are not met.
   */
  void Cast(const Vector& direction, double margin, std::vector<Hit>& hits) const;

private:
  /// Leaves have triangles of Order; the first child of another node follows it.
  struct Node
  {
    Vector Low;
    Vector High;
    std::size_t First = 0;
    std::size_t Count = 0;
    std::size_t Other = 0;
  };

  void Build();
  /// Sorts a node's triangles into halves; returns how many are in the first.
  std::size_t Halve(const Node& node, std::size_t count);
  void Enclose(Node& node, std::size_t first, std::size_t count) const;
  void CastAt(
    std::size_t triangle, const Vector& direction, double margin, std::vector<Hit>& hits) const;

  std::vector<Vector> Points;
  std::vector<Triangle> Triangles;
  std::vector<std::size_t> Order;
  std::vector<Vector> Centers;
  std::vector<Node> Nodes;
};

#endif
