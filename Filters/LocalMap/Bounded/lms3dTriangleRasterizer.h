// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the beams of a scan that hit a triangle, column by column.
 */
#ifndef lms3dTriangleRasterizer_h
#define lms3dTriangleRasterizer_h

#include "LocalMap/Patches/lms3dBeamSphere.h"
#include "LocalMap/Patches/lms3dPlane.h"

#include <array>

/// A corner of a triangle, with what all triangles at it share.
struct lms3dTriangleCorner
{
  /// `position` in the sensor frame, metres. It must not be the sensor itself.
  explicit lms3dTriangleCorner(const lms3dVector& position);

  lms3dVector Position;
  /// The platform angle, -pi to pi radians, in the direction of lms3dBeamSphere::GetAzimuths().
  double Azimuth;
  /// Whether the corner lies on the platform's axis, where the azimuth is undefined.
  bool IsPole;
};

/**
 * Scan conversion of a triangle onto the grid of beams. A column of lms3dBeamSphere is half of a
 * great circle, so the beams of a column that hit a triangle are consecutive: from where the column
 * crosses one edge to where it crosses another. Triangles that share an edge compute the same
 * numbers for it, so no beam falls between them; a beam on a shared edge hits both.
 *
 * If beams are not regular, each beam is tested by itself, from where it starts. Triangles that
 * share an edge compute the same numbers then, too.
 *
 * The triangle must face the sensor and lie within a half-space in front of it.
 */
class lms3dTriangleRasterizer
{
public:
  /// A margin for beams through a vertex, radians. Rounding can put them outside of all triangles
  /// there.
  static constexpr double VertexMargin = 1e-9;

  /// Keeps a reference to the sphere. Beams that pass outside of the triangle by at most `margin`,
  /// radians, count as hits.
  lms3dTriangleRasterizer(const lms3dBeamSphere& sphere, const lms3dTriangleCorner& a,
    const lms3dTriangleCorner& b, const lms3dTriangleCorner& c, double margin = 0.0);

  /// The range at which the beam of a row, in one column, meets the plane of the triangle, from the
  /// start of the beam, metres.
  class ColumnRanges
  {
  public:
    ColumnRanges(const lms3dTriangleRasterizer& triangle, int column)
      : Triangle(triangle)
      , Plane(triangle.Plane, triangle.Sphere, column)
      , Start(triangle.Sphere.GetIndex(column, 0))
      , IsRegular(triangle.Sphere.IsRegular())
    {
    }

    double GetRange(int row) const
    {
      return this->IsRegular ? 1.0 / this->Plane.GetInverseRange(row)
                             : this->Triangle.GetRangeOnRay(this->Start + row);
    }

    const lms3dColumnPlane& GetPlane() const { return this->Plane; }

  private:
    const lms3dTriangleRasterizer& Triangle;
    const lms3dColumnPlane Plane;
    const lms3dBeamSphere::GridIndex Start;
    const bool IsRegular;
  };

  /// The number of columns that can have beams that hit.
  int GetNumberOfColumns() const { return this->NumberOfColumns; }

  /// Calls visit(column, firstRow, lastRow), rows included, for each column with beams that hit.
  template <typename Visitor>
  void ForEachColumn(const Visitor& visit) const
  {
    this->ForEachColumnWhile(
      [&](int column, int first, int last)
      {
        visit(column, first, last);
        return true;
      });
  }

  /// The same. Stops when a visit returns false, and returns false then.
  template <typename Visitor>
  bool ForEachColumnWhile(const Visitor& visit) const
  {
    return this->ForEachColumnOf([](int) { return true; }, visit);
  }

  /// The same for the columns for which isIncluded(column) returns true.
  template <typename Predicate, typename Visitor>
  bool ForEachColumnOf(const Predicate& isIncluded, const Visitor& visit) const
  {
    const int columns = this->Sphere.GetNumberOfColumns();
    int column = this->FirstColumn;
    NearRows near;
    bool goesOn = true;
    for (int i = 0; i < this->NumberOfColumns && goesOn; ++i)
    {
      if (!isIncluded(column))
      {
        near = {};
      }
      else if (!this->Sphere.IsRegular())
      {
        FanView view;
        goesOn = !this->MeetsFan(column, view) || this->ForEachRay(column, view, visit);
      }
      else if (this->FindRows(column, near))
      {
        goesOn = visit(column, near.First, near.Last);
      }
      column = column + 1 < columns ? column + 1 : 0;
    }
    return goesOn;
  }

private:
  static constexpr int NoRow = -1;

  /// The rows of a column, or NoRow, and how far they lie from the rows of the column before. The
  /// next column goes on like this, or nearly.
  struct NearRows
  {
    int First = NoRow;
    int Last = NoRow;
    int FirstStep = 0;
    int LastStep = 0;
  };

  using Edges3 = std::array<lms3dVector, 3>;

  static Edges3 MakeEdges(const lms3dVector& a, const lms3dVector& b, const lms3dVector& c);
  static double GetDistanceFromAxis(const lms3dVector& a, const lms3dVector& b);

  /// The corners in the half-plane of a fan, from where its rays start: along the horizontal
  /// direction of the fan and upwards, metres.
  struct FanView
  {
    /// Returns true only if a ray of the fan passes above all corners, or below all.
    bool IsMissedBy(const lms3dVector& direction) const
    {
      const double level = direction[0] * this->Level[0] + direction[1] * this->Level[1];
      int above = 0;
      int below = 0;
      for (int i = 0; i < 3; ++i)
      {
        const double side = direction[2] * this->Along[i] - level * this->Up[i];
        above += side > this->Tolerance[i] ? 1 : 0;
        below += side < -this->Tolerance[i] ? 1 : 0;
      }
      return above == 3 || below == 3;
    }

    /// False if the platform turns during the fan. Then nothing else is valid.
    bool IsPlane = false;
    double Level[2];
    double Along[3];
    double Up[3];
    double Tolerance[3];
  };

  template <typename Visitor>
  bool ForEachRay(int column, const FanView& view, const Visitor& visit) const
  {
    bool goesOn = true;
    const lms3dBeamSphere::GridIndex start = this->Sphere.GetIndex(column, 0);
    for (int row = 0; row < this->Sphere.GetNumberOfRows() && goesOn; ++row)
    {
      const bool isMissed =
        view.IsPlane && view.IsMissedBy(this->Sphere.GetRays()[start + row].Direction);
      if (!isMissed && this->IsHitByRay(start + row))
      {
        goesOn = visit(column, row, row);
      }
    }
    return goesOn;
  }

  bool MeetsFan(int column, FanView& view) const;
  bool IsHitByRay(lms3dBeamSphere::GridIndex index) const;
  double GetRangeOnRay(lms3dBeamSphere::GridIndex index) const;
  double GetParallax(
    const lms3dTriangleCorner& a, const lms3dTriangleCorner& b, const lms3dTriangleCorner& c) const;
  void FindColumns(
    const lms3dTriangleCorner& a, const lms3dTriangleCorner& b, const lms3dTriangleCorner& c);
  /// Finds the rows of a column. `rows` are the rows of the column before. Returns false if no beam
  /// of the column hits.
  bool FindRows(int column, NearRows& rows) const;

  const lms3dBeamSphere& Sphere;
  lms3dPlane Plane;
  /// Normals of the planes through the sensor and an edge. Beams inside lie on their positive
  /// sides.
  Edges3 Edges;
  /// The corners, and a normal towards the origin, of any length.
  Edges3 Corners;
  lms3dVector Normal;
  /// How far below 0 the product of an edge and a beam of length 1 may be.
  double Margins[3];
  /// -1 by the upward component of each edge.
  double Slopes[3];
  double Margin;
  int FirstColumn;
  int NumberOfColumns;
};

#endif
