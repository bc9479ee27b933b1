// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The reflectance of a scene's triangles, from a cell array.
 */
#ifndef lms3dSceneReflectance_h
#define lms3dSceneReflectance_h

#include "Geometry/lms3dTriangleMesh.h"

#include <string>
#include <vector>

class vtkDataObject;

/**
 * Returns the reflectance of each triangle of a scene's mesh, from the cell array `name`. One
 * component of any number type is the reflectance itself. Three or four components of unsigned char
 * are a colour: its reflectance is the luminance of red, green and blue, from 0 to 1.
 * `hasGlobalIds` says whether the cells of the mesh are global ids.
 *
 * Only cells with triangles count. Throws std::runtime_error, with a text for the user, if one of
 * them has no such array, or if its reflectance is negative or not finite.
 */
std::vector<double> lms3dGetReflectances(
  vtkDataObject* scene, const std::string& name, bool hasGlobalIds, const lms3dTriangleMesh& mesh);

#endif
