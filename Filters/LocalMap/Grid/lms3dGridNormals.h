// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The normals of the plain grid's vertices.
 */
#ifndef lms3dGridNormals_h
#define lms3dGridNormals_h

#include "Geometry/lms3dVector.h"
#include "LocalMap/Grid/lms3dGridMesher.h"
#include "LocalMap/Grid/lms3dGridPoints.h"

/**
 * Writes the unit normal of each vertex of the grid, three components each: the mean of its
 * triangles' normals, weighted by area, or the direction to the sensor if the vertex has no
 * triangle. `points` and `sensor` are in one frame, metres. Uses the threads of the calling TBB
 * arena; each sum runs over a vertex's triangles in a fixed order, so the result is the same for
 * any number of threads.
 */
void lms3dFillNormals(const lms3dRangeGrid& grid, const lms3dGridMesher& mesher,
  const lms3dGridPoints& points, const lms3dVector& sensor, float* normals);

#endif
