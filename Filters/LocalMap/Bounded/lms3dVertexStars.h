// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The triangles of a map around its vertices, while edges collapse.
 */
#ifndef lms3dVertexStars_h
#define lms3dVertexStars_h

#include "LocalMap/Bounded/lms3dBoundedMap.h"
#include "LocalMap/Bounded/lms3dQuadric.h"
#include "LocalMap/Bounded/lms3dStarSides.h"
#include "LocalMap/Bounded/lms3dTriangleRasterizer.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

/// A mesh whose edges can collapse: both vertices become one, and the triangles at the edge vanish.
/// The star of a vertex is the set of its triangles.
class lms3dVertexStars
{
public:
  struct Vertex
  {
    /// The position is the direction from the sensor, a unit vector.
    lms3dTriangleCorner Corner;
    /// The inverse range, 1/metre.
    double Inverse;
    /// Whether the vertex may get a new place, and edges from it may collapse.
    bool IsFree;
    /// Whether its star has changed.
    bool IsChanged;
    /// Whether the vertex has a new place.
    bool HasMoved;
    std::vector<std::int32_t> Triangles;
  };

  struct Triangle
  {
    std::array<std::int32_t, 3> Corners;
    /// Whether the edge from each corner to the next one has turned out not to collapse.
    std::array<bool, 3> IsRigid = { false, false, false };
    bool IsRemoved = false;
    /// Whether it joins two patches along an offset.
    bool IsStrip = false;
  };

  /// An edge between two triangles that are not removed. The triangle on its left side and `Left`,
  /// the corner opposite to the edge, then the same on the right side.
  struct Quad
  {
    std::int32_t LeftTriangle;
    std::int32_t RightTriangle;
    std::int32_t From;
    std::int32_t To;
    std::int32_t Left;
    std::int32_t Right;
  };

  /// No vertex is free at first.
  explicit lms3dVertexStars(const lms3dBoundedMap& map);

  std::int32_t GetNumberOfVertices() const
  {
    return static_cast<std::int32_t>(this->Vertices.size());
  }
  const Vertex& GetVertex(std::int32_t vertex) const { return this->Vertices[vertex]; }
  /// The vertex must be free, or a neighbour of a free one.
  const lms3dQuadric& GetQuadric(std::int32_t vertex) const { return this->Quadrics[vertex]; }
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }

  /// In the sensor frame, metres.
  lms3dVector GetPosition(std::int32_t vertex) const
  {
    return lms3dScale(this->Vertices[vertex].Corner.Position, 1.0 / this->Vertices[vertex].Inverse);
  }

  /// By vertex, 1 for those that are free from now on. Uses the threads of the calling TBB arena.
  void SetFree(const std::vector<std::uint8_t>& isFree);
  void SetInverse(std::int32_t vertex, double inverse);

  using Border = lms3dStarBorder;

  lms3dStarSides GetSides(std::int32_t vertex) const;

  /// Finds the border at a vertex; inside of the surface, it is not open. Returns false if the
  /// triangles of the star do not follow each other around the vertex, once.
  bool FindBorder(std::int32_t vertex, Border& border) const;

  /// Does the same with the border of the surface without strips. Where there is no strip, it is
  /// that of FindBorder().
  bool FindBorderOfPatches(std::int32_t vertex, Border& border) const;

  /// Whether a triangle at the vertex joins two patches along an offset.
  bool HasStrip(std::int32_t vertex) const
  {
    return std::any_of(this->Vertices[vertex].Triangles.begin(),
      this->Vertices[vertex].Triangles.end(),
      [this](std::int32_t triangle) { return this->Triangles[triangle].IsStrip; });
  }

  /// Whether the star surrounds the vertex, once.
  bool IsInside(std::int32_t vertex) const
  {
    Border border;
    return this->FindBorder(vertex, border) && !border.IsOpen();
  }

  /// Whether two vertices have exactly two neighbours in common.
  bool AreLinked(std::int32_t a, std::int32_t b) const;

  /// The vertices with an edge to a vertex, sorted.
  std::vector<std::int32_t> GetNeighbors(std::int32_t vertex) const;

  /// Calls visit(triangle, next, last) for the triangles at a vertex. The other two corners follow
  /// the vertex counter-clockwise. Stops when a visit returns false, and returns false then.
  template <typename Visitor>
  bool ForEachTriangle(std::int32_t vertex, const Visitor& visit) const
  {
    for (std::int32_t number : this->Vertices[vertex].Triangles)
    {
      const std::array<std::int32_t, 3>& corners = this->Triangles[number].Corners;
      const int corner = corners[0] == vertex ? 0 : (corners[1] == vertex ? 1 : 2);
      if (!visit(number, corners[(corner + 1) % 3], corners[(corner + 2) % 3]))
      {
        return false;
      }
    }
    return true;
  }

  /// Calls visit(next, last) for each triangle at `from` that stays when `from` moves into its
  /// neighbour `to`. Stops when a visit returns false, and returns false then.
  template <typename Visitor>
  bool ForEachSide(std::int32_t from, std::int32_t to, const Visitor& visit) const
  {
    return this->ForEachTriangle(from,
      [&](std::int32_t, std::int32_t next, std::int32_t last)
      { return next == to || last == to || visit(next, last); });
  }

  /// Moves the vertex `from` into `to` and removes the triangles at both. Changes nothing else.
  void Merge(std::int32_t from, std::int32_t to);

  /// The same. If `to` is free, it gets a direction and an inverse range. The edges around it may
  /// collapse again.
  void Collapse(std::int32_t from, std::int32_t to, const lms3dVector& direction, double inverse);

  /// Replaces the edge between two triangles by an edge from `Left` to `Right`. Changes nothing
  /// else, so Collapse() must not be called afterwards; Merge() may. The left triangle gets the
  /// corner `From`, the right one `To`.
  void Flip(const Quad& quad);

  /// Marks an edge as rigid until the star of one of its ends changes.
  void SetRigid(std::int32_t a, std::int32_t b);

  /// Marks all edges between changed vertices as not rigid.
  void ReleaseChanged();

private:
  void Remove(std::int32_t triangle);
  bool IsAtFree(std::int32_t vertex) const;
  void UpdateQuadric(std::int32_t vertex);
  void UpdateStar(std::int32_t vertex);

  std::vector<Vertex> Vertices;
  /// By vertex. Apart, because most methods do not need them, and the rest shall fit into the
  /// cache.
  std::vector<lms3dQuadric> Quadrics;
  std::vector<Triangle> Triangles;
};

#endif
