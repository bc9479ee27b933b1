// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The triangulation of a patch within its outline.
 */
#ifndef lms3dPatchTriangulation_h
#define lms3dPatchTriangulation_h

#include "LocalMap/Borders/lms3dPatchOutlines.h"
#include "LocalMap/Bounded/lms3dTriangleRasterizer.h"
#include "Triangulation/lms3dTriangulation.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

/**
 * Projects the outline of a patch from the sensor onto a plane and triangulates it there
 * (constrained Delaunay). The plane is parallel to the patch's plane, so that distances are true on
 * the surface; if parts of the outline lie behind it, the plane that faces the outline's mean
 * direction takes its place.
 *
 * Vertices are numbered as the triangulation numbers them: the vertices of the outline in ascending
 * order, three of the triangulation's super-triangle, then the vertices that Insert() adds.
 */
class lms3dPatchTriangulation
{
public:
  /// `axis` is the normal of the patch's plane, of any length, away from the sensor. Keeps a
  /// reference to the outlines.
  lms3dPatchTriangulation(const lms3dPatchOutlines& outlines, int patch, const lms3dVector& axis);

  /// False if the outline crosses itself in both projections. No other method may be called then.
  bool IsValid() const { return this->Valid; }

  int GetNumberOfTriangles() const { return this->Triangulation->GetNumberOfTriangles(); }
  /// Whether a triangle belongs to the patch.
  bool IsInside(int triangle) const { return this->Triangulation->IsInside(triangle); }
  /// The numbers of a triangle's vertices, counter-clockwise as the sensor sees them.
  const std::array<std::int32_t, 3>& GetCorners(int triangle) const
  {
    return this->Triangulation->GetCorners(triangle);
  }
  const lms3dTriangleCorner& GetVertex(std::int32_t number) const { return this->Corners[number]; }

  /// Adds a vertex inside the patch. The search for it starts at triangle `near`. Returns false if
  /// there is a vertex or an edge of the outline already, or if it lies outside of the patch.
  bool Insert(const lms3dMapVertex& vertex, int near);

  /// The vertex on a beam at a range from the start of the beam, metres.
  static lms3dMapVertex MakeVertex(
    const lms3dBeamSphere& sphere, lms3dBeamSphere::GridIndex beam, double range);

  /// All vertices that Insert() added.
  std::vector<lms3dMapVertex> GetAddedVertices() const;

  /// The triangles of the patch with the vertex numbers of the outlines. The vertices that Insert()
  /// added have the numbers that follow the last of these.
  std::vector<std::array<std::int32_t, 3>> GetTriangles() const;

private:
  bool Project(int patch, const lms3dVector& axis);
  lms3dPoint2 GetPoint(const lms3dVector& direction) const;
  void Append(const lms3dMapVertex& vertex);

  const lms3dPatchOutlines& Outlines;
  /// The numbers of the outline's vertices in the outlines, sorted.
  std::vector<std::int32_t> Numbers;
  std::vector<lms3dMapVertex> Vertices;
  std::vector<lms3dTriangleCorner> Corners;
  std::unique_ptr<lms3dTriangulation> Triangulation;
  /// To the right and up in the projection plane as the sensor sees it, and ahead along its normal.
  lms3dVector Axes[3];
  bool Valid;
};

#endif
