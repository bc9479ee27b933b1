// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The normals of the plain grid's vertices.
 */
#ifndef lms3dGridNormals_h
#define lms3dGridNormals_h

#include "LocalMap/Grid/lms3dGridMesher.h"
#include "LocalMap/Grid/lms3dGridPoints.h"

#include <array>

/**
 * Writes three components for each vertex of the grid: the mean of its triangles' normals, weighted
 * by their areas, of length 1; the direction to the sensor where it has no triangle. Sums go over
 * a turn's triangles and never from thread to thread, so that they are the same for any number of
 * threads. Uses those of the calling TBB arena.
 */
void lms3dFillNormals(const lms3dRangeGrid& grid, const lms3dGridMesher& mesher,
  const lms3dGridPoints& points, const std::array<double, 3>& sensor, float* normals);

#endif
