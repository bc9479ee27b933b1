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
 * Scan conversion of a triangle onto the grid of beams. A column of lms3dBeamSphere is half of a great
 * circle, so the beams of a column that hit a triangle are consecutive: from where the column crosses
 * one edge to where it crosses another. Triangles that share an edge compute the same numbers for it,
 * so no beam falls between them; a beam on a shared edge hits both.
 *
 * The triangle must face the sensor and lie within a half-space in front of it.
 */
class lms3dTriangleRasterizer
{
public:
  /// Keeps a reference to the sphere. Beams that pass outside of the triangle by at most `margin`,
  /// radians, count as hits.
  lms3dTriangleRasterizer(const lms3dBeamSphere& sphere, const lms3dTriangleCorner& a,
    const lms3dTriangleCorner& b, const lms3dTriangleCorner& c, double margin = 0.0);

  /// The plane of the triangle.
  const lms3dPlane& GetPlane() const { return this->Plane; }

  /// Calls visit(column, firstRow, lastRow), rows included, for each column with beams that hit.
  template <typename Visitor>
  void ForEachColumn(const Visitor& visit) const
  {
    const int columns = this->Sphere.GetNumberOfColumns();
    int column = this->FirstColumn;
    for (int i = 0; i < this->NumberOfColumns; ++i)
    {
      int firstRow, lastRow;
      if (this->FindRows(column, firstRow, lastRow))
      {
        visit(column, firstRow, lastRow);
      }
      column = column + 1 < columns ? column + 1 : 0;
    }
  }

private:
  void FindColumns(
    const lms3dTriangleCorner& a, const lms3dTriangleCorner& b, const lms3dTriangleCorner& c);
  bool FindRows(int column, int& first, int& last) const;

  const lms3dBeamSphere& Sphere;
  lms3dPlane Plane;
  /// Normals of the planes through the sensor and an edge. Beams inside lie on their positive sides.
  lms3dVector Edges[3];
  /// How far below 0 the product of an edge and a beam of length 1 may be.
  double Margins[3];
  int FirstColumn;
  int NumberOfColumns;
};

#endif
