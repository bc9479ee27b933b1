// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Gives a mesh the points that it has of a longer list.
 */
#ifndef lms3dUsedPoints_h
#define lms3dUsedPoints_h

#include "lms3dScene.h"

#include <vector>

/// The triangles are indices into the coordinates, x y z of each point, and become indices into the
/// mesh's own points: those that a triangle has, since many shapes may share one Coordinate node.
void lms3dTakeUsedPoints(const std::vector<double>& coordinates, lms3dMesh& mesh);

#endif
