// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Copies the points of a mesh out of a longer list.
 */
#ifndef lms3dUsedPoints_h
#define lms3dUsedPoints_h

#include "Model/lms3dScene.h"

#include <vector>

/// Copies the points that the triangles use to mesh.Points. Many shapes can share one Coordinate
/// node, and each uses a few of its points. On entry, mesh.Points is empty and the triangles are
/// indices into `coordinates` (x, y, z of each point). On return, they are indices into
/// mesh.Points.
void lms3dCopyUsedPoints(const std::vector<double>& coordinates, lms3dMesh& mesh);

#endif
