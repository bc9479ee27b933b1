// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Turns the surfaces of a VTK data object into the triangles that are cast against.
 */
#ifndef lms3dSceneTriangles_h
#define lms3dSceneTriangles_h

#include "Geometry/lms3dTriangleMesh.h"

#include <cstdint>
#include <functional>
#include <string>

class vtkDataObject;

struct lms3dSceneTriangles
{
  lms3dTriangleMesh Mesh;

  /// All of the scene, also those without a surface.
  std::int64_t NumberOfCells = 0;

  /// Whether Mesh.Cells are the scene's global cell ids, in increasing order, so that triangles
  /// that come in another order, or in parts, are still numbered in the same order.
  bool HasGlobalIds = false;

  /// The smallest and the largest global id of all cells of the scene. Set only if HasGlobalIds.
  std::int64_t MinimumGlobalId = 0;
  std::int64_t MaximumGlobalId = 0;

  /// Whether some of it is the outer surface of volume cells.
  bool HasVolume = false;

  /// Cells that were left out because one of their points is not finite, or beyond 1e18 m.
  std::int64_t SkippedCells = 0;

  /// Polygons that were left out because they cross themselves.
  std::int64_t CrossedCells = 0;

  /// The number of polygons and strips that were skipped because vtkGhostType marks them as
  /// HIDDENCELL.
  std::int64_t HiddenCells = 0;

  /// False if `progress` stopped the work. Everything else is then empty.
  bool IsComplete = true;
};

/**
 * Takes all polygons and triangle strips of a vtkPolyData, the outer surface of any other data set,
 * or those of all leaves of a composite. The cells of a composite are numbered through, leaf after
 * leaf, unless all of them have global ids. Vertices, lines and polygons without area have no
 * surface and are passed over. Cells that vtkGhostType marks as HIDDENCELL are skipped; all other
 * ghost cells and ghost points of a vtkPolyData count as the scene's own. (vtkDataSetSurfaceFilter
 * treats other data sets in the same way, and also hides cells of structured grids at
 * HIDDENPOINTs.)
 *
 * Throws std::runtime_error, with words for the user, where a cell uses a point that is not there,
 * or where there are too many triangles.
 */
lms3dSceneTriangles lms3dCollectTriangles(
  vtkDataObject* scene, const std::function<bool(double)>& progress = [](double) { return true; });

/// Words for the user on the cells of "The scene", or whatever it is, that were left out; empty
/// where all were taken.
std::string lms3dDescribeSkippedCells(
  const lms3dSceneTriangles& triangles, const std::string& what);

#endif
