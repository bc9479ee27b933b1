// SPDX-FileCopyrightText: Copyright (c) 2026, the LMS3D developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief Converts the shapes of a scene to one vtkPolyData.
 */
#ifndef lms3dSceneOutput_h
#define lms3dSceneOutput_h

#include "Model/lms3dScene.h"

class vtkPolyData;

/// Returns whether any shape has a triangle.
bool lms3dHasSurface(const lms3dScene& scene);

/// Writes points (double, world coordinates), triangles, and the arrays that vtkVRMLImporterSource
/// documents to `surface`, which must be empty. If `turnYUp`, rotates the scene from y up to z up.
void lms3dWriteScene(const lms3dScene& scene, bool turnYUp, vtkPolyData* surface);

#endif
