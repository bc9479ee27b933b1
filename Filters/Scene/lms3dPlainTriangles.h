// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Copies polygons that are all triangles, which most large surfaces have, on all threads.
 */
#ifndef lms3dPlainTriangles_h
#define lms3dPlainTriangles_h

#include "Geometry/lms3dTriangleMesh.h"

#include <array>
#include <cmath>
#include <cstddef>

class vtkCellArray;

/// Returns whether all coordinates are finite and at most 1e18 m. Sums of squares of larger ones
/// exceed the range of single precision.
inline bool lms3dIsUsable(const std::array<double, 3>& point)
{
  constexpr double Maximum = 1e18;
  return std::abs(point[0]) <= Maximum && std::abs(point[1]) <= Maximum &&
    std::abs(point[2]) <= Maximum;
}

/**
 * Appends `cells` to the triangles of `mesh`, but not to its cells. Point i of `cells` is point
 * `firstPoint` + i of the mesh.
 *
 * Returns false, and leaves the mesh as it was, if a cell is not a triangle, uses a missing point
 * or one that is not usable, or if there are more triangles than 31 bits can number. The same holds
 * if offsets and points of the cells are not stored in arrays of 32 or of 64 bits.
 */
bool lms3dAppendPlainTriangles(
  vtkCellArray* cells, std::size_t firstPoint, lms3dTriangleMesh& mesh);

#endif
