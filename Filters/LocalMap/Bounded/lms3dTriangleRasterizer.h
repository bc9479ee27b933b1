// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Finds the beams of a scan that meet a triangle.
 */
#ifndef lms3dBeamsOfTriangle_h
#define lms3dBeamsOfTriangle_h

#include "LocalMap/Patches/lms3dBeamSphere.h"
#include "LocalMap/Patches/lms3dPlane.h"

/// A corner of a triangle in the sensor frame.
struct lms3dTriangleCorner
{
  explicit lms3dTriangleCorner(const lms3dVector& position);

  lms3dVector Position;
  /// In radians, as the columns of the sphere have it.
  double Azimuth;
  bool IsPole;
};

/**
 * The triangle faces the sensor. A column is half a great circle, so the beams of a column that meet
 * a triangle follow each other: from where it passes one edge to where it passes another. Triangles
 * side by side compute the same number for their edge, so no beam falls between them.
 */
class lms3dTriangleRasterizer
{
public:
  /// Beams outside by no more than `margin`, radians, count as well.
  lms3dTriangleRasterizer(const lms3dBeamSphere& sphere, const lms3dTriangleCorner& a,
    const lms3dTriangleCorner& b, const lms3dTriangleCorner& c, double margin = 0.0);

  const lms3dPlane& GetPlane() const { return this->Plane; }

  /// Calls visit(column, firstRow, lastRow) for each column with beams on the triangle.
  template <typename Visitor>
  void ForColumns(const Visitor& visit) const
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
  /// Normals of the planes through the sensor and an edge; beams inside lie on their positive sides.
  lms3dVector Edges[3];
  /// How far below 0 the product of an edge and a beam of length 1 may be.
  double Margins[3];
  int FirstColumn;
  int NumberOfColumns;
};

#endif
