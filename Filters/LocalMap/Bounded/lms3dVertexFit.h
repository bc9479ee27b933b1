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

#include <cstdint>
#include <limits>

/**
 * On a triangle, the inverse range is linear in the direction, and so in the inverse range of each
 * corner. Therefore each return around a vertex limits the inverse range of the vertex to an
 * interval, and the least-squares value needs one division.
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

  /// Adds the beams that hit a triangle. The positions of the corners are unit vectors. Returns
  /// false if no range of the vertex satisfies all beams; then the rest is not valid.
  bool Add(const lms3dTriangleCorner& vertex, const Side& side);

  /// Whether enough beams hit the triangles near the vertex for its range to be determined.
  bool IsDetermined() const;

  /// Whether an inverse range of the vertex satisfies all beams that hit a triangle. Decides the
  /// same as Add() and Allows(inverse), and is faster.
  static bool Allows(const lms3dBeamDemands& beams, const lms3dTriangleCorner& vertex,
    double inverse, const Side& side);

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
    Triangle(const lms3dBeamSphere& sphere, const lms3dTriangleCorner& vertex, const Side& side);

    lms3dTriangleRasterizer Beams;
    /// The inverse range on the triangle, in a direction d, is d.Own times that of the vertex, plus
    /// d.Rest.
    lms3dVector Own;
    lms3dVector Rest;
  };

  /// A triangle on the beams of a column.
  struct ColumnShares
  {
    ColumnShares(const lms3dBeamSphere& sphere, const Triangle& triangle, int column);

    double GetOwn(int row) const
    {
      return this->OwnLevel * this->Cosines[row] + this->OwnUp * this->Sines[row];
    }
    double GetRest(int row) const
    {
      return this->RestLevel * this->Cosines[row] + this->RestUp * this->Sines[row];
    }

    const double* Cosines;
    const double* Sines;
    double OwnLevel;
    double OwnUp;
    double RestLevel;
    double RestUp;
  };

  /// Consecutive rows, both ends included.
  struct Rows
  {
    int First;
    int Last;
  };

  /// What beams demand.
  struct Sums
  {
    bool IsPossible() const { return this->Minimum <= this->Maximum; }

    double Minimum = 0.0;
    double Maximum = std::numeric_limits<double>::infinity();
    /// The number of beams that determine the range.
    std::int64_t DeterminingBeams = 0;
    double Squares = 0.0;
    double Products = 0.0;
  };

  void AddColumn(const Triangle& triangle, int column, const Rows& rows);
  static bool KeepsInterval(const lms3dBeamDemands::Demands& demands, const ColumnShares& shares,
    const Rows& rows, const Sums& sums);
  static void Narrow(const lms3dBeamDemands::Demands& demands, const ColumnShares& shares,
    const Rows& rows, Sums& sums);
  static void AddSquares(const double* ranges, const lms3dBeamDemands::Demands& demands,
    const ColumnShares& shares, const Rows& rows, Sums& sums);
  static bool AllowsColumn(const lms3dBeamDemands::Demands& demands, const ColumnShares& shares,
    const Rows& rows, double inverse);
  static bool AllowsExactly(const lms3dBeamDemands::Demands& demands, const ColumnShares& shares,
    const Rows& rows, double inverse);

  const lms3dBeamDemands& Beams;
  Sums Sum;
};

#endif
