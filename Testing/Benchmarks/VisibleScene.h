// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How many triangles the part of a scene needs that beams hit.
 */
#ifndef VisibleScene_h
#define VisibleScene_h

#include <vtkPolyData.h>
#include <vtkType.h>

#include <array>
#include <vector>

/**
 * Triangles of the scene that were hit are joined if they share an edge and lie in one plane. A
 * polygon with v corners and h holes counts as v + 2 h - 2 triangles. A triangle that was hit once
 * counts wholly, so what its neighbours hide does not add corners.
 */
class VisibleScene
{
public:
  /// The cells of the scene must be triangles.
  explicit VisibleScene(vtkPolyData* scene);

  /// Adds the triangles that the beams of a scan hit.
  void Add(vtkPolyData* scan);

  vtkIdType CountTriangles() const;

private:
  using Corners = std::array<int, 3>;

  bool AreInOnePlane(int a, int b) const;
  std::vector<int> FindPolygons() const;
  vtkIdType CountTrianglesOf(const std::vector<int>& polygon) const;
  bool IsStraight(int before, int at, int after) const;

  /// Points at one place are one.
  std::vector<std::array<double, 3>> Points;
  std::vector<Corners> Triangles;
  std::vector<bool> IsHit;
};

#endif
