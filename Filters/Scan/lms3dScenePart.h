// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The cells of a scene, or of the part of it that one process has.
 */
#ifndef lms3dScenePart_h
#define lms3dScenePart_h

#include <cstdint>
#include <string>

struct lms3dScenePart
{
  /// The number of all cells, including those without a surface.
  std::int64_t NumberOfCells = 0;

  /// The number of cells with a surface that vtkGhostType marks as HIDDENCELL.
  std::int64_t HiddenCells = 0;

  /// Whether all cells have global ids.
  bool HasGlobalIds = false;

  /// The smallest and the largest global id. Used only if HasGlobalIds.
  std::int64_t MinimumGlobalId = 0;
  std::int64_t MaximumGlobalId = 0;

  /// Whether some of the cells are volume cells.
  bool HasVolume = false;
};

/// Returns a warning for the user if the global ids of a whole scene show that cells are missing:
/// ids go up to N, but there are fewer than N + 1 cells (fewer than N if no cell has the id 0,
/// because some file formats number from 1). Otherwise returns an empty string.
std::string lms3dDescribeMissingCells(const lms3dScenePart& scene);

/// Throws std::runtime_error, with a text for the user, if a whole scene has no triangles.
/// `skippedCells` is a text about cells that were skipped, empty if there are none.
void lms3dCheckScene(
  bool hasTriangles, const lms3dScenePart& scene, const std::string& skippedCells);

#endif
