// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Converts the surfaces of a VTK data object to the triangles of a scene.
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

  /// The number of all cells of the scene, including cells without a surface.
  std::int64_t NumberOfCells = 0;

  /// Whether Mesh.Cells are the global cell ids of the scene. They increase then, so that the
  /// triangles have the same order if the cells come in another order or in parts.
  bool HasGlobalIds = false;

  /// The smallest and the largest global id of all cells of the scene. Set only if HasGlobalIds.
  std::int64_t MinimumGlobalId = 0;
  std::int64_t MaximumGlobalId = 0;

  /// Whether the scene has volume cells, whose outer surface is in the mesh.
  bool HasVolume = false;

  /// The number of cells that were skipped because a coordinate is not finite or exceeds 1e18 m.
  std::int64_t SkippedCells = 0;

  /// The number of polygons that cross themselves or take too much work. Their triangles are in the
  /// mesh, but can overlap or extend beyond the polygon.
  std::int64_t CrossedCells = 0;

  /// The number of the first of these cells, -1 without any.
  std::int64_t FirstCrossedCell = -1;

  /// The number of polygons and strips that were skipped because vtkGhostType marks them as
  /// HIDDENCELL.
  std::int64_t HiddenCells = 0;

  /// False if `progress` stopped the work. Everything else is then empty.
  bool IsComplete = true;
};

/**
 * Converts all polygons and triangle strips of a vtkPolyData, the outer surface of any other data
 * set, or the surfaces of all leaves of a composite. The cells of a composite are numbered
 * consecutively over all leaves, unless all of them have global ids. Vertices, lines and polygons
 * without area have no surface and are ignored. Cells that vtkGhostType marks as HIDDENCELL are
 * skipped; all other ghost cells and ghost points of a vtkPolyData count as the scene's own.
 * (vtkDataSetSurfaceFilter treats other data sets in the same way, and also hides cells of
 * structured grids at HIDDENPOINTs.)
 *
 * `name` begins the texts for the user. `progress` receives the fraction done, 0 to 1, and returns
 * false to stop. It is called by the calling thread, also within a large polygon.
 *
 * Throws std::runtime_error, with a text for the user, if a cell uses a missing point or if there
 * are too many triangles.
 */
lms3dSceneTriangles lms3dCollectTriangles(
  vtkDataObject* scene, const std::string& name = "The scene",
  const std::function<bool(double)>& progress = [](double) { return true; });

/// Returns a text for the user about the skipped and crossed cells of `name`, for example "The
/// scene". Returns an empty string if there are none.
std::string lms3dDescribeSkippedCells(
  const lms3dSceneTriangles& triangles, const std::string& name);

#endif
