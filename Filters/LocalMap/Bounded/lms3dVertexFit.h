// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The least-squares range of a vertex of the map, within the bound of all returns around it.
 */
#ifndef lms3dVertexFit_h
#define lms3dVertexFit_h

#include "LocalMap/Bounded/lms3dBeamDemands.h"
#include "LocalMap/Bounded/lms3dTriangleRasterizer.h"
#include "LocalMap/Bounded/lms3dVertexStars.h"

#include <limits>

/**
 * On a triangle, the inverse range is linear in the direction, and so in the inverse range of each corner.
 * Therefore each return around a vertex limits the inverse range of the vertex to an interval, and the
 * least-squares value needs one division.
 */
class lms3dVertexFit
{
public:
  explicit lms3dVertexFit(const lms3dBeamDemands& beams)
    : Beams(beams)
  {
  }

  /// The other two corners of a triangle at the vertex, and their inverse ranges.
  struct Side
  {
    const lms3dTriangleCorner& Next;
    double NextInverse;
    const lms3dTriangleCorner& Last;
    double LastInverse;
  };

  /// The same of a mesh.
  static Side GetSide(const lms3dVertexStars& stars, std::int32_t next, std::int32_t last)
  {
    const lms3dVertexStars::Vertex& a = stars.GetVertex(next);
    const lms3dVertexStars::Vertex& b = stars.GetVertex(last);
    return { a.Corner, a.Inverse, b.Corner, b.Inverse };
  }

  /// Adds the beams that hit a triangle. The positions of the corners are unit vectors. Returns false if
  /// no range of the vertex satisfies all beams; then the rest is not valid.
  bool Add(const lms3dTriangleCorner& vertex, const Side& side);

  /// Whether enough beams hit the triangles near the vertex for its range to be determined.
  bool IsDetermined() const;

  /// Whether an inverse range satisfies all beams.
  bool Allows(double inverse) const
  {
    return inverse >= this->Sum.Minimum && inverse <= this->Sum.Maximum;
  }

  /// The best inverse range that satisfies all beams.
  double GetInverse() const;

private:
  struct Triangle
  {
    lms3dTriangleRasterizer Beams;
    /// The inverse range on the triangle, in a direction d, is d.Own times that of the vertex, plus d.Rest.
    lms3dVector Own;
    lms3dVector Rest;
  };

  /// What beams demand.
  struct Sums
  {
    bool IsPossible() const { return this->Minimum <= this->Maximum; }

    double Minimum = 0.0;
    double Maximum = std::numeric_limits<double>::infinity();
    double LargestShare = 0.0;
    double Squares = 0.0;
    double Products = 0.0;
  };

  void AddColumn(const Triangle& triangle, int column, int first, int last);

  const lms3dBeamDemands& Beams;
  Sums Sum;
};

#endif
